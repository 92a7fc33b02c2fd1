// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/elastic/multigrid/grid_level.hpp"

namespace ffcontact {

/// Directions that the unknowns y of some vertices stand for, u = T y: a column of T is 0
/// where an unknown stands for nothing and is held. Those of the others are the axes.
template <int dim>
class VertexFrames {
 public:
  explicit VertexFrames(const ElasticSystem& system);

  void put(int vertex, const MatrixOf<dim>& T);
  /// T, with columns of 0 at prescribed dofs.
  const MatrixOf<dim>& of(int vertex) const { return T_[vertex]; }
  /// T y and T' f of all vertices.
  VectorXd displacement(const VectorXd& y) const;
  VectorXd components(const VectorXd& forces) const;

 private:
  int count() const { return static_cast<int>(T_.size()); }
  std::vector<MatrixOf<dim>> T_;
};

/// T' K T in single precision, and the rigid motions in y.
template <int dim>
Grid<dim, dim> body_grid(const ElasticSystem& system,
                         const Matrix<double, dim, Dynamic>& vertices,
                         const VertexFrames<dim>& frames);

/// How rigid motions move the y of a vertex, of the unknowns with a direction.
template <int dim>
SingleBlock<dim, NodeMotions<dim, dim>::count> motions_along(
    const MatrixOf<dim>& T);

}  // namespace ffcontact
