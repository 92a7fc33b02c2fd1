// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/vertex_frames.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

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
    : T_(system.dof_count() / dim, MatrixOf<dim>::Identity()),
      lists_(1),
      followed_(T_.size(), 0),
      followers_(T_.size(), 0) {
  for (int dof = 0; dof < system.dof_count(); ++dof)
    if (system.prescribed[dof]) T_[dof / dim].col(dof % dim).setZero();
}

template <int dim>
void VertexFrames<dim>::put(int vertex, const MatrixOf<dim>& T) {
  T_[vertex] = T;
}

template <int dim>
std::vector<typename VertexFrames<dim>::Link>& VertexFrames<dim>::list(
    int& place) {
  if (place == 0) {
    place = count_of(lists_);
    lists_.emplace_back();
  }
  return lists_[place];
}

template <int dim>
void VertexFrames<dim>::follow(int vertex, int followed,
                               const MatrixOf<dim>& B) {
  list(followed_[vertex]).push_back({followed, B});
  list(followers_[followed]).push_back({vertex, B});
}

template <int dim>
VectorXd VertexFrames<dim>::displacement(const VectorXd& y) const {
  return by_vertices<dim>(count(), [&](int v) -> VectorOf<dim> {
    VectorOf<dim> moved = vector_at<dim>(y, v);
    for (const Link& link : followed_by(v))
      moved += link.B * vector_at<dim>(y, link.vertex);
    return T_[v] * moved;
  });
}

template <int dim>
VectorXd VertexFrames<dim>::components(const VectorXd& forces) const {
  const auto along = [&](int v) -> VectorOf<dim> {
    return T_[v].transpose() * vector_at<dim>(forces, v);
  };
  return by_vertices<dim>(count(), [&](int v) {
    VectorOf<dim> sum = along(v);
    for (const Link& link : followers_of(v))
      sum += link.B.transpose() * along(link.vertex);
    return sum;
  });
}

template class VertexFrames<3>;

}  // namespace ffcontact
