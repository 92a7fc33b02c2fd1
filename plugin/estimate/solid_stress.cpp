// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/solid_stress.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ffcontact/base/packed.hpp"

namespace ffcontact::plugin {

namespace {

constexpr std::array stress_names = {"sxx", "syy", "szz", "syz", "sxz", "sxy"};

/// Values at the corners of a tetrahedron as those at its shrunk vertices.
Matrix<double, 6, 4> at_shrunk_vertices(const Matrix<double, 6, 4>& corners) {
  constexpr double shrink = 1e-4;
  return (1 - shrink) * corners +
         shrink * corners.rowwise().mean().replicate<1, 4>();
}

bool is_wanted(const NamedArguments& named, int body, int bodies) {
  return std::any_of(stress_names.begin(), stress_names.end(),
                     [&](const char* name) {
                       return named.given(name_of_body(name, body, bodies));
                     });
}

}  // namespace

CellStresses<3> p1dc_arrays(const std::vector<SubcellStress<3>>& stress) {
  CellStresses<3> values(6, 16 * count_of(stress));
  Index first = 0;
  for (const SubcellStress<3>& of_tetrahedron : stress)
    for (int k = 0; k < 4; ++k, first += 4) {
      // k+1, k+2, k+3, barycentre
      const auto corners =
          at_shrunk_vertices(of_tetrahedron.middleCols<4>(4 * k));
      for (int c = 0; c < 4; ++c)
        values.col(first + (k + 1 + c) % 4) = corners.col(c);
    }
  return values;
}

void put_solid_stress(Stack stack, const NamedArguments& named,
                      const ContactProblem<3>& problem,
                      const Topology<3>& topology, const Estimate<3>& estimate,
                      const SolvedBody<3>& body) {
  const std::vector<int>& first = problem.joined.first_cell;
  const int bodies = problem.body_count();
  for (int k = 0; k < bodies; ++k) {
    if (!is_wanted(named, k, bodies)) continue;
    std::vector<SubcellStress<3>> stress;
    for (int t = first[k]; t < first[k + 1]; ++t)
      stress.push_back(stress_of(topology, estimate, body, t));
    const CellStresses<3> values = p1dc_arrays(stress);
    for (int c = 0; c < 6; ++c)
      named.put(stack, name_of_body(stress_names[c], k, bodies),
                values.row(c).transpose());
  }
}

}  // namespace ffcontact::plugin
