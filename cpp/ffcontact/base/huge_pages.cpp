// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/huge_pages.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

namespace ffcontact {

#ifdef MADV_HUGEPAGE
void use_huge_pages(const void* begin, std::size_t bytes) {
  constexpr std::uintptr_t page = 1 << 21;
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (address + page - 1) / page * page,
                       end = (address + bytes) / page * page;
  if (first < end)  // refused where there are none
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}
#else
void use_huge_pages(const void*, std::size_t) {}
#endif

}  // namespace ffcontact
