// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// What the stresses of a finite element solution lack to be in equilibrium with the
/// loads, vertex by vertex:
///     missing_i = sum over the star of (int f phi_i - |T| sigma grad phi_i) + moments at i of the known boundary tractions.
/// It is 0 where u_h was computed with these loads. Where a support answers, on a
/// component that a boundary facet at the vertex leaves free, nothing is missing. Forces
/// are [N/mm] in the plane, [N] in space.
template <int d>
struct NodalResidual {
  Matrix<double, d, Dynamic> missing;        ///< per vertex
  Eigen::Array<bool, d, Dynamic> supported;  ///< where a support answers
  double scale;                              ///< largest term
};

/// @param stress      per cell
/// @param body_loads  int_T f phi_i at the vertices of each cell
template <int d>
NodalResidual<d> nodal_residual(const Topology<d>& topology,
                                const CellStresses<d>& stress,
                                const BodyLoadsOfCells<d>& body_loads,
                                const FacetTractions<d>& boundary);

/// The same with forces on the vertices beside the boundary tractions.
/// @param forces  on all dofs
template <int d>
NodalResidual<d> with_forces(NodalResidual<d> residual, const VectorXd& forces);

/// The same when a stress is added.
/// @param added  per cell
template <int d>
NodalResidual<d> less_stress(const Topology<d>& topology,
                             NodalResidual<d> residual,
                             const CellStresses<d>& added);

/// |T| sigma grad phi_i - int_T f phi_i on each cell of the star of vertex i, in its order.
template <int d>
Matrix<double, d, Dynamic> star_loads(const Topology<d>& topology, int vertex,
                                      const CellStresses<d>& stress,
                                      const BodyLoadsOfCells<d>& body_loads);

/// Given tractions that do not balance the stresses at a vertex.
struct Imbalance : Refusal {
  Imbalance(const std::string& sentence, int vertex, int component)
      : Refusal(sentence), vertex(vertex), component(component) {}
  int vertex, component;
};

/// Loads and stresses that differ by more than this part of the largest moment were not
/// computed from each other.
constexpr double unbalanced = 1e-6;

/// @param least_scale  moments below this are rounding: what is left over is judged
///                     against the largest moment, or this
/// @throws Imbalance  if the given tractions do not balance the stresses at a vertex
///                    (other loads than those u_h was computed with, or a point support
///                    with a reaction), naming the vertex
template <int d>
void require_balanced(const SimplexMesh<d>& mesh,
                      const NodalResidual<d>& residual,
                      double least_scale = 0) {
  Index component, vertex;
  const double worst =
      residual.missing.cwiseAbs().maxCoeff(&component, &vertex);
  if (worst <= unbalanced * std::max(least_scale, residual.scale)) return;
  const int v = static_cast<int>(vertex);
  const std::string unit = d == 2 ? " N/mm" : " N";
  throw Imbalance("the loads do not balance the stresses at vertex " +
                      std::to_string(v) + " " + in_words(mesh.place(v)) + ": " +
                      in_digits(worst, digits_of_refusals) + unit +
                      " are left over",
                  v, static_cast<int>(component));
}

}  // namespace ffcontact
