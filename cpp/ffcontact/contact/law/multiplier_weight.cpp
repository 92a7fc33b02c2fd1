// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/multiplier_weight.hpp"

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// Adds the weight of node j in the rows of node i, its directions turned into theirs.
void add_weight(const ContactLine& line, int i, int j, double weight,
                Triplets& entries) {
  const Vector2d n_i = line.normal.col(i);
  const bool turned = n_i != line.normal.col(j);
  const double cosine = turned ? n_i.dot(line.normal.col(j)) : 1,
               sine = turned ? n_i.dot(line.tangent(j)) : 0;
  for (int c = 0; c < 2; ++c) {
    const double sign = c == 0 ? 1 : -1;
    entries.emplace_back(2 * i + c, 2 * j + c, weight * cosine);
    if (turned)
      entries.emplace_back(2 * i + c, 2 * j + 1 - c, sign * weight * sine);
  }
}

}  // namespace

SparseMatrix weight_matrix(Multiplier multiplier, const ContactLine& line) {
  if (multiplier == Multiplier::pressure) return contact_mass(line);
  SparseMatrix identity(line.node_count(), line.node_count());
  identity.setIdentity();
  return identity;
}

SparseMatrix weight_of_rows(Multiplier multiplier, const ContactLine& line) {
  const SparseMatrix W = weight_matrix(multiplier, line);
  Triplets entries;
  entries.reserve(4 * W.nonZeros());
  for (int j = 0; j < W.outerSize(); ++j)
    for (SparseMatrix::InnerIterator w(W, j); w; ++w)
      add_weight(line, static_cast<int>(w.row()), j, w.value(), entries);
  return packed(2 * W.rows(), 2 * W.cols(), entries);
}

}  // namespace ffcontact
