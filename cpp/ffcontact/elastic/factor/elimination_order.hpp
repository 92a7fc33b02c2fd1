// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// The free dofs as a factorisation eliminates them: the interior vertex by vertex, in
/// METIS's nested dissection of the graph of vertices, not of dofs, then the kept dofs as
/// they are listed.
std::vector<int> elimination_order(const ElasticSystem& system,
                                   const std::vector<int>& kept);

}  // namespace ffcontact
