// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/base/cholesky.hpp"
#include "ffcontact/equilibrium/star_energy.hpp"

namespace ffcontact {

/// The additive Schwarz preconditioner of the stars,
///     z = sum_i Z_i (Z_i' K Z_i)^-1 Z_i' r,
/// K the energy of an Airy function (AiryEnergy) and Z_i the corrections of the star of
/// vertex i: its unknowns, or, on the boundary, those that leave all known tractions
/// alone. The factors of inner stars are kept as L D L' with L in single precision, which
/// steers the descent and nothing else.
class StarSolves {
 public:
  /// @param setting  stays where it is
  explicit StarSolves(const StarSetting& setting);

  /// @param r  on all unknowns of AirySpace, as z
  /// @return the same digits for every number of threads
  VectorXd operator()(const VectorXd& r) const;

 private:
  /// Of a boundary vertex.
  struct BoundaryStar {
    MatrixXd Z;  ///< [unknowns x n]
    Cholesky energy;
  };

  void factorise(int vertex);
  void factorise_on_boundary(int vertex);
  void solve(int vertex, double* y) const;
  /// (L D L')^-1 y, n unknowns.
  void solve_inside(int vertex, int n, double* y) const;

  /// Place of the first unknown of a star among those of all stars.
  Index first_unknown(int vertex) const {
    return 3 * static_cast<Index>(vertex) + setting_.stars.spoke_start[vertex];
  }

  const StarSetting& setting_;
  std::vector<Index> first_below_;  ///< of each vertex in below_
  std::unique_ptr<float[]> below_;  ///< L below its diagonal, by columns
  std::unique_ptr<double[]>
      inverse_pivot_;  ///< 1 / D; 0 where none is positive
  std::vector<std::unique_ptr<BoundaryStar>> on_boundary_;  ///< by vertex
};

}  // namespace ffcontact
