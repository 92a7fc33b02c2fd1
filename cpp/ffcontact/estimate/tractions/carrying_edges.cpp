// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/carrying_edges.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/estimate/tractions/loaded_nodes.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Costs above this much of what tractions gain are far larger, and larger than what they cost
/// on another edge.
constexpr double far_larger = 10, larger = 3;

/// Mean costs on an edge of tractions of size 1 along (-1, -mu) and (-1, mu), or of (-1, 0)
/// with a bound that is given, over what such tractions gain.
struct RayCosts {
  double backward_pull, forward_pull;

  double least() const { return std::min(backward_pull, forward_pull); }
};

RayCosts ray_costs(const ConesAtEnds& least, const ConesAtEnds& most,
                   const Matrix2d& w, double gain) {
  RayCosts costs{0, 0};
  for (int end = 0; end < 2; ++end) {
    const double mu = least[end].friction, size = std::hypot(1, mu),
                 opening = -w(0, end), slip = w(1, end);
    const double paid = most[end].friction * std::abs(slip) + opening;
    costs.backward_pull += (paid - mu * slip) / (2 * size * gain);
    costs.forward_pull += (paid + mu * slip) / (2 * size * gain);
  }
  return costs;
}

bool slips_one_way(const Matrix2d& w) { return w(1, 0) * w(1, 1) > 0; }

Carrying carrying(const ConesAtEnds& cones, const Matrix2d& w,
                  const RayCosts& costs) {
  const bool backward_pays = costs.backward_pull <= far_larger,
             forward_pays = costs.forward_pull <= far_larger;
  if (!backward_pays && !forward_pays) return Carrying::nothing;
  const bool is_one_cone =
      cones[0].friction == cones[1].friction && std::isinf(cones[0].limit);
  if ((backward_pays && forward_pays) || !is_one_cone || !slips_one_way(w))
    return Carrying::any;
  return backward_pays ? Carrying::slip_forward : Carrying::slip_backward;
}

/// Has a node tractions, and no edge that costs little?
Flags nodes_in_need(const ContactLine& line, const std::vector<RayCosts>& costs,
                    const Ref<const Matrix2Xd>& traction) {
  Flags in_need = loaded_nodes(traction);
  for (int e = 0; e < line.edge_count(); ++e)
    if (costs[e].least() <= larger)
      for (const int i : line.edge_node.col(e)) in_need[i] = 0;
  return in_need;
}

}  // namespace

std::vector<Carrying> carrying_edges(const ContactLine& line,
                                     const ContactLaw<2>& law,
                                     const Ref<const VectorXd>& displacement,
                                     const Ref<const VectorXd>& stiffness,
                                     const Ref<const Matrix2Xd>& traction) {
  std::vector<Carrying> result(line.edge_count(), Carrying::any);
  const double largest = max_norm(traction);
  if (largest == 0) return result;
  const Matrix2Xd w = displacement_against_foundation(line, law, displacement);
  const auto at_ends = [&](int e) -> Matrix2d {
    return w(Eigen::all, line.edge_node.col(e));
  };
  std::vector<RayCosts> costs(line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e)
    costs[e] = ray_costs(least_cones(line, law, e), most_cones(line, law, e),
                         at_ends(e), largest / stiffness[e]);
  const Flags in_need = nodes_in_need(line, costs, traction);
  for (int e = 0; e < line.edge_count(); ++e) {
    const bool is_needed =
        in_need[line.edge_node(0, e)] || in_need[line.edge_node(1, e)];
    result[e] = costs[e].least() > larger && !is_needed
                    ? Carrying::nothing
                    : carrying(least_cones(line, law, e), at_ends(e), costs[e]);
  }
  return result;
}

}  // namespace ffcontact
