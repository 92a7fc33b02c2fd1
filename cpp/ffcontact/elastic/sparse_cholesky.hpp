// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// The pairs of neighbours of a graph, each once, by the lower one of the two numbers:
/// vertex v has neighbours[start[v] .. start[v + 1]).
struct Graph {
  std::vector<int> start{0}, neighbours;

  int vertex_count() const { return static_cast<int>(start.size()) - 1; }
};

/// The vertices in an order of elimination with little fill: METIS's nested dissection.
std::vector<int> dissection_order(const Graph& graph);

/// A = L L' of a sparse symmetric matrix, eliminated in its own order: CHOLMOD's
/// supernodal factor.
class SparseCholesky {
 public:
  /// @param upper  the upper triangle of A, rows of a column in any order
  explicit SparseCholesky(const SparseMatrix& upper);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  int size() const;
  /// (min L_ii / max L_ii)^2, 0 where A is not positive definite.
  double reciprocal_condition() const;
  /// The last rows and columns of L.
  MatrixXd trailing_block(int size) const;

  VectorXd half_solve(const VectorXd& b) const;        ///< L^-1 b
  VectorXd other_half_solve(const VectorXd& b) const;  ///< L'^-1 b

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace ffcontact
