// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

/// Lists that grew one by one as matrices.
namespace ffcontact {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Its size as meshes count.
template <class List>
int count_of(const List& list) {
  return static_cast<int>(list.size());
}

/// @return the values one below the other [n]
template <class Value>
Matrix<Value, Dynamic, 1> packed(const std::vector<Value>& values) {
  return Map<const Matrix<Value, Dynamic, 1>>(values.data(), count_of(values));
}

/// @return the vectors one beside the other [size x n]
template <class Value, int size>
Matrix<Value, size, Dynamic> packed(
    const std::vector<Matrix<Value, size, 1>>& columns) {
  Matrix<Value, size, Dynamic> matrix(size, count_of(columns));
  Index next = 0;
  for (const auto& column : columns) matrix.col(next++) = column;
  return matrix;
}

/// @return the sum of the entries [rows x columns]
template <class Sparse = SparseMatrix>
Sparse packed(Index rows, Index columns, const Triplets& entries) {
  Sparse matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace ffcontact
