// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/system_parts.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/parallel/mesh_parts.hpp"

namespace ffcontact {

namespace {

void take_prescribed(const ElasticSystem& part, const std::vector<int>& dof,
                     ElasticSystem& whole) {
  constexpr double of_rounding = 1e-12;
  for (int i = 0; i < part.dof_count(); ++i) {
    if (!part.prescribed[i]) continue;
    const double value = part.prescribed_value[i];
    double& known = whole.prescribed_value[dof[i]];
    if (whole.prescribed[dof[i]] &&
        !(std::abs(known - value) <=
          of_rounding * std::max(std::abs(known), std::abs(value))))
      refuse("two parts prescribe ", known, " and ", value, " to dof ", dof[i],
             " of the whole mesh");
    whole.prescribed[dof[i]] = 1;
    known = value;
  }
}

/// Rows and columns of the part's own prescribed dofs hold no stiffness.
void add_entries(const ElasticSystem& part, const std::vector<int>& dof,
                 ElasticSystem& whole, Triplets& entries) {
  for (int i = 0; i < part.dof_count(); ++i) {
    if (part.prescribed[i]) continue;
    for (RowMatrix::InnerIterator e(part.stiffness, i); e; ++e) {
      if (part.prescribed[e.col()]) continue;
      const int row = dof[i], column = dof[e.col()];
      entries.emplace_back(row, column, e.value());
      if (whole.prescribed[column])
        whole.load[row] -= e.value() * whole.prescribed_value[column];
    }
    whole.load[dof[i]] += part.load[i];
  }
}

}  // namespace

std::vector<int> dofs_of_part(const std::vector<int>& vertex, int dimension) {
  std::vector<int> dofs;
  for (int v : vertex)
    for (int c = 0; c < dimension; ++c) dofs.push_back(dimension * v + c);
  return dofs;
}

ElasticSystem joined_parts(const std::vector<ElasticSystem>& parts,
                           const std::vector<std::vector<int>>& vertex) {
  if (parts.empty()) refuse("there are no parts of a system");
  const int dimension = parts.front().dimension,
            n = dimension * count_in_whole(vertex);
  ElasticSystem whole{RowMatrix(n, n), VectorXd::Zero(n), Flags(n, 0),
                      VectorXd::Zero(n), dimension};
  std::vector<std::vector<int>> dofs;
  for (std::size_t r = 0; r < parts.size(); ++r) {
    dofs.push_back(dofs_of_part(vertex[r], dimension));
    require_size("the load of a part", parts[r].dof_count(),
                 count_of(dofs.back()));
    take_prescribed(parts[r], dofs.back(), whole);
  }
  Triplets entries;
  for (std::size_t r = 0; r < parts.size(); ++r)
    add_entries(parts[r], dofs[r], whole, entries);
  whole.stiffness = packed<RowMatrix>(n, n, entries);
  whole.load = on_free_dofs(whole, std::move(whole.load));
  return whole;
}

}  // namespace ffcontact
