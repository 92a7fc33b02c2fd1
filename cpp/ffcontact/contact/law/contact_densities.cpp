// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/contact_densities.hpp"

#include <algorithm>

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

ContactDensities edge_densities(const ContactLine& line,
                                const Ref<const Matrix2Xd>& pressure) {
  ContactDensities densities{Matrix2Xd(2, line.edge_count()),
                             Matrix2Xd(2, line.edge_count())};
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      densities.normal(end, e) = pressure(0, line.edge_node(end, e));
      densities.tangential(end, e) = pressure(1, line.edge_node(end, e));
    }
  return densities;
}

double largest_traction(const ContactDensities& densities) {
  if (densities.normal.size() == 0) return 0;
  return std::max(max_norm(densities.normal), max_norm(densities.tangential));
}

}  // namespace ffcontact
