// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/stress/composite_stress.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// What the stresses of a finite element solution lack to be in equilibrium with the
/// loads, vertex by vertex:
///     missing_i = sum over the star of (int f phi_i - |E| sigma grad phi_i) + moments at i of the known boundary tractions.
/// It is 0 where u_h was computed with these loads. Where a support answers, on a
/// component that a boundary edge of the star leaves free, nothing is missing.
struct NodalResidual {
  Matrix2Xd missing;                         ///< [N/mm, 2 x vertices]
  Eigen::Array<bool, 2, Dynamic> supported;  ///< where a support answers
  double scale;                              ///< largest term [N/mm]
};

/// @param stress      per triangle, Voigt [MPa]
/// @param body_loads  int_E f phi_i at the three vertices of each triangle [N/mm, 6 x
///                    triangles]
NodalResidual nodal_residual(const Topology& topology,
                             const Ref<const Matrix3Xd>& stress,
                             const BodyLoadsOfAll& body_loads,
                             const BoundaryTractions& boundary);

/// The same with forces on the vertices beside the boundary tractions.
/// @param forces  on all dofs [N/mm]
NodalResidual with_forces(NodalResidual residual, const VectorXd& forces);

/// The same when a stress is added.
/// @param added  per triangle, Voigt [MPa]
NodalResidual less_stress(const Topology& topology, NodalResidual residual,
                          const Ref<const Matrix3Xd>& added);

/// |E| sigma grad phi_i - int_E f phi_i on each triangle of the star of vertex i, in its
/// order [N/mm, 2 x triangles of the star].
Matrix2Xd star_loads(const Topology& topology, int vertex,
                     const Ref<const Matrix3Xd>& stress,
                     const BodyLoadsOfAll& body_loads);

/// The first and the last spoke of a star: those that bound it where its vertex is on
/// the boundary.
struct EndSpokes {
  int first, last;
};
EndSpokes end_spokes(const Stars& stars, int vertex);

/// The moment at a vertex of a spoke's traction, seen along vertex -> neighbour with the
/// normal to the right [N/mm].
Vector2d moment_at(const Edges& edges, const EdgeMoments& moments, int spoke,
                   int vertex);

/// Given tractions that do not balance the stresses at a vertex.
struct Imbalance : Refusal {
  Imbalance(const std::string& sentence, int vertex, int component)
      : Refusal(sentence), vertex(vertex), component(component) {}
  int vertex, component;
};

/// Loads and stresses that differ by more than this part of the largest moment were not
/// computed from each other.
constexpr double unbalanced = 1e-6;

/// @param residual     NodalResidual or SolidResidual
/// @param least_scale  moments below this are rounding: what is left over is judged
///                     against the largest moment, or this [N/mm, N]
/// @throws Imbalance  if the given tractions do not balance the stresses at a vertex
///                    (other loads than those u_h was computed with, or a point support
///                    with a reaction), naming the vertex
template <int dim, class Residual>
void require_balanced(const SimplexMesh<dim>& mesh, const Residual& residual,
                      double least_scale = 0) {
  Index component, vertex;
  const double worst =
      residual.missing.cwiseAbs().maxCoeff(&component, &vertex);
  if (worst <= unbalanced * std::max(least_scale, residual.scale)) return;
  const int v = static_cast<int>(vertex);
  const std::string unit = dim == 2 ? " N/mm" : " N";
  throw Imbalance("the loads do not balance the stresses at vertex " +
                      std::to_string(v) + " " + in_words(mesh.place(v)) + ": " +
                      in_digits(worst, digits_of_refusals) + unit +
                      " are left over",
                  v, static_cast<int>(component));
}

}  // namespace ffcontact
