// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ffcontact/base/require.hpp"
#include "ffcontact/parallel/shared_relaxation.hpp"
//
#include "freefem/guard.hpp"
#include "parallel/packet.hpp"
#include "parallel/processes.hpp"

namespace ffcontact::plugin {

/// The rows and columns that a factor has of this process's dofs, and their scale.
struct FactorOrder {
  int rows, kept;
  Precision precision;
  std::vector<int> place;  ///< of each dof; -1: it has none
  VectorXd scale;
};

/// What a process does for process 0 in a call.
struct Service {
  std::function<VectorXd(Packet& places)>
      values;  ///< null: there are no expressions
  std::function<MatrixPart(const FactorOrder& order)> matrix;  ///< null: none
};

/// Processes in the calls of one script: process 0 holds the problem and leads, the others
/// hold parts of the mesh, the matrix and its factor, and follow.
class Team {
 public:
  explicit Team(std::unique_ptr<Processes> processes)
      : processes_(std::move(processes)) {}

  int rank() const { return processes_->rank(); }
  int count() const { return processes_->count(); }
  bool leads() const { return rank() == 0; }

  /// @name Of process 0
  /// @{
  /// What all of them give, the others by answer().
  /// @throws std::runtime_error  with what one of them fails by
  std::vector<Packet> gathered(Packet own) const;
  VectorXd values_of(int rank, const Packet& places) const;
  /// Ends the others' part in the call.
  void release(int rank, const Packet& results) const;
  /// @param orders  of each process
  /// @param own     the part of process 0
  /// @return the factor's number, and Schur's complement
  /// @throws std::runtime_error  as Processes::factorised
  std::pair<long, MatrixXd> factorise(
      const std::vector<FactorOrder>& orders,
      const std::function<MatrixPart(const FactorOrder&)>& own);
  VectorXd condensed(long factor, const VectorXd& load) const;
  VectorXd extended(long factor, const VectorXd& kept) const;
  /// It goes when the next one is made.
  void discard(long factor) noexcept;
  /// relax_facets by all.
  /// @param owner  of each tetrahedron
  /// @throws std::runtime_error  if one of them has no memory for its part
  std::vector<double> relaxed(const FacetSetting<3>& setting,
                              const RelaxationSettings& settings,
                              std::vector<int> owner,
                              FaceMoments& moments) const;
  /// Ends the others' part in a call that fails.
  void fail_all(const std::string& sentence) const;
  /// @}

  /// @name Of the others
  /// @{
  void answer(const Packet& packet) const;
  /// Does what process 0 asks for. @return what it releases this process with
  /// @throws std::runtime_error  with the sentence, if the call fails elsewhere
  Packet served(const Service& service);
  /// Says that this process fails, and waits until all know.
  void fail(const std::string& sentence) const;
  /// @}

 private:
  enum class Word : char {
    values,
    prepare,
    factorise,
    condense,
    extend,
    share,
    relax,
    done,
    failed
  };
  void tell(int rank, Word word, const Packet& packet = {}) const;
  void tell_all(Word word, const Packet& packet = {}) const;
  Packet answer_of(int rank) const;
  /// Until it has done its part, whatever it still says.
  void wait_for(int rank) const;
  void make(long number, MatrixPart part, const FactorOrder& order);
  void forget(const std::vector<long>& factors);
  SharedFactor& factor_of(long number) const;

  std::unique_ptr<Processes> processes_;
  std::map<long, std::unique_ptr<SharedFactor>> factors_;
  std::vector<long> discarded_;
  long last_ = 0;
};

/// The call failed on another process, and all know.
struct FailedElsewhere : Failure {
  using Failure::Failure;
};

/// A call that process 0 leads and the others follow; what one of them throws all throw.
template <class Lead, class Follow>
void together(Team& team, Lead&& lead, Follow&& follow) {
  try {
    if (team.leads())
      lead();
    else
      follow();
  } catch (const FailedElsewhere&) {
    throw;
  } catch (const std::exception& error) {
    if (team.leads())
      team.fail_all(sentence_for_script(error));
    else
      team.fail(sentence_for_script(error));
    throw;
  }
}

/// What the module ffcontact_mpi makes processes with.
void use_processes(MakeProcesses make);

/// @throws std::invalid_argument  if that module is not loaded
std::shared_ptr<Team> team_of(void* communicator);

}  // namespace ffcontact::plugin
