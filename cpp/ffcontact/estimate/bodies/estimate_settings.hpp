// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"

namespace ffcontact {

/// Which contact tractions r_hat the estimate uses.
enum class Tractions {
  /// in the cone, F_i / len_i at the nodes, and relaxed inside it together with the stress
  free,
  fixed,  ///< in the cone, not relaxed
  /// correction (4.1) alone, as in [CHH01]: edges it cannot mend stay outside the cone,
  /// the indicator functions of (2.11) are dropped, and the result is then not admissible
  published,
};

/// How sigma_hat is built inside the triangles from the edge tractions [CHH01, 4.2.2].
enum class Construction {
  composite,  ///< in equilibrium at every point (SubcellStress<2>)
  /// C eps(w), w of degree 4, in equilibrium in the mean only (PolynomialStress): e is
  /// lower and no bound, and the result is not admissible
  polynomial,
};

template <int d>
struct EstimateSettings {
  RelaxationSettings relaxation{};
  ProgressReport report{};                 ///< of every step of it
  RelaxFacets<d> relax = relax_facets<d>;  ///< by one process or several
};

template <>
struct EstimateSettings<2> {
  RelaxationSettings relaxation{};
  ProgressReport report{};
  RelaxFacets<2> relax = relax_facets<2>;
  Tractions tractions = Tractions::free;
  Construction construction = Construction::composite;
};

}  // namespace ffcontact
