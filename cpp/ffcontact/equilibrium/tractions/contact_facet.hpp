// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
#include "ffcontact/equilibrium/tractions/wrench_basis.hpp"

namespace ffcontact {

/// What a contact facet does to a facet of another body that it faces in part: the moments
/// there by its (r_n, r_t) at its vertices, of the linear traction nearest to the opposite
/// one, with its force and moment.
template <int d>
struct FacingPart {
  int facet;                 ///< of the mesh
  FacetMatrix<d> moments{};  ///< [mm or mm^2]
};

/// A contact facet, its law and its displacement w against what it faces, for tractions
/// r_hat by (r_n, r_t) at its vertices, one column each [MPa]: linear between them, or bent
/// as the directions turn (moments_of_ends in the plane, BentTraction in space).
template <int d>
struct ContactFacet {
  int facet;       ///< of the mesh
  int index = -1;  ///< on the contact line or surface
  /// the mesh facet of another body that matches it and feels the opposite traction, or -1
  int opposite = -1;
  Matrix<int, d, 1> opposite_corner;  ///< which its corners face
  /// where none matches, those of another body that all of it faces
  std::vector<FacingPart<d>> facing{};
  double measure;                    ///< [mm or mm^2]
  std::array<MatrixOf<d>, d> frame;  ///< columns n, t at its vertices
  /// moments of bent tractions by these, and back [d^2 x d^2]; empty of linear ones
  MatrixXd moments_of_bent, bent_of_moments;
  std::array<FrictionCone, d> cone;  ///< of tractions there
  /// moments of what it carries beside r_hat, the given tractions
  FacetVector<d> beside = FacetVector<d>::Zero();
  /// of what e pays there, which is wider where friction is bounded (bounded_friction)
  std::array<FrictionCone, d> paid;
  /// int phi_i w along n, t, one column a vertex [mm^2 or mm^3]; where the cost of
  /// friction is known to be linear in r_n, with that
  MatrixOf<d> work;
  /// int phi_i |w_t|, at most; 0 where work has the cost of friction
  VectorOf<d> slip;
  Matrix<double, d - 1, d> direction;  ///< w_t / |w_t| at the vertices, or 0
};

/// What r_hat on the facet adds to e^2 / 2 [N mm, of plane bodies N/mm times mm]:
///     sum over the vertices of c_i int phi_i |w_t| + r_i . int phi_i w,   c the bound of |r_t|   [CHH01, (2.11), (2.19)]
/// With c linear between the vertices, and the Bernstein polynomial of |w_t| (FaceCosts),
/// this is a bound of the integral of c |w_t| + r . w. In the plane work_n has the exact
/// integral of the former, - int phi_i mu |w_t|, as r_n <= 0, and slip is 0.
template <int d>
double contact_term(const ContactFacet<d>& facet, const MatrixOf<d>& traction);

/// Without the components of contact facets, and of those that they face: what relaxation
/// leaves alone.
template <int d>
KnownTractions<d> without_contact(KnownTractions<d> known,
                                  const std::vector<ContactFacet<d>>& contact);

/// Tractions of given moments, and moments of given tractions.
template <int d>
MatrixOf<d> traction_of(const ContactFacet<d>& facet,
                        const MatrixOf<d>& moments);
template <int d>
MatrixOf<d> moments_of(const ContactFacet<d>& facet,
                       const MatrixOf<d>& traction);

/// Tractions of several moments, each a column [d^2 x n].
template <int d>
MatrixXd tractions_of_columns(const ContactFacet<d>& facet,
                              const Ref<const MatrixXd>& moments);

/// r_hat where the moments of all facets are given.
template <int d>
MatrixOf<d> traction_on(const ContactFacet<d>& facet,
                        const FacetColumns<d>& moments) {
  const FacetVector<d> own = moments.col(facet.facet) - facet.beside;
  return traction_of<d>(facet, own.reshaped(d, d));
}

}  // namespace ffcontact
