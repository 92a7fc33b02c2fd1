// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/facet_energy.hpp"

#include <gtest/gtest.h>

#include "support/cells.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A cell with any elastic law, and any columns of loads.
template <int d>
struct AnyForm {
  static constexpr int size = CompositeElement<d>::moments;
  CellCorners<d> x;
  VoigtMatrix<d> compliance;
  FacetBases<d> basis;

  explicit AnyForm(Random& random)
      : x(random_cell<d>(random)), compliance(random_law<d>(random)) {
    for (auto& columns : basis) columns = random_matrix(size, size, random);
  }
  SubcellStress<d> stress(const CellVector<d>& unknowns) const {
    FacetLoads<d> loads;
    for (int k = 0; k <= d; ++k)
      loads.template middleCols<d>(d * k).reshaped() =
          basis[k] * unknowns.template segment<size>(size * k);
    return composite_stress<d>(x, loads, balancing_body_loads<d>(loads));
  }
  double energy_of(const SubcellStress<d>& stress) const {
    return energy<d>(x, compliance, stress);
  }
};

template <int d>
double error_of_energy(Random& random) {
  const AnyForm<d> any(random);
  const CellForm<d> H = facet_energy<d>(any.x, any.compliance, any.basis);
  const CellVector<d> unknowns = random_vector(H.rows(), random);
  const double expected = any.energy_of(any.stress(unknowns));
  return std::abs(unknowns.dot(H * unknowns) - expected) / expected;
}

RC_GTEST_PROP(FacetEnergy, is_that_of_the_composite_stress, (Random random)) {
  RC_ASSERT(error_of_energy<2>(random) < 1e-11);
  RC_ASSERT(error_of_energy<3>(random) < 1e-11);
}

template <int d>
double error_of_slope(Random& random) {
  const AnyForm<d> any(random);
  const CellVector<d> at = random_vector(CompositeElement<d>::loads, random),
                      along = random_vector(CompositeElement<d>::loads, random);
  const SubcellStress<d> sigma = any.stress(at), tau = any.stress(along);
  const double slope =
      facet_slope<d>(any.x, any.compliance, sigma, any.basis).dot(along);
  // (sigma + tau)^2 - (sigma - tau)^2 = 4 sigma tau
  const double plus = any.energy_of(sigma + tau),
               minus = any.energy_of(sigma - tau);
  return std::abs(slope - (plus - minus) / 4) / (plus + minus);
}

RC_GTEST_PROP(FacetEnergy, slope_is_that_of_the_energy, (Random random)) {
  RC_ASSERT(error_of_slope<2>(random) < 1e-11);
  RC_ASSERT(error_of_slope<3>(random) < 1e-11);
}

}  // namespace
}  // namespace ffcontact
