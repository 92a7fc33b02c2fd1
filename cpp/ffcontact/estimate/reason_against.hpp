// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "ffcontact/equilibrium/equilibrium_defect.hpp"
#include "ffcontact/estimate/estimate_settings.hpp"

namespace ffcontact {

/// By how much the pair of an estimate misses what is asked of it.
struct PairDefects {
  double penetration;  ///< of u_hat, relative to the largest displacement
  double cone;         ///< of r_hat, relative to the largest stress
  EquilibriumDefect equilibrium;
  Construction construction = Construction::composite;
  std::size_t unmended = 0;  ///< edges that (4.1) cannot mend
};

/// Why the pair is not admissible, one sentence without a full stop: penetration above
/// 1e-12, tractions outside of the cone by more than 1e-12, stresses out of equilibrium by
/// more than 1e-10. Nothing if it is.
/// @param deepest  where u_hat penetrates most
std::string reason_against(const PairDefects& defects,
                           const Ref<const VectorXd>& deepest);

}  // namespace ffcontact
