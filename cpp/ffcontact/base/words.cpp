// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/words.hpp"

#include <sstream>

namespace ffcontact {

std::string in_digits(double value, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

std::string in_words(const Ref<const VectorXd>& x, int digits) {
  std::string components;
  for (double component : x)
    components +=
        (components.empty() ? "" : ", ") + in_digits(component, digits);
  return "(" + components + ")";
}

}  // namespace ffcontact
