// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/contact_facet.hpp"

#include "ffcontact/base/over.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"

namespace ffcontact {

template <int d>
double contact_term(const ContactFacet<d>& facet, const MatrixOf<d>& traction) {
  return sum_over(d, [&](int i) {
    return facet.paid[i].bound(traction(0, i)) * facet.slip[i] +
           traction.col(i).dot(facet.work.col(i));
  });
}

template <int d>
KnownTractions<d> without_contact(KnownTractions<d> known,
                                  const std::vector<ContactFacet<d>>& contact) {
  for (const ContactFacet<d>& facet : contact) {
    for (int f : {facet.facet, facet.opposite})
      if (f >= 0) known.col(f).setConstant(false);
    for (const FacingPart<d>& part : facet.facing)
      known.col(part.facet).setConstant(false);
  }
  return known;
}

template <int d>
MatrixOf<d> traction_of(const ContactFacet<d>& facet,
                        const MatrixOf<d>& moments) {
  if (facet.bent_of_moments.size() > 0)
    return (facet.bent_of_moments * moments.reshaped()).reshaped(d, d);
  const MatrixOf<d> density = facet_density<d>(moments, facet.measure);
  MatrixOf<d> traction;
  for (int i = 0; i < d; ++i)
    traction.col(i) = facet.frame[i].transpose() * density.col(i);
  return traction;
}

template <int d>
MatrixOf<d> moments_of(const ContactFacet<d>& facet,
                       const MatrixOf<d>& traction) {
  if (facet.moments_of_bent.size() > 0)
    return (facet.moments_of_bent * traction.reshaped()).reshaped(d, d);
  MatrixOf<d> density;
  for (int i = 0; i < d; ++i) density.col(i) = facet.frame[i] * traction.col(i);
  return facet_moments_of<d>(density, facet.measure);
}

template <int d>
MatrixXd tractions_of_columns(const ContactFacet<d>& facet,
                              const Ref<const MatrixXd>& moments) {
  MatrixXd tractions(d * d, moments.cols());
  for (Index k = 0; k < moments.cols(); ++k) {
    const MatrixOf<d> of_column = moments.col(k).reshaped(d, d);
    tractions.col(k) = traction_of<d>(facet, of_column).reshaped();
  }
  return tractions;
}

template double contact_term(const ContactFacet<FFCONTACT_DIMENSION>&,
                             const MatrixOf<FFCONTACT_DIMENSION>&);
template KnownTractions<FFCONTACT_DIMENSION> without_contact(
    KnownTractions<FFCONTACT_DIMENSION>,
    const std::vector<ContactFacet<FFCONTACT_DIMENSION>>&);
template MatrixOf<FFCONTACT_DIMENSION> traction_of(
    const ContactFacet<FFCONTACT_DIMENSION>&,
    const MatrixOf<FFCONTACT_DIMENSION>&);
template MatrixOf<FFCONTACT_DIMENSION> moments_of(
    const ContactFacet<FFCONTACT_DIMENSION>&,
    const MatrixOf<FFCONTACT_DIMENSION>&);
template MatrixXd tractions_of_columns(const ContactFacet<FFCONTACT_DIMENSION>&,
                                       const Ref<const MatrixXd>&);

}  // namespace ffcontact
