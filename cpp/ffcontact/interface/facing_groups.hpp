// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// The vertices that depend on each other on a line: that of each node and what it faces,
/// joined where nodes share a vertex. Each group is ascending.
std::vector<std::vector<int>> facing_groups(const ContactLine& line);

}  // namespace ffcontact
