// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/schur_products.hpp"

#include <map>
#include <numeric>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/dense/symmetric_product.hpp"

namespace ffcontact {

void require_whole(SchurStorage storage) {
  if (storage != SchurStorage::whole)
    refuse(
        "coulomb= and bound= need Schur's complement as one matrix, "
        "which is distributed here (schur=\"distributed\", or too many contact "
        "dofs for the memory)");
}

VectorXd SchurProducts::diagonal() const {
  std::vector<int> alone(size());
  std::iota(alone.begin(), alone.end(), 0);
  return diagonal_blocks(alone).diagonal();
}

VectorXd WholeSchur::product(const VectorXd& x) const {
  return symmetric_product(S_, x);
}

MatrixXd WholeSchur::congruent(const SparseMatrix& R) const {
  return ffcontact::congruent(S_, R);
}

SparseMatrix WholeSchur::diagonal_blocks(const std::vector<int>& group) const {
  std::map<int, std::vector<int>> members;
  for (int k = 0; k < count_of(group); ++k) members[group[k]].push_back(k);
  Triplets entries;
  for (const auto& [of_group, own] : members)
    for (int i : own)
      for (int j : own) entries.emplace_back(i, j, S_(i, j));
  return packed(size(), size(), entries);
}

}  // namespace ffcontact
