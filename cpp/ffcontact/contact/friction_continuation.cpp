// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/friction_continuation.hpp"

namespace ffcontact {

ActiveSetResult friction_continuation(const CondensedContact& contact, const NodalLaw& law,
                                      std::vector<ContactState> state, int steps, const NewtonSettings& settings) {
  ActiveSetResult result;
  int systems = 0;
  for (int k = 1; k <= steps; ++k) {
    NodalLaw weaker = law;
    weaker.friction *= static_cast<double>(k) / steps;
    result = active_set_newton(contact, weaker, state, settings);
    systems += result.iterations;
    if (result.status == ContactStatus::converged) state = result.state;
  }
  result.iterations = systems;
  return result;
}

}  // namespace ffcontact
