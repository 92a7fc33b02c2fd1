// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/schur_block.hpp"

#include <algorithm>
#include <map>

namespace ffcontact {

namespace {

/// Rows that a thread multiplies at once.
constexpr int rows_of_a_thread = 256;

template <class Values>
VectorXd multiplied(const Values& values, const VectorXd& x) {
  const auto rows = static_cast<int>(values.rows());
  VectorXd y = VectorXd::Zero(rows);
#pragma omp parallel for schedule(dynamic, 1)
  for (int first = 0; first < rows; first += rows_of_a_thread) {
    const int count = std::min(rows_of_a_thread, rows - first);
    auto own = y.segment(first, count);
    for (Index j = 0; j < values.cols(); ++j)
      own += x[j] * values.col(j).segment(first, count).template cast<double>();
  }
  return y;
}

/// Of each number of S its place in a list, or -1.
std::vector<int> places_in(const std::vector<int>& list, Index size) {
  std::vector<int> place(size, -1);
  for (int k = 0; k < count_of(list); ++k) place[list[k]] = k;
  return place;
}

template <class Values>
MatrixXd congruent_of(const Values& values, const SchurBlock& block,
                      const SparseMatrix& R) {
  const std::vector<int> row = places_in(block.row, R.rows()),
                         column = places_in(block.column, R.rows());
  MatrixXd result = MatrixXd::Zero(R.cols(), R.cols());
#pragma omp parallel for schedule(dynamic, 16)
  for (Index c = 0; c < R.cols(); ++c) {
    VectorXd y = VectorXd::Zero(values.rows());
    for (SparseMatrix::InnerIterator e(R, c); e; ++e)
      if (const int j = column[e.row()]; j >= 0)
        y += e.value() * values.col(j).template cast<double>();
    for (Index r = 0; r < R.cols(); ++r)
      for (SparseMatrix::InnerIterator e(R, r); e; ++e)
        if (const int i = row[e.row()]; i >= 0)
          result(r, c) += e.value() * y[i];
  }
  return result;
}

}  // namespace

std::vector<int> dealt_numbers(int size, int length, int place, int count) {
  std::vector<int> numbers;
  for (int first = place * length; first < size; first += count * length)
    for (int k = first; k < std::min(first + length, size); ++k)
      numbers.push_back(k);
  return numbers;
}

VectorXd product_part(const SchurBlock& block, const VectorXd& x) {
  const VectorXd own = x(block.column);
  return std::visit(
      [&own](const auto& values) { return multiplied(values, own); },
      block.values);
}

MatrixXd congruent_part(const SchurBlock& block, const SparseMatrix& R) {
  return std::visit(
      [&](const auto& values) { return congruent_of(values, block, R); },
      block.values);
}

Triplets diagonal_part(const SchurBlock& block, const std::vector<int>& group) {
  std::map<int, std::vector<int>> rows;
  for (int k = 0; k < count_of(block.row); ++k)
    rows[group[block.row[k]]].push_back(k);
  Triplets entries;
  for (int j = 0; j < count_of(block.column); ++j) {
    const auto own = rows.find(group[block.column[j]]);
    if (own == rows.end()) continue;
    for (int i : own->second)
      entries.emplace_back(
          block.row[i], block.column[j],
          std::visit(
              [i, j](const auto& values) { return double(values(i, j)); },
              block.values));
  }
  return entries;
}

}  // namespace ffcontact
