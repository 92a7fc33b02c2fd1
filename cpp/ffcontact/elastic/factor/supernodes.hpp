// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// The pairs of neighbours of a graph, each once, by the lower one of the two numbers:
/// vertex v has neighbours[start[v] .. start[v + 1]).
struct Graph {
  std::vector<int> start{0}, neighbours;

  int vertex_count() const { return static_cast<int>(start.size()) - 1; }
};

/// The vertices in an order of elimination with little fill: METIS's nested dissection.
std::vector<int> dissection_order(const Graph& graph);

/// Wider ones are cut: what is stored above the diagonal of their blocks is lost.
constexpr int widest_supernode = 256;

/// The places of the entries of a Cholesky factor. A supernode is a run of columns that
/// have the same rows below their diagonal block.
struct Supernodes {
  /// s has the columns first_column[s] .. first_column[s + 1]
  std::vector<int> first_column{0};
  /// and the rows rows[first_row[s] .. first_row[s + 1]), ascending, its columns first
  std::vector<std::size_t> first_row{0};
  std::vector<int> rows;

  int count() const { return static_cast<int>(first_column.size()) - 1; }
  int column_count(int s) const {
    return first_column[s + 1] - first_column[s];
  }
  int row_count(int s) const {
    return static_cast<int>(first_row[s + 1] - first_row[s]);
  }
  const int* begin_of_rows(int s) const { return rows.data() + first_row[s]; }
  const int* end_of_rows(int s) const { return rows.data() + first_row[s + 1]; }
  /// Those below the diagonal block.
  const int* rows_below(int s) const {
    return begin_of_rows(s) + column_count(s);
  }
};

/// Those of the first columns of the factor of a matrix that is eliminated in its own
/// order, by CHOLMOD's symbolic analysis.
/// @param lower       the lower triangle of the matrix, rows of a column in any order
/// @param eliminated  how many columns
Supernodes supernodes(const SparseMatrix& lower, int eliminated);

}  // namespace ffcontact
