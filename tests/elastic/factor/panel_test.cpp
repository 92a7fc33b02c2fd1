// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/panel.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Rows of the factor, ascending, with or without gaps; the first `columns` of them are
/// columns of a panel that begins before them.
struct AnyRows {
  std::vector<int> row;
  int columns, first, end, last;

  AnyRows(bool gaps, std::mt19937& random) {
    const int rows = 1 + static_cast<int>(random() % 9);
    columns = 1 + static_cast<int>(random() % rows);
    first = static_cast<int>(random() % 5);
    int next = first + static_cast<int>(random() % 3);
    for (int k = 0; k < rows; ++k, ++next) {
      if (gaps) next += static_cast<int>(random() % 3);
      row.push_back(next);
    }
    end = row[columns - 1] + 1 + static_cast<int>(random() % 2);
    last = next + 1;
  }
};

/// Distance of the panel, on and below the diagonal, from what dense algebra makes of it.
template <class Scalar>
double off(const AnyRows& any, std::mt19937& random) {
  using Dense = Matrix<Scalar, Dynamic, Dynamic>;
  const int rows = static_cast<int>(any.row.size()),
            depth = 1 + static_cast<int>(random() % 6);
  const Dense L = random_matrix(rows + 3, depth, random).cast<Scalar>();
  const Dense before =
      random_matrix(any.last, any.end - any.first, random).cast<Scalar>();
  std::vector<int> place(any.last);
  std::iota(place.begin(), place.end(), 0);
  Dense after = before;
  Matrix<Scalar, Dynamic, 1> product(rows * any.columns);
  const FactorRows<Scalar> last_rows{L.data() + 3,   rows + 3, depth,
                                     any.row.data(), rows,     any.columns};
  subtract_product(
      last_rows,
      Panel<Scalar>{any.first, any.end, after.data(), any.last, place.data()},
      product);
  Dense exact = before;
  for (int j = 0; j < any.columns; ++j)
    for (int i = j; i < rows; ++i)
      exact(any.row[i], any.row[j] - any.first) -=
          L.row(3 + i).dot(L.row(3 + j));
  double most = 0;
  for (int j = any.first; j < any.end; ++j)
    for (int i = j; i < any.last; ++i)
      most = std::max<double>(
          most, std::abs(after(i, j - any.first) - exact(i, j - any.first)));
  return most;
}

RC_GTEST_PROP(Panel, is_less_a_product_with_or_without_gaps, (Random random)) {
  for (const bool gaps : {false, true}) {
    const AnyRows any(gaps, random);
    RC_ASSERT(off<double>(any, random) < 1e-13);
    RC_ASSERT(off<float>(any, random) < 1e-5);
  }
}

}  // namespace
}  // namespace ffcontact
