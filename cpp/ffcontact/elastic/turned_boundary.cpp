// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/turned_boundary.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/boundary_vertices.hpp"

namespace ffcontact {

namespace {

/// Forces on a dof of unit rigid motions about its vertex, and what they add up.
template <int dim>
struct RowForces {
  VectorOf<dim> of_translations = VectorOf<dim>::Zero();
  Matrix<double, 1, motion_count<dim> - dim> of_rotations;
  double terms = 0, terms_by_distance = 0;

  RowForces(const SimplexMesh<dim>& mesh, const RowMatrix& K, Index dof) {
    of_rotations.setZero();
    for (RowMatrix::InnerIterator a(K, dof); a; ++a)
      add(a.value(), a.col() % dim,
          mesh.vertices.col(a.col() / dim) - mesh.vertices.col(dof / dim));
  }

  /// @param r  of the vertex whose component has this stiffness
  void add(double stiffness, Index component, const VectorOf<dim>& r) {
    of_translations[component] += stiffness;
    of_rotations += stiffness * rotations<dim>(r).row(component);
    terms += std::abs(stiffness);
    terms_by_distance += std::abs(stiffness) * r.norm();
  }
};

enum class Answer { none, follows, resists };

template <int dim>
Answer answer_of(const RowForces<dim>& forces) {
  constexpr double rounding = 1e-8, large = 0.005;
  if (max_norm(forces.of_translations) > rounding * forces.terms)
    return Answer::none;
  return max_norm(forces.of_rotations) > large * forces.terms_by_distance
             ? Answer::resists
             : Answer::follows;
}

/// Of one vertex.
template <int dim>
Answer answer_of(const SimplexMesh<dim>& mesh, const ElasticSystem& system,
                 int vertex) {
  if (free_axes<dim>(vertex, system.prescribed).cols() < dim)
    return Answer::none;
  Answer answer = Answer::follows;
  for (int c = 0; c < dim; ++c) {
    const Answer of_row =
        answer_of(RowForces<dim>(mesh, system.stiffness, dim * vertex + c));
    if (of_row == Answer::none) return of_row;
    answer = std::max(answer, of_row);
  }
  return answer;
}

}  // namespace

template <int dim>
double share_resisting_rotation(const SimplexMesh<dim>& mesh,
                                const ElasticSystem& system, int first,
                                int end) {
  const Flags on_boundary = boundary_vertices(mesh);
  int asked = 0, resisting = 0;
  for (int v = first; v < end; ++v) {
    if (!on_boundary[v]) continue;
    const Answer answer = answer_of(mesh, system, v);
    asked += answer != Answer::none;
    resisting += answer == Answer::resists;
  }
  return asked > 0 ? static_cast<double>(resisting) / asked : 0;
}

template double share_resisting_rotation(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const ElasticSystem&, int, int);

}  // namespace ffcontact
