// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_solution.hpp"

namespace ffcontact {

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

}  // namespace ffcontact
