// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/words.hpp"

#include <charconv>
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

std::optional<int> whole_number(const std::string& word) {
  const char *begin = word.data(), *end = begin + word.size();
  int number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

std::string listed(const std::vector<std::string>& words,
                   const std::string& before_last) {
  std::string list = words.front();
  for (std::size_t k = 1; k < words.size(); ++k)
    list += (k + 1 < words.size() ? ", " : before_last) + words[k];
  return list;
}

}  // namespace ffcontact
