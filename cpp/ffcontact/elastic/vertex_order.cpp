// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/vertex_order.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

/// Sums of the distances of vertices that A couples [mm].
struct Distances {
  double as_asked = 0, by_components = 0;
};

double distance(const Ref<const MatrixXd>& points, Index i, Index k) {
  return (points.col(i) - points.col(k)).norm();
}

/// In a row of A.
void add_row(const RowMatrixView& A, Index row,
             const Ref<const MatrixXd>& vertices, Distances& sums) {
  const Index d = vertices.rows(), n = vertices.cols();
  for (RowMatrixView::InnerIterator a(A, row); a; ++a) {
    if (a.value() == 0) continue;
    sums.as_asked += distance(vertices, row / d, a.col() / d);
    sums.by_components += distance(vertices, row % n, a.col() % n);
  }
}

bool is_by_components(const Distances& sums) {
  return sums.by_components < 0.8 * sums.as_asked;
}

const char* components(Index d) {
  return d == 2 ? "u, then v" : "u, v, then w";
}

}  // namespace

void require_order_of_vertices(const RowMatrixView& A,
                               const Ref<const MatrixXd>& vertices) {
  constexpr Index most_rows = 10000;
  const Index d = vertices.rows(), stride = 1 + A.rows() / most_rows;
  Distances sums;
  for (Index row = 0; row < A.rows(); row += stride)
    add_row(A, row, vertices, sums);
  if (is_by_components(sums))
    refuse("A is numbered by components, ", components(d),
           ", as blocks of scalar spaces are: assemble A and b on one space ",
           space_in_words(d));
}

}  // namespace ffcontact
