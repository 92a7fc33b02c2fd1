// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

/// Which nodes have tractions beyond rounding of the largest?
template <class Tractions>
Flags loaded_nodes(const Tractions& traction) {
  constexpr double rounding = 1e-9;
  const double least = rounding * max_norm(traction);
  Flags loaded(traction.cols());
  for (Index i = 0; i < traction.cols(); ++i)
    loaded[i] = traction.col(i).norm() > least;
  return loaded;
}

}  // namespace ffcontact
