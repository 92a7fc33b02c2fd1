// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/progress.hpp"
#include "ffcontact/equilibrium/tractions/contact_facet.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/equilibrium/tractions/facing_oscillation.hpp"

namespace ffcontact {

/// What facet moments are relaxed for: the least
///     e^2 = |sigma_hat - sigma|^2 + terms of facets + 2 sum of contact_term
/// with r_hat in the cone; where meshes do not match FacingOscillation counts, too
/// (ContactPass).
template <int d>
struct FacetSetting {
  LoadedFacets<d> body;
  /// facets whose tractions, known in its boundary, may change in the cone
  std::vector<ContactFacet<d>> contact = {};
  /// of facets that face some of them in part
  std::vector<FacingOscillation<d>> oscillation = {};
  /// vertex fields z_k, linear on the facets, whose int r_hat . z_k stay as they are [d *
  /// vertices x k]
  MatrixXd kept_work = MatrixXd();
  /// is told e after every step (without Tresca's constant)
  ProgressReport report = {};
};

}  // namespace ffcontact
