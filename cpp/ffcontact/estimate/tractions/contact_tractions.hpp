// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/appended.hpp"
#include "ffcontact/estimate/bodies/estimate_settings.hpp"
#include "ffcontact/estimate/bodies/matched_bodies.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"

namespace ffcontact {

/// Contact tractions r_hat.
template <int d>
struct ContactTractions;

template <>
struct ContactTractions<2> {
  ContactDensities densities;
  ContactDensities balanced;    ///< those that stresses have to balance
  VectorXd shift;               ///< d of (4.1) per edge [MPa]
  std::vector<int> unmended{};  ///< edges that (4.1) leaves outside the cone
};

template <>
struct ContactTractions<3> {
  Matrix3Xd densities;  ///< before relaxation, at the nodes [MPa, 3 x p]
  SurfaceTractions on_faces{};  ///< and after it
  FaceMoments
      beside{};  ///< of given tractions on the faces of the surface [9 x m]
};

/// The motions that contact alone holds, or moves a tool by, and what it must do along them
/// [k].
struct HeldMotions {
  MatrixXd fields;     ///< vertex fields [dofs x k]
  VectorXd of_loads;   ///< that balances the loads, or pushes the tool
  VectorXd of_forces;  ///< that the contact forces of u_h do

  void add(const HeldMotions& more) {
    append(more.fields, fields);
    append(more.of_loads, of_loads);
    append(more.of_forces, of_forces);
  }
};

/// p_i = F_i / len_i of lambda_h [2 x p], len_i = int psi_i n . n_i: where directions turn
/// p_i n(s) has the normal force of a node between two like edges.
Matrix2Xd nodal_pressures(const SolvedProblem<2>& solved);

/// The forces of the multipliers on all dofs.
template <int d>
VectorXd computed_forces(const SolvedProblem<d>& solved);

/// r_hat before the relaxation. Nodal pressures F_i / len_i, or F_i / A_i in space, obey the
/// law as the forces do, and have their resultant. Where rigid motions are held by contact
/// alone, and int z . r must be what balances the loads along them, the tractions in the cone
/// nearest to these (nearest_in_cone).
///
/// In the plane edges carry what does not cost far more than it gains (carrying_edges), all
/// of the cone where no such tractions hold the body; or they are those of [CHH01]
/// (Tractions::published). In space tractions go on to nodes that a support holds on a rigid
/// foundation (continued_tractions), and off faces that open far (carrying_nodes).
/// @param held   rigid motions, on the solved bodies
/// @param u_hat  of the matched bodies
/// @return nothing if no tractions in the cone hold the body
template <int d>
std::optional<ContactTractions<d>> contact_tractions(
    const SolvedProblem<d>& solved, const MatchedBodies<d>& bodies,
    HeldMotions held, const EstimateSettings<d>& settings,
    const Ref<const VectorXd>& u_hat);

}  // namespace ffcontact
