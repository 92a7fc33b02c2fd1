// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/checks/sliding_combinations.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

/// Rigid motions that slide along all of the contact, as a round pin without friction turns in
/// its bore. Nothing resists them but the noise of coordinates, by which contact directions
/// are not quite across them, and nothing drives them but that of loads. Neither means
/// anything, and a body would turn until the two balance: directions are turned across such
/// motions, and loads balanced along them.
namespace ffcontact {

/// Unheld motions that slide [dofs x k]; none where loads drive one of them.
/// @param law  of nodal forces
template <int dim, class Nodes, class Law>
MatrixXd sliding_motions(const SimplexMesh<dim>& mesh, const Nodes& nodes,
                         const Law& law, const ElasticSystem& system) {
  const MatrixXd motions = unheld_motions(mesh, system);
  if (motions.cols() == 0) return motions;
  const MatrixXd sliding =
      motions * sliding_combinations(traces_of(nodes, motions),
                                     extreme_forces(nodes, law, motions));
  return is_noise(system.load, sliding) ? sliding : MatrixXd(sliding.rows(), 0);
}

/// Turns contact directions across sliding motions.
/// @return by how much at most [rad]
template <class Nodes>
double turn_across(const MatrixXd& sliding, Nodes& nodes) {
  constexpr int dim = decltype(nodes.normal)::RowsAtCompileTime;
  const MatrixXd traces = traces_of(nodes, sliding);
  double most = 0;
  for (int i = 0; i < nodes.node_count(); ++i) {
    const VectorOf<dim> turned =
        nodes.frame(i) *
        first_axis_across(traces.template middleRows<dim>(dim * i));
    most = std::max(most, (turned - nodes.normal.col(i)).norm());
    nodes.normal.col(i) = turned;
  }
  return most;
}

/// Coefficients c of motions z for which the field sum c z, lumped as a mass of 1 in a
/// volume of 1, does the same work on them as a force r:
///     (sum over v of m_v z_v' z_v) c = z' r.
template <int dim>
VectorXd lumped_coefficients(const SimplexMesh<dim>& mesh,
                             const MatrixXd& motions, const VectorXd& r);

/// Body force that balances loads along sliding motions, linear in each cell, by its values
/// at the vertices [MPa/mm, dofs]; empty where they are balanced to rounding.
template <int dim>
VectorXd holding_force(const SimplexMesh<dim>& mesh, const MatrixXd& sliding,
                       const VectorXd& load);

/// Its lumped loads int f phi at the vertices of each cell [dim (dim + 1) x cells].
template <int dim>
Matrix<double, dim*(dim + 1), Dynamic> lumped_loads(
    const SimplexMesh<dim>& mesh, const VectorXd& force);

/// Of cells, on all dofs.
template <int dim>
VectorXd sum_at_vertices(
    const SimplexMesh<dim>& mesh,
    const Matrix<double, dim*(dim + 1), Dynamic>& loads_of_cells);

}  // namespace ffcontact
