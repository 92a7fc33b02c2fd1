// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/law/contact_densities.hpp"
#include "ffcontact/equilibrium/tractions/contact_facet.hpp"
#include "ffcontact/equilibrium/tractions/facet_term.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/estimate/error/face_fields.hpp"

/// What e^2 has of a compliant layer in the interface. Its springs are deformed by d = C p, p
/// the tractions at the nodes that it carries, linear between them (CompliantLayer::carried):
/// any d is admissible, and contact on the far side of it keeps clear of gap - d. With r_hat
///     int (C r_hat - d)' C^-1 (C r_hat - d) = int c_n (r_n - p_n)^2 + c_t |r_t - p_t|^2
/// is twice what their energy, its conjugate and the work of r_hat along d sum up to; with it
/// in e^2 the bounds hold for the norms with the energy of the layer. Tractions by the linear
/// fields that they have where directions turn: r_n and r_t along an edge, r_n and m of
/// BentTraction on a face, on which c_t |m - m_p|^2 is right where its normals do not turn.
namespace ffcontact {

/// int C f . g over a facet of measure 1, of fields that are linear between their values at its
/// d corners, one column each; r_n in the first row.
template <class Fields>
double layer_product(const CompliantLayer& layer, const Fields& f,
                     const Fields& g) {
  const Index corners = f.cols();
  double sum = 0;
  for (Index row = 0; row < f.rows(); ++row)
    sum += layer.of(row) *
           (f.row(row).dot(g.row(row)) + f.row(row).sum() * g.row(row).sum());
  return sum / static_cast<double>(corners * (corners + 1));
}

/// r_n and m, which are linear, at the corners.
inline Matrix4Xd linear_fields(const BentTraction& traction) {
  Matrix4Xd fields(4, traction.pressing.cols());
  fields << traction.pressing, traction.turned;
  return fields;
}

/// Per contact facet, and int C |r_hat + p|^2 in all; no facets without a layer.
SpringNorms layer_norms(const ContactLine& line, const ContactLaw<2>& law,
                        const ContactDensities& densities);
SpringNorms layer_norms(const Topology<3>& topology,
                        const ContactSurface& surface, const ContactLaw<3>& law,
                        const TractionFields& traction);

/// The same by the moments of contact facets.
/// @param moments  of all facets, with r_hat
template <int d>
std::vector<FacetTerm<d>> layer_terms(
    const LineOrSurface<d>& contact, const ContactLaw<d>& law,
    const std::vector<ContactFacet<d>>& facets, const FacetColumns<d>& moments);

}  // namespace ffcontact
