// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/estimate/error/contact_faces.hpp"
#include "ffcontact/estimate/error/pair_error.hpp"

namespace ffcontact {

/// The error in the constitutive relation of an admissible pair, as Estimate in the plane
/// [CHH01, 2.2]:
///     e^2 = |sigma_hat - C eps(u_hat)|^2 + contact_error   (2.11)
///     eps = e / |sigma_hat + C eps(u_hat)|,   eps^2 = sum of eps_E^2   (2.12), (2.13)
struct SolidEstimate : PairError {
  VectorXd displacement;  ///< u_hat on all dofs [mm]
  FaceMoments moments;    ///< of sigma_hat on the faces [N]
  /// r_hat before its relaxation: at the nodes, linear between [MPa, 3 x p]
  Matrix3Xd tractions;
  /// r_hat at the vertices of the contact faces, linear on each [MPa]
  SurfaceTractions face_tractions;
  /// traction_oscillation, same unit as e: where surfaces of two bodies do not match, e +
  /// this is what is said of e; 0 elsewhere
  double oscillation = 0;
};

/// Builds the admissible pair of solids on a rigid foundation or against each other (as
/// one mesh, joined_mesh) and evaluates it, as the numbered steps in the body.
///
/// r_hat begins with the nodal forces over the nodal areas, which are in the cone
/// everywhere; where contact alone holds the body they are moved inside the cone as little
/// as keeps force and moment. Relaxation then changes it face by face inside the cone, and
/// keeps force and moment of what contact alone holds; between bodies it stays as it is on
/// faces that do not match (matching_faces).
///
/// With initial strains and stresses C eps(u_hat) + tau0 stands for C eps(u_hat), as in
/// Estimate.
///
/// A body without loads whose stresses and tractions are below 1e-12 of the terms |C|
/// |grad phi| |u| that stresses are summed from has none.
/// @param system  the stiffness and the prescribed dofs u_h was computed with
/// @param relax   what relaxes, where steps are asked for
/// @throws std::invalid_argument  for input that does not fit, loads that are not those of
///                                u_h, or where no tractions in the cone hold the body
/// @throws std::runtime_error     if a part of the body is held by nothing
SolidEstimate estimate_error(const Topology<3>& topology,
                             const ContactSurface& surface,
                             const ElasticSystem& system,
                             const SolvedBody<3>& body,
                             const RelaxationSettings& settings = {},
                             const RelaxFaces& relax = relax_facets<3>);

/// sigma_hat at the corners of the subtetrahedra of one tetrahedron [MPa].
SubcellStress<3> stress_of(const Topology<3>& topology,
                           const SolidEstimate& estimate,
                           const SolvedBody<3>& body, int cell);

}  // namespace ffcontact
