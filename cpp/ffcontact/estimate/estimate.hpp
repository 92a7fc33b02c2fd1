// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/estimate/bodies/estimate_settings.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/estimate/displacement/admissible_displacement.hpp"
#include "ffcontact/estimate/error/contact_error.hpp"
#include "ffcontact/estimate/error/pair_error.hpp"
#include "ffcontact/interface/pairing/common_refinement.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// The error in the constitutive relation of an admissible pair ((u_hat, w_hat),
/// (sigma_hat, r_hat)) [CHH01, 2.2].
///     e^2 = |sigma_hat - C eps(u_hat)|^2 + 2 int (mu |r_n||w_t| + r_t w_t + r_n w_n)                              (2.11)
///     eps = e / |sigma_hat + C eps(u_hat)|,   eps^2 = sum of eps_E^2                                        (2.12), (2.13)
/// Springs on the boundary (BoundarySprings<2>) with the tractions t_hat beside the given ones
/// add int (t_hat + K (u_hat - u_0))' K^-1 (t_hat + K (u_hat - u_0)) to e^2 and the same
/// with a minus to the square of the denominator; the bounds hold for norms that contain
/// their energy.
/// With initial strains eps0 and stresses sigma0 C eps(u_hat) + tau0 stands for C
/// eps(u_hat), tau0 = sigma0 - C eps0 linear on each triangle. All of this is exact for
/// such tau0, of which the P1 solution knows the means alone: what varies is in e. For
/// any other tau0 the bounds hold with e + |tau0 - its linear part| in place of e.
/// For Tresca's law and without friction e bounds the error of the pair (2.20); for
/// Coulomb's law (2.14) has one more term, for which there is coulomb_bound.
struct Estimate : PairError {
  /// The bodies cut so that their facing traces match, where they do not; the fields
  /// below are then on its mesh and line.
  std::optional<CommonRefinement> refinement;
  VectorXd displacement;  ///< u_hat on all dofs [mm]
  /// sigma_hat [MPa]; of the polynomial construction its values at these corners
  std::vector<SubcellStress<2>> stress;
  ContactDensities tractions;  ///< r_hat [MPa]
  /// moments of t_hat of the springs at the vertices of each column of Mesh::boundary [4 x
  /// boundary]; no columns without springs
  Matrix4Xd spring_tractions;
  VectorXd shift;  ///< d of (4.1) per contact edge [MPa], 0 where none
  /// contact edges left outside the cone (Tractions::published only)
  std::vector<int> unmended;

  int corrected_count() const;
};

/// Builds the admissible pair and evaluates it, as the numbered steps in the body.
///
/// Bodies against each other come as one joined mesh and system, with lines that face
/// other bodies: u_n, u_t and w are jumps, r_hat acts on the line's body and -r_hat on
/// the opposite one, pointwise. Where the traces do not match all this is done on their
/// common refinement: non-penetration holds at each of its nodes, r_hat is linear on each
/// of its edges, and the triangles beside it are the fans of the refinement.
///
/// Bodies without loads whose stresses and tractions are below 1e-12 of the terms |C|
/// |grad phi| max(|u|, |gap|, |previous|) that stresses are summed from, and that slide
/// nowhere against Tresca's friction, have none: sigma_hat = 0, r_hat = 0, and e is that
/// of u_hat - u, which is 0 but where u penetrates.
/// @param system  the stiffness and the prescribed dofs u_h was computed with
/// @throws std::invalid_argument  for input that does not fit (see law_of_matrix.hpp), or
///                                where no tractions in the cone hold the body
/// @throws std::runtime_error     if a part of the body is held by nothing
Estimate estimate_error(const Topology<2>& topology, const ContactLine& line,
                        const ElasticSystem& system, const SolvedBody<2>& body,
                        const EstimateSettings& settings = {});

}  // namespace ffcontact
