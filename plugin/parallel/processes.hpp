// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/factor/precision.hpp"
#include "ffcontact/parallel/messages.hpp"

namespace ffcontact::plugin {

/// A part of a symmetric matrix: the sum of those of all processes has these entries.
/// Rows and columns of the whole in the order of elimination, the kept ones last; one
/// triangle.
struct MatrixPart {
  std::vector<int> row, column;
  std::vector<double> value;
};

/// A factor of a positive definite matrix that all processes hold together, stopped
/// before its last rows. Everything is done by all at the same time.
class SharedFactor {
 public:
  virtual ~SharedFactor() = default;

  /// Schur's complement of the kept rows [kept x kept] on process 0; nothing elsewhere.
  virtual MatrixXd take_schur() = 0;
  /// g = b_c - K_ci K_ii^-1 b_i of a load that process 0 gives [kept].
  virtual VectorXd condensed(const VectorXd& load) = 0;
  /// x with these x_c that balances the last load on the other rows, on process 0.
  virtual VectorXd extended(const VectorXd& kept) = 0;
};

/// Processes that solve one problem together.
class Processes : public Messages {
 public:
  /// @param rows  of the whole matrix, and how many of them are kept
  /// @throws std::runtime_error  on all processes, if the matrix is not positive definite
  ///                             or memory is missing on one
  virtual std::unique_ptr<SharedFactor> factorised(
      MatrixPart part, int rows, int kept, Precision precision) const = 0;
};

/// Makes processes of a script's communicator (mpiCommWorld).
using MakeProcesses = std::unique_ptr<Processes> (*)(void* communicator);

}  // namespace ffcontact::plugin

/// Called by the module ffcontact_mpi when a script loads it.
extern "C" __attribute__((visibility("default"))) void ffcontact_use_processes(
    ffcontact::plugin::MakeProcesses make);
