// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_solution.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

Index nearest(const Ref<const VectorXd>& values, double value) {
  Index place;
  (values.array() - value).abs().minCoeff(&place);
  return place;
}

}  // namespace

ContactStatus judged_status(ContactStatus condensed, double complementarity,
                            double residual, double tolerance) {
  if (complementarity <= tolerance && residual <= tolerance)
    return condensed == ContactStatus::singular ? condensed
                                                : ContactStatus::converged;
  return condensed == ContactStatus::converged ? ContactStatus::inaccurate
                                               : condensed;
}

const char* in_words(ContactStatus status) {
  switch (status) {
    case ContactStatus::converged: return "converged";
    case ContactStatus::cycled: return "the active set cycles";
    case ContactStatus::singular: return "the body slides or rotates freely";
    case ContactStatus::not_converged: return "the iterations are used up";
    case ContactStatus::inaccurate: return "rounding exceeds the tolerance";
  }
  return "";
}

ContactStates states_at(const ContactLine& line,
                        const Ref<const VectorXd>& old_abscissa,
                        const ContactStates& old_state) {
  require_size("abscissa of the initial states", old_abscissa.size(),
               count_of(old_state));
  if (old_state.empty()) return {};
  ContactStates states;
  for (double s : line.abscissa)
    states.push_back(old_state[nearest(old_abscissa, s)]);
  return states;
}

}  // namespace ffcontact
