// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/estimate/error/pair_error.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"
#include "ffcontact/interface/pairing/common_refinement.hpp"

namespace ffcontact {

/// The error in the constitutive relation of an admissible pair ((u_hat, w_hat),
/// (sigma_hat, r_hat)) [CHH01, 2.2].
///     e^2 = |sigma_hat - C eps(u_hat)|^2 + 2 int (mu |r_n||w_t| + r_t . w_t + r_n w_n)                            (2.11)
///     eps = e / |sigma_hat + C eps(u_hat)|,   eps^2 = sum of eps_E^2                                        (2.12), (2.13)
/// Springs on the boundary (BoundarySprings) with the tractions t_hat beside the given ones
/// add int (t_hat + K (u_hat - u_0))' K^-1 (t_hat + K (u_hat - u_0)) to e^2 and the same
/// with a minus to the square of the denominator; the bounds hold for norms that contain
/// their energy.
/// With initial strains eps0 and stresses sigma0 C eps(u_hat) + tau0 stands for C
/// eps(u_hat), tau0 = sigma0 - C eps0 linear on each cell. All of this is exact for
/// such tau0, of which the P1 solution knows the means alone: what varies is in e. For
/// any other tau0 the bounds hold with e + |tau0 - its linear part| in place of e.
/// For Tresca's law and without friction e bounds the error of the pair (2.20); for
/// Coulomb's law (2.14) has one more term, for which there are coulomb_bound and
/// solid_coulomb.
template <int d>
struct Estimate;

template <>
struct Estimate<2> : PairError {
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

  int corrected_count() const {
    return static_cast<int>((shift.array() != 0).count());
  }
};

template <>
struct Estimate<3> : PairError {
  VectorXd displacement;  ///< u_hat on all dofs [mm]
  FaceMoments moments;    ///< of sigma_hat on the faces [N]
  /// r_hat before its relaxation: at the nodes (BentTraction between them) [MPa, 3 x p]
  Matrix3Xd tractions;
  /// r_hat at the vertices of the contact faces [MPa]
  SurfaceTractions face_tractions;
  FaceMoments spring_tractions;  ///< as in the plane [9 x boundary]
  /// of sigma_hat, where others than the given ones hold what slides (RigidMotions); or no
  /// columns
  BodyLoadsOfCells<3> body_loads{12, 0};

  const BodyLoadsOfCells<3>& loads_of_stress(const SolvedBody<3>& body) const {
    return body_loads.cols() > 0 ? body_loads : body.body_loads;
  }
};

/// sigma_hat at the corners of the subcells of one cell [MPa].
inline const SubcellStress<2>& stress_of(const Topology<2>&,
                                         const Estimate<2>& estimate,
                                         const SolvedBody<2>&, int cell) {
  return estimate.stress[cell];
}
inline SubcellStress<3> stress_of(const Topology<3>& topology,
                                  const Estimate<3>& estimate,
                                  const SolvedBody<3>& body, int cell) {
  return composite_stress(
      corners_of(topology.mesh, cell),
      loads_of(topology.mesh, topology.facets, estimate.moments, cell),
      loads_in_cell<3>(estimate.loads_of_stress(body), cell));
}

}  // namespace ffcontact
