// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/single_stiffness.hpp"

#include <algorithm>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/condensed/condensed_rows.hpp"
#include "ffcontact/linear/dense/blas.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"

namespace ffcontact {

namespace {

/// Rows that a thread multiplies at once.
constexpr int rows_at_once = 512;

/// The primary rows, normal ones first.
std::vector<int> normal_first(std::vector<int> rows) {
  std::stable_partition(rows.begin(), rows.end(),
                        [](int row) { return row % 3 == 0; });
  return rows;
}

/// How many places from a on follow each other.
int run_length(const std::vector<int>& places, std::size_t a) {
  std::size_t b = a + 1;
  while (b < places.size() && places[b] == places[b - 1] + 1) ++b;
  return static_cast<int>(b - a);
}

}  // namespace

SingleStiffness::SingleStiffness(const CondensedContact& contact)
    : row_(normal_first(contact.primary)),
      place_(contact.position.size(), -1),
      scale_(row_.size()),
      values_(size(), size()) {
  const VectorXd R = unknown_scales(contact).v;
  std::vector<int> position;
  for (int row : row_) {
    place_[row] = count_of(position);
    position.push_back(contact.position[row]);
    scale_[place_[row]] = R[position.back()];
  }
  const int n = size();
#pragma omp parallel for
  for (int j = 0; j < n; ++j) {
    const auto S_j = contact.S.col(position[j]);
    for (int i = 0; i < n; ++i)
      values_(i, j) =
          static_cast<float>(scale_[i] * S_j[position[i]] * scale_[j]);
  }
}

VectorXf SingleStiffness::product(const std::vector<int>& places,
                                  const VectorXf& x) const {
  const int n = size(), step = 1;
  const float plus = 1;
  VectorXf y = VectorXf::Zero(n);
  const SerialBlas serial;
#pragma omp parallel for schedule(dynamic, 1)
  for (int first = 0; first < n; first += rows_at_once) {
    const int rows = std::min(rows_at_once, n - first);
    for (std::size_t a = 0; a < places.size();) {
      const int columns = run_length(places, a);
      Blas<float>::gemv("N", &rows, &columns, &plus, &values_(first, places[a]),
                        &n, &x[a], &step, &plus, &y[first], &step);
      a += columns;
    }
  }
  return y;
}

MatrixXf SingleStiffness::lower_block(const std::vector<int>& places) const {
  const int n = count_of(places);
  MatrixXf block(n, n);
#pragma omp parallel for schedule(dynamic, 64)
  for (int j = 0; j < n; ++j)
    for (int i = j; i < n; ++i) block(i, j) = values_(places[i], places[j]);
  return block;
}

}  // namespace ffcontact
