// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/require.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact::plugin {

/// @throws std::invalid_argument  unless each vertex has a size that is finite and positive
inline void require_vertex_sizes(const Ref<const VectorXd>& size,
                                 Index vertices) {
  if (size.size() != vertices)
    refuse("size has ", size.size(), " values where ", vertices,
           ", one a vertex, are needed");
  require_finite("size", size);
  if (size.minCoeff() <= 0)
    refuse("sizes must be positive, but one is ", size.minCoeff());
}

}  // namespace ffcontact::plugin
