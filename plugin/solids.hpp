// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "ffcontact/sizing/optimal_size.hpp"
//
#include "estimate/contact_error.hpp"
#include "gmsh/gmsh_reader.hpp"
#include "parallel/processes.hpp"
#include "problem/contact_type.hpp"
#include "solve/solve_call.hpp"

namespace ffcontact::plugin {

struct BoundsCall;

/// The value of contact(Th, ...), for an assignment: null is what there is not.
struct ContactStatement {
  std::shared_ptr<ContactProblem<2>> plane;
  std::shared_ptr<ContactProblem<3>> solid;
  std::shared_ptr<SharedContact> shared;
};

/// contacterror of plane bodies, with what is to read their data.
using JudgePlane = std::function<double(const ReadBodies<2>& read)>;

/// What the module ffcontact_solids does: contacts of a mesh3, and those that processes
/// share. A script of plane bodies on one process runs without it. What the plane bodies
/// of a contact need is in both modules, and has no state.
class Solids {
 public:
  virtual ~Solids() = default;

  virtual ContactStatement stated(Stack stack, const NamedArguments& named,
                                  const std::vector<pmesh3>& meshes) const = 0;
  /// With comm=.
  virtual ContactStatement stated(Stack stack, const NamedArguments& named,
                                  const std::vector<pmesh>& meshes) const = 0;

  /// contactsolve; returns the iterations.
  virtual long solve(const SolveCall& call, Contact& contact) const = 0;

  /// contacterror; returns eps.
  /// @param judge  for plane bodies
  virtual double error(Stack stack, const NamedArguments& named,
                       Contact& contact, const JudgePlane& judge) const = 0;

  /// contactbounds; returns the relative width.
  virtual double bounds(const BoundsCall& call,
                        const ContactOf<3>& contact) const = 0;

  /// optimalsize.
  /// @param arrays  eps_E and q_E of all cells
  virtual OptimalSize sizes(const ContactProblem<3>& problem,
                            const std::vector<VectorXd>& arrays,
                            const SizeSettings& settings) const = 0;
  /// Where processes share the bodies: as sizes_shared.
  virtual double sizes_of_parts(
      Stack stack, const NamedArguments& named, SharedContact& contact,
      const std::vector<VectorXd>& arrays,
      const std::function<double(const std::vector<VectorXd>& whole)>& sizes)
      const = 0;

  /// contactpicture.
  virtual void draw(const std::filesystem::path& folder, long step,
                    const ContactOf<3>& contact) const = 0;

  /// meshquality [tetrahedra].
  virtual VectorXd quality(pmesh3 mesh) const = 0;
  virtual VectorXd mean_edges(pmesh3 mesh) const = 0;

  /// contactmesh.
  /// @param corner  [rad]
  virtual pmesh3 remeshed(Stack stack, pmesh3 mesh,
                          const Ref<const VectorXd>& size,
                          double corner) const = 0;

  /// gmshmesh3.
  virtual GmshMesh<3> gmsh_solid(const std::filesystem::path& file) const = 0;

  virtual void use_processes(MakeProcesses make) const = 0;
};

/// Loads the module when it is first asked for.
/// @throws std::invalid_argument  if it is not beside ffcontact.so
const Solids& solids();

}  // namespace ffcontact::plugin

/// Of the module.
extern "C" __attribute__((visibility("default")))
const ffcontact::plugin::Solids*
ffcontact_solids();
