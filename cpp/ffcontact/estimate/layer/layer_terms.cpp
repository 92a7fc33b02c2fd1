// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/layer/layer_parts.hpp"

namespace ffcontact {

namespace {

/// The linear fields of tractions on a facet by their values at its vertices, r_n in the first
/// row.
template <int d>
using FieldsOfFacet = Matrix<double, d == 2 ? 2 : 4, d>;

template <int d>
FieldsOfFacet<d> fields_of(const ContactFacet<d>& facet,
                           const MatrixOf<d>& traction) {
  if constexpr (d == 2) {
    return traction;
  } else {
    return linear_fields(bent_traction(facet.frame, traction));
  }
}

/// Of each unit moment.
template <int d>
std::array<FieldsOfFacet<d>, d * d> fields_of_moments(
    const ContactFacet<d>& facet) {
  std::array<FieldsOfFacet<d>, d * d> fields;
  for (int k = 0; k < d * d; ++k) {
    MatrixOf<d> unit = MatrixOf<d>::Zero();
    unit(k % d, k / d) = 1;
    fields[k] = fields_of<d>(facet, traction_of<d>(facet, unit));
  }
  return fields;
}

/// @param off  fields of r_hat less what the layer carries
template <int d>
FacetTerm<d> layer_term(const CompliantLayer& layer,
                        const ContactFacet<d>& facet,
                        const FieldsOfFacet<d>& off) {
  const auto by_moments = fields_of_moments<d>(facet);
  const auto of = [&](const FieldsOfFacet<d>& a, const FieldsOfFacet<d>& b) {
    return facet.measure * layer_product(layer, a, b);
  };
  FacetTerm<d> term{facet.facet, FacetMatrix<d>::Zero(), FacetVector<d>::Zero(),
                    of(off, off)};
  for (int i = 0; i < d * d; ++i) {
    term.g[i] = of(by_moments[i], off);
    for (int j = 0; j < d * d; ++j)
      term.H(i, j) = of(by_moments[i], by_moments[j]);
  }
  return term;
}

}  // namespace

template <int d>
std::vector<FacetTerm<d>> layer_terms(
    const LineOrSurface<d>& contact, const ContactLaw<d>& law,
    const std::vector<ContactFacet<d>>& facets,
    const FacetColumns<d>& moments) {
  std::vector<FacetTerm<d>> terms;
  if (!law.layer.given()) return terms;
  for (const ContactFacet<d>& facet : facets) {
    const MatrixOf<d> carried =
        law.carried(Eigen::all, nodes_of(contact, facet.index));
    terms.push_back(layer_term<d>(
        law.layer, facet,
        fields_of<d>(facet, traction_on<d>(facet, moments) - carried)));
  }
  return terms;
}

template std::vector<FacetTerm<FFCONTACT_DIMENSION>> layer_terms(
    const LineOrSurface<FFCONTACT_DIMENSION>&,
    const ContactLaw<FFCONTACT_DIMENSION>&,
    const std::vector<ContactFacet<FFCONTACT_DIMENSION>>&,
    const FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
