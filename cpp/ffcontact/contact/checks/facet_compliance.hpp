// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// 1 / (n' K_vv n) on the free components [mm/N], or 0 at a vertex that none moves along n.
template <int dim>
double nodal_compliance(const ElasticSystem& system, int vertex,
                        const VectorOf<dim>& n) {
  constexpr double along_the_line = 1e-3;  // below this n does not move a node
  double stiffness = 0;
  for (int i = 0; i < dim; ++i) {
    const int row = dof_of<dim>(vertex, i);
    if (system.prescribed[row] || std::abs(n[i]) < along_the_line) continue;
    for (int j = 0; j < dim; ++j)
      if (const int column = dof_of<dim>(vertex, j); !system.prescribed[column])
        stiffness += n[i] * system.stiffness.coeff(row, column) * n[j];
  }
  return relative(1, stiffness);
}

/// The mean of its vertices' nodal compliances along n, times its size.
template <int dim>
double facet_compliance(const Facets<dim>& facets, const ElasticSystem& system,
                        int facet, double size, const VectorOf<dim>& n) {
  double sum = 0;
  for (int v : facets.vertices.col(facet))
    sum += nodal_compliance<dim>(system, v, n);
  return size * sum / dim;
}

/// The mean of the logarithms of ratios.
class MeanRatio {
 public:
  /// Beyond this, as to a rigid trace, ratios count as this.
  static constexpr double largest_ratio = 1e12;

  void add(double own, double opposite, double weight) {
    if (own == 0 && opposite == 0) return;
    const double ratio =
        std::clamp(opposite / own, 1 / largest_ratio, largest_ratio);
    sum_ += weight * std::log(ratio);
    weight_ += weight;
  }
  double value() const { return weight_ > 0 ? std::exp(sum_ / weight_) : 1; }

 private:
  double sum_ = 0, weight_ = 0;
};

}  // namespace ffcontact
