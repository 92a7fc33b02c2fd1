// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// What the unknowns y of a body's vertices stand for:
///     u_i = T_i (y_i + sum_j B_ij y_j),
/// where the columns of T_i are directions, the axes unless others are put, and 0 where an
/// unknown stands for nothing and is held. The vertices j that a vertex follows, as one of a
/// contact surface follows what it faces, follow none themselves.
template <int dim>
class VertexFrames {
 public:
  explicit VertexFrames(const ElasticSystem& system);

  /// T_i
  void put(int vertex, const MatrixOf<dim>& T);
  /// B_ij
  void follow(int vertex, int followed, const MatrixOf<dim>& B);

  /// A vertex j with B_ij, or i with B_ij.
  struct Link {
    int vertex;
    MatrixOf<dim> B;
  };
  /// T, with columns of 0 at prescribed dofs.
  const MatrixOf<dim>& of(int vertex) const { return T_[vertex]; }
  const std::vector<Link>& followed_by(int vertex) const {
    return lists_[followed_[vertex]];
  }
  const std::vector<Link>& followers_of(int vertex) const {
    return lists_[followers_[vertex]];
  }
  bool has_followers() const { return lists_.size() > 1; }

  /// u, and the forces on y: B' T' f at a vertex that is followed, too.
  VectorXd displacement(const VectorXd& y) const;
  VectorXd components(const VectorXd& forces) const;

 private:
  int count() const { return static_cast<int>(T_.size()); }
  std::vector<Link>& list(int& place);

  std::vector<MatrixOf<dim>> T_;
  std::vector<std::vector<Link>> lists_;   ///< an empty one first
  std::vector<int> followed_, followers_;  ///< lists of each vertex
};

}  // namespace ffcontact
