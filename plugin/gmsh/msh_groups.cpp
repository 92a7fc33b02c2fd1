// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/msh_groups.hpp"

#include <algorithm>
#include <map>

#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

int tag_to_use(const std::vector<MshElement>& elements) {
  return std::any_of(elements.begin(), elements.end(),
                     [](const auto& e) { return e.tags[0] != 0; })
             ? 0
             : 1;
}

void refuse_groups(const MshElement& element, const MshFile& file,
                   const std::string& shown, int one, int other) {
  constexpr std::array<const char*, 4> groups = {"points", "curves", "surfaces",
                                                 "volumes"};
  refuse("the ", element.type->name, " at ", place_of(element, file), " of ",
         shown, " is in two physical ", groups[element.type->dimension], ", ",
         one, " and ", other, ", but has one ",
         element.type->dimension < file.dim ? "label" : "region",
         ": put it into one of them");
}

void take_each_cell_once(MshFile& file, const std::string& shown,
                         const char* advice) {
  std::vector<MshElement>& cells = file.elements[file.dim];
  if (cells.empty())
    refuse(shown, " has no ", simplex_type(file.dim).names,
           file.elements[file.dim - 1].empty() ? "" : advice);
  const int tag = tag_to_use(cells);
  std::map<std::array<int, 8>, int> region;
  const auto is_repeated = [&](const MshElement& cell) {
    std::array<int, 8> sorted = cell.nodes;
    std::sort(sorted.begin(), sorted.end());
    const auto [seen, is_new] = region.try_emplace(sorted, cell.tags[tag]);
    if (seen->second != cell.tags[tag])
      refuse_groups(cell, file, shown, seen->second, cell.tags[tag]);
    return !is_new;
  };
  cells.erase(std::remove_if(cells.begin(), cells.end(), is_repeated),
              cells.end());
}

}  // namespace ffcontact::plugin
