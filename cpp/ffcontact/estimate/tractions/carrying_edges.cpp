// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/carrying_edges.hpp"

#include <cmath>

#include "ffcontact/contact/law/friction_cone.hpp"

namespace ffcontact {

namespace {

/// Costs above this much of what tractions gain are far larger.
constexpr double far_larger = 10;

/// Mean costs on an edge of tractions of size 1 along (-1, -mu) and (-1, mu) [mm], or of
/// (-1, 0) with a bound that is given.
struct RayCosts {
  double backward_pull, forward_pull;
};

RayCosts ray_costs(const ConesAtEnds& least, const ConesAtEnds& most,
                   const Matrix2d& w) {
  RayCosts costs{0, 0};
  for (int end = 0; end < 2; ++end) {
    const double mu = least[end].friction, size = std::hypot(1, mu),
                 opening = -w(0, end), slip = w(1, end);
    const double paid = most[end].friction * std::abs(slip) + opening;
    costs.backward_pull += (paid - mu * slip) / (2 * size);
    costs.forward_pull += (paid + mu * slip) / (2 * size);
  }
  return costs;
}

bool slips_one_way(const Matrix2d& w) { return w(1, 0) * w(1, 1) > 0; }

Carrying carrying(const ConesAtEnds& least, const ConesAtEnds& most,
                  const Matrix2d& w, double worth) {
  const RayCosts costs = ray_costs(least, most, w);
  const bool backward_pays = costs.backward_pull <= worth,
             forward_pays = costs.forward_pull <= worth;
  if (!backward_pays && !forward_pays) return Carrying::nothing;
  const bool is_one_cone =
      least[0].friction == least[1].friction && std::isinf(least[0].limit);
  if ((backward_pays && forward_pays) || !is_one_cone || !slips_one_way(w))
    return Carrying::any;
  return backward_pays ? Carrying::slip_forward : Carrying::slip_backward;
}

}  // namespace

std::vector<Carrying> carrying_edges(const ContactLine& line,
                                     const ContactLaw<2>& law,
                                     const Ref<const VectorXd>& displacement,
                                     const Ref<const VectorXd>& stiffness,
                                     double largest) {
  std::vector<Carrying> result(line.edge_count(), Carrying::any);
  if (largest == 0) return result;
  const Matrix2Xd w = displacement_against_foundation(line, law, displacement);
  for (int e = 0; e < line.edge_count(); ++e) {
    Matrix2d on_edge;
    for (int end = 0; end < 2; ++end)
      on_edge.col(end) = w.col(line.edge_node(end, e));
    const double worth = far_larger * largest / stiffness[e];
    result[e] = carrying(least_cones(line, law, e), most_cones(line, law, e),
                         on_edge, worth);
  }
  return result;
}

}  // namespace ffcontact
