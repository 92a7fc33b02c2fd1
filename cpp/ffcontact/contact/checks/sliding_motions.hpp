// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/appended.hpp"
#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/checks/line_balance.hpp"
#include "ffcontact/contact/checks/sliding_combinations.hpp"
#include "ffcontact/contact/checks/surface_balance.hpp"
#include "ffcontact/elastic/body_loads.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

/// Rigid motions that slide along all of the contact, as a round pin without friction turns in
/// its bore. Nothing resists them but the noise of coordinates, by which contact directions
/// are not quite across them, and nothing drives them but that of loads. Neither means
/// anything, and a body would turn until the two balance: directions are turned across such
/// motions, and loads balanced along them.
namespace ffcontact {

/// Unheld rigid motions [dofs x k].
struct RigidMotions {
  MatrixXd sliding;  ///< that loads drive by no more than noise
  MatrixXd others;   ///< which contact holds, or nothing

  bool none() const { return sliding.cols() + others.cols() == 0; }
  MatrixXd all() const {
    MatrixXd both = sliding;
    append(others, both);
    return both;
  }
};

template <int dim, class Nodes, class Law>
RigidMotions rigid_motions(const SimplexMesh<dim>& mesh, const Nodes& nodes,
                           const Law& law, const ElasticSystem& system) {
  const MatrixXd all = unheld_motions(mesh, system);
  if (all.cols() == 0) return {all, all};
  const auto [sliding, others] = sliding_combinations(
      traces_of(nodes, all), extreme_forces(nodes, as_rough(law), all));
  if (!is_noise(system.load, all * sliding))
    return {MatrixXd(all.rows(), 0), all};
  return {all * sliding, all * others};
}

/// Turns contact directions across sliding motions.
/// @return by how much at most [rad]
template <class Nodes>
double turn_across(const MatrixXd& sliding, Nodes& nodes) {
  constexpr int dim = decltype(nodes.normal)::RowsAtCompileTime;
  const MatrixXd traces = traces_of(nodes, sliding);
  const auto before = nodes.normal;
  for (int i = 0; i < nodes.node_count(); ++i)
    nodes.normal.col(i) =
        nodes.frame(i) * first_axis_across(traces.middleRows(dim * i, dim));
  return (nodes.normal - before).colwise().norm().maxCoeff();
}

/// The body force, a combination of sliding motions, that balances loads along them; no
/// columns where they are balanced to rounding.
template <int dim>
BodyLoadsOfCells<dim> holding_loads(const SimplexMesh<dim>& mesh,
                                    const MatrixXd& sliding,
                                    const VectorXd& load);

}  // namespace ffcontact
