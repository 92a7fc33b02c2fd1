// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace ffcontact {

/// The value that a map has for a key; that it has one is an invariant of the caller.
/// @param what  that the map has for its keys, for the report where it has none
/// @throws std::logic_error  saying that there is no such thing: a mistake of the caller
template <class Map, class Key>
auto& entry_of(Map& map, const Key& key, const char* what) {
  const auto found = map.find(key);
  if (found == map.end())
    throw std::logic_error(std::string("there is no ") + what);
  return found->second;
}

}  // namespace ffcontact
