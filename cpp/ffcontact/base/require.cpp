// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"

#include <cmath>
#include <new>

namespace ffcontact {

std::string sentence_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) return "out of memory";
  if (dynamic_cast<const Refusal*>(&error) ||
      dynamic_cast<const Failure*>(&error))
    return error.what();
  return std::string("an internal error of ffcontact (") + error.what() +
         "): please report it, with the script";
}

void refuse_by(const std::ostringstream& sentence) {
  throw Refusal(sentence.str());
}

void require_size(const std::string& name, Index actual, Index expected) {
  if (actual != expected)
    refuse(name, " has ", actual, " values where ", expected, " are needed");
}

void require_finite(const std::string& name,
                    const Ref<const VectorXd>& values) {
  if (values.allFinite()) return;
  for (Index k = 0; k < values.size(); ++k)
    if (!std::isfinite(values[k]))
      refuse(name, "[", k, "] is ", values[k], ", not a finite number");
}

void require_nonnegative(const std::string& name,
                         const Ref<const VectorXd>& values) {
  for (Index k = 0; k < values.size(); ++k)
    if (!(values[k] >= 0) || !std::isfinite(values[k]))
      refuse(name, " must be finite and not negative, but value ", k, " is ",
             values[k]);
}

}  // namespace ffcontact
