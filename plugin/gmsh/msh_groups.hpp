// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "gmsh/msh_file.hpp"

namespace ffcontact::plugin {

/// Which tag of elements counts: 0, the physical one, if one element has one; otherwise 1,
/// the elementary one.
int tag_to_use(const std::vector<MshElement>& elements);

/// Which of several groups of an element should count? Their order says nothing.
/// @throws std::invalid_argument  always, naming the element, its place and both groups
[[noreturn]] void refuse_groups(const MshElement& element, const MshFile& file,
                                const std::string& shown, int one, int other);

/// Takes each cell once: gmsh writes an element of several physical groups once for each.
/// @param advice  to a file that has facets and no cells
/// @throws std::invalid_argument  if there are no cells, or one is in two groups
void take_each_cell_once(MshFile& file, const std::string& shown,
                         const char* advice);

}  // namespace ffcontact::plugin
