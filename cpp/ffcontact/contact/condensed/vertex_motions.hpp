// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// How a vertex moves: displacement = directions w for its free components w, which are
/// numbered from `column` on. A contact vertex that moves freely does so along n and t of
/// its first node.
struct VertexMotion {
  int column = 0;
  std::vector<int> rows;  ///< 2 node + component of each free component
  Matrix<double, 2, Dynamic> directions;
};

/// The motions of the contact vertices, in the order of their nodes, then those of the
/// opposite vertices, which have no rows.
struct VertexMotions {
  std::map<int, VertexMotion> of_vertex;
  std::vector<int> rows;  ///< of all free components that have one
  int component_count = 0;
};

VertexMotions vertex_motions(const ContactLine& line, const Flags& prescribed);

/// Trace operator T of all rows, [u]_rows = T w; 0 on held rows.
SparseMatrix trace_operator(const ContactLine& line, const Flags& held,
                            const VertexMotions& motions);

/// Q with displacement of the kept dofs = Q w.
SparseMatrix kept_operator(const VertexMotions& motions,
                           const std::vector<int>& kept);

}  // namespace ffcontact
