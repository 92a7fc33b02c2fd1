// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/body_grid.hpp"

#include <algorithm>

#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

/// Vertices whose dofs have an entry in the rows of a vertex.
template <int dim>
BlockPattern vertex_pattern(const RowMatrix& K) {
  const auto vertices = static_cast<int>(K.rows() / dim);
  BlockPattern pattern;
  std::vector<int> seen(vertices, -1);
  for (int v = 0; v < vertices; ++v) {
    seen[v] = v;
    pattern.column.push_back(v);
    for (int c = 0; c < dim; ++c)
      for (RowMatrix::InnerIterator e(K, dof_of<dim>(v, c)); e; ++e)
        if (const int w = static_cast<int>(e.col()) / dim; seen[w] != v) {
          seen[w] = v;
          pattern.column.push_back(w);
        }
    std::sort(pattern.column.begin() + pattern.first.back(),
              pattern.column.end());
    pattern.first.push_back(static_cast<int>(pattern.column.size()));
  }
  return pattern;
}

/// T_v' K_vw T_w in row v.
template <int dim>
void put_row(const RowMatrix& K, const VertexFrames<dim>& frames, int v,
             BlockRows<dim, dim>& A, std::vector<int>& place) {
  const int begin = A.pattern.begin(v), end = A.pattern.end(v);
  std::vector<MatrixOf<dim>> blocks(end - begin, MatrixOf<dim>::Zero());
  for (int k = begin; k < end; ++k) place[A.pattern.column[k]] = k - begin;
  for (int c = 0; c < dim; ++c)
    for (RowMatrix::InnerIterator e(K, dof_of<dim>(v, c)); e; ++e)
      blocks[place[e.col() / dim]](c, e.col() % dim) = e.value();
  for (int k = begin; k < end; ++k)
    A.value[k] = (frames.of(v).transpose() * blocks[k - begin] *
                  frames.of(A.pattern.column[k]))
                     .template cast<float>();
}

template <int dim, class OfVertex>
VectorXd by_vertices(int count, const OfVertex& of) {
  VectorXd values(dim * count);
#pragma omp parallel for
  for (int v = 0; v < count; ++v) vector_at<dim>(values, v) = of(v);
  return values;
}

}  // namespace

template <int dim>
VertexFrames<dim>::VertexFrames(const ElasticSystem& system)
    : T_(system.dof_count() / dim, MatrixOf<dim>::Identity()) {
  for (int dof = 0; dof < system.dof_count(); ++dof)
    if (system.prescribed[dof]) T_[dof / dim].col(dof % dim).setZero();
}

template <int dim>
void VertexFrames<dim>::put(int vertex, const MatrixOf<dim>& T) {
  T_[vertex] = T;
}

template <int dim>
VectorXd VertexFrames<dim>::displacement(const VectorXd& y) const {
  return by_vertices<dim>(count(), [&](int v) -> VectorOf<dim> {
    return T_[v] * vector_at<dim>(y, v);
  });
}

template <int dim>
VectorXd VertexFrames<dim>::components(const VectorXd& forces) const {
  return by_vertices<dim>(count(), [&](int v) -> VectorOf<dim> {
    return T_[v].transpose() * vector_at<dim>(forces, v);
  });
}

template <int dim>
SingleBlock<dim, NodeMotions<dim, dim>::count> motions_along(
    const MatrixOf<dim>& T) {
  auto motions = NodeMotions<dim, dim>().motions;
  motions.template leftCols<dim>() = T.transpose().template cast<float>();
  return motions;
}

template <int dim>
Grid<dim, dim> body_grid(const ElasticSystem& system,
                         const Matrix<double, dim, Dynamic>& vertices,
                         const VertexFrames<dim>& frames) {
  Grid<dim, dim> grid;
  grid.A.pattern = vertex_pattern<dim>(system.stiffness);
  grid.A.value.resize(grid.A.pattern.column.size());
  const int count = grid.A.rows();
  grid.motions.resize(count);
#pragma omp parallel
  {
    std::vector<int> place(count);
#pragma omp for
    for (int v = 0; v < count; ++v) {
      put_row(system.stiffness, frames, v, grid.A, place);
      grid.motions[v].centre = vertices.col(v);
      grid.motions[v].motions = motions_along<dim>(frames.of(v));
    }
  }
  return grid;
}

template class VertexFrames<3>;
template Grid<3, 3> body_grid(const ElasticSystem&, const Matrix3Xd&,
                              const VertexFrames<3>&);
template SingleBlock<3, 6> motions_along<3>(const Matrix3d&);

}  // namespace ffcontact
