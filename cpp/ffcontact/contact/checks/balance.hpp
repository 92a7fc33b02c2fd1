// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/checks/unbalanced_motion.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// The rigid motions z that neither prescribed dofs nor the stiffness (springs, K z = 0
/// to rounding) hold, one column each.
template <int dim>
MatrixXd unheld_motions(const SimplexMesh<dim>& mesh,
                        const ElasticSystem& system);

/// What loads may miss of balance, relative to the sum of |b|.
constexpr double unbalanced_loads = 1e-9;

/// Can contact balance the loads on the unheld rigid motions z?
///
/// It can when admissible multipliers P exist with z . (b + W P) = 0 for all z. Contact is
/// known by what multipliers that span its cones do along each motion (line_balance,
/// surface_balance), so this is a nonnegative least-squares problem with one row per
/// motion; what it leaves over is (Farkas) a motion that the loads push and no admissible
/// force opposes. It is named by the motion that an engineer would see
/// (unbalanced_motion).
/// @throws NoEquilibrium  naming that motion
template <int dim>
void require_balance(const SimplexMesh<dim>& mesh, const ElasticSystem& system,
                     const ContactForcesOn& extreme,
                     const AlongNormals& along_n);

/// What loads and contact forces of an answer miss of equilibrium along the unheld rigid
/// motions z, |z . (b + W P)| relative to the sum of |b|; 0 without loads. In a body that is very
/// stiff beside what holds it the residual of an answer does not see this: the rounding
/// of K u is larger.
/// @param contact  W P on all dofs
template <int dim>
double balance_defect(const SimplexMesh<dim>& mesh, const ElasticSystem& system,
                      const VectorXd& contact);

/// require_balance of a contact line or surface under its law, by its extreme_forces.
template <int dim, class Nodes, class Law>
void require_balance(const SimplexMesh<dim>& mesh, const Nodes& nodes,
                     const Law& law, const ElasticSystem& system) {
  require_balance(
      mesh, system,
      [&](const MatrixXd& motions) {
        return extreme_forces(nodes, law, motions);
      },
      along_normals(nodes));
}

/// A residual that counts for nothing where the balance is missed by more than this.
constexpr double most_unbalanced = 1e-4;
inline double with_balance(double residual, double balance_defect) {
  return balance_defect > most_unbalanced ? std::max(residual, balance_defect)
                                          : residual;
}

/// u . n at the nodes of a contact line or surface.
template <class Nodes>
AlongNormals along_normals(const Nodes& nodes) {
  return [&nodes](const VectorXd& field) -> VectorXd {
    return contact_components(nodes, field).row(0);
  };
}

/// [z] of motions z at all nodes, one column each [dim p x motions].
template <class Nodes>
MatrixXd traces_of(const Nodes& nodes, const MatrixXd& motions) {
  MatrixXd traces(nodes.normal.size(), motions.cols());
  for (Index k = 0; k < motions.cols(); ++k)
    traces.col(k) = contact_components(nodes, motions.col(k)).reshaped();
  return traces;
}

/// Forces, or what they do along motions, and the opposite ones, as bonded nodes have them.
/// @param forces  one a column
inline MatrixXd forces_either_way(const Ref<const MatrixXd>& forces) {
  MatrixXd all(forces.rows(), 2 * forces.cols());
  all << forces, -forces;
  return all;
}

}  // namespace ffcontact
