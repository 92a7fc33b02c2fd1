// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "ffcontact/estimate/estimate_settings.hpp"
#include "ffcontact/estimate/pair_error.hpp"

namespace ffcontact {

/// Why a pair is not admissible, one sentence without a full stop: penetration above
/// 1e-12, tractions outside of the cone by more than 1e-12, stresses out of equilibrium by
/// more than 1e-10. Nothing if it is.
/// @param deepest   where u_hat penetrates most
/// @param unmended  edges that (4.1) cannot mend
std::string reason_against(const PairError& error,
                           const Ref<const VectorXd>& deepest,
                           Construction construction = Construction::composite,
                           std::size_t unmended = 0);

}  // namespace ffcontact
