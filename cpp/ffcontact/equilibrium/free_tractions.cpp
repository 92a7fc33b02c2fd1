// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/free_tractions.hpp"

namespace ffcontact {

ConeConditions cone_conditions(const ContactLaw& law, int node) {
  const double slope = law.tresca() ? 0 : law.friction[node], bound = law.tresca() ? law.slip_bound[node] : 0;
  ConeConditions conditions;
  conditions.frictionless = slope == 0 && bound == 0;
  if (conditions.frictionless) {
    conditions.C = Eigen::RowVector2d(-1, 0);
    conditions.d = Eigen::VectorXd::Zero(1);
  } else {
    // For Coulomb's law the last two imply the first, but in a thin cone their rounding divided by mu is its.
    conditions.C.resize(3, 2);
    conditions.C << -1, 0, -slope, 1, -slope, -1;
    conditions.d = Eigen::Vector3d(0, -bound, -bound);
  }
  return conditions;
}

std::vector<int> contact_edge_numbers(const ContactLine& line, const Edges& edges) {
  std::vector<int> numbers(edges.count(), -1);
  for (int e = 0; e < line.edge_count(); ++e) {
    numbers[line.edge[e]] = e;
    if (line.against_a_body() && line.opposite_edge[e] >= 0) numbers[line.opposite_edge[e]] = e;
  }
  return numbers;
}

}  // namespace ffcontact
