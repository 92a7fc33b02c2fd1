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
    const BentTraction bent = bent_traction(facet.frame, traction);
    FieldsOfFacet<3> fields;
    fields << bent.pressing, bent.turned;
    return fields;
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

/// int C a . b
template <int d>
double product(const CompliantLayer& layer, double measure,
               const FieldsOfFacet<d>& a, const FieldsOfFacet<d>& b) {
  double sum = 0;
  for (Index row = 0; row < a.rows(); ++row)
    sum += layer.of(row) *
           (a.row(row).dot(b.row(row)) + a.row(row).sum() * b.row(row).sum());
  return measure / (d * (d + 1)) * sum;
}

/// @param off  fields of r_hat less what the layer carries
template <int d>
FacetTerm<d> layer_term(const CompliantLayer& layer,
                        const ContactFacet<d>& facet,
                        const FieldsOfFacet<d>& off) {
  const auto by_moments = fields_of_moments<d>(facet);
  const auto of = [&](const FieldsOfFacet<d>& a, const FieldsOfFacet<d>& b) {
    return product<d>(layer, facet.measure, a, b);
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
    const LineOrSurface<d>& contact, const LawOfContact<d>& law,
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
    const LawOfContact<FFCONTACT_DIMENSION>&,
    const std::vector<ContactFacet<FFCONTACT_DIMENSION>>&,
    const FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
