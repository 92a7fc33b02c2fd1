// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace ffcontact {

/// Asks the system for pages of 2 MB, where it has such, in memory that has not been
/// touched. Of an array of gigabytes that is gathered from everywhere a processor does
/// not know where all the pages of 4 kB are, and the system clears them one by one.
/// Only whole huge pages inside are asked for: no memory is taken beside. A hint: what
/// the system does with it changes no digit.
void use_huge_pages(const void* begin, std::size_t bytes);

/// The same of a matrix or a vector that has its size but no values.
template <class Array>
void use_huge_pages(const Array& array) {
  use_huge_pages(array.data(), static_cast<std::size_t>(array.size()) *
                                   sizeof(*array.data()));
}

}  // namespace ffcontact
