// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_settings.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact {

void require_valid(const ContactSettings& settings, int nodes) {
  if (settings.max_iterations < 1)
    refuse("maxit must be at least 1, got ", settings.max_iterations);
  const auto given = count_of(settings.initial_state);
  if (given > 0) require_size("initial state", given, nodes);
  if (!settings.near) return;
  require_size("near P", settings.near->P.size(), 3 * nodes);
  require_size("near v", settings.near->v.size(), 3 * nodes);
}

}  // namespace ffcontact
