// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/coulomb_on_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/contact/residual_defect.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// What differs by this part of the largest value is the same but for rounding.
constexpr double rounding_of_values = 1e-12;

bool friction_varies(const ContactLine& line, const ContactLaw<2>& law, int e) {
  for (const ConesAtEnds& cones :
       {least_cones(line, law, e), most_cones(line, law, e)})
    for (const FrictionCone& cone : cones) {
      const double mu = law.friction[line.edge_node(0, e)];
      if (std::abs(cone.friction - mu) > rounding_of_values * mu) return true;
    }
  return false;
}

/// |w_t| at the nodes, and 0 at the ends of edges along which w_t changes its sign.
VectorXd slip_of_one_sign(const ContactLine& line, const VectorXd& w) {
  VectorXd slip = w.cwiseAbs();
  const double least = rounding_of_values * max_norm(w);
  for (int e = 0; e < line.edge_count(); ++e) {
    const double first = w[line.edge_node(0, e)],
                 second = w[line.edge_node(1, e)];
    if (first * second < 0 &&
        std::min(std::abs(first), std::abs(second)) > least)
      slip(line.edge_node.col(e)).setZero();
  }
  return slip;
}

/// Rows and columns that come twice.
template <class Values>
Values twice(const Values& values) {
  if constexpr (Values::ColsAtCompileTime == 1)
    return values.template replicate<2, 1>();
  else
    return values.template replicate<1, 2>();
}

WeightsByNode twice(const WeightsByNode& weights) {
  Triplets entries;
  const Index nodes = weights.rows();
  for (Index i = 0; i < nodes; ++i)
    for (WeightsByNode::InnerIterator w(weights, i); w; ++w)
      for (const Index row : {i, nodes + i})
        entries.emplace_back(row, w.col(), w.value());
  WeightsByNode both(2 * nodes, weights.cols());
  both.setFromTriplets(entries.begin(), entries.end());
  return both;
}

/// Nodes and edges twice. Traces match: conditions at the nodes are all there are, and what
/// faces which edge is left out.
ContactLine twice(const ContactLine& line) {
  ContactLine both{twice(line.vertex),
                   twice(line.normal),
                   twice(line.abscissa),
                   twice(line.edge_node),
                   twice(line.edge),
                   twice(line.length),
                   twice(line.part),
                   line.precision,
                   twice(line.opposite),
                   {},
                   {}};
  both.edge_node.rightCols(line.edge_count()).array() += line.node_count();
  return both;
}

/// mu |r_n| at the ends of the edges.
Matrix2Xd bounds_at_ends(const ContactLine& line, const VectorXd& mu,
                         const ContactDensities& tractions) {
  Matrix2Xd bounds = tractions.normal.cwiseAbs();
  for (int e = 0; e < line.edge_count(); ++e)
    bounds.col(e) *= mu[line.edge_node(0, e)];
  return bounds;
}

/// Of the ends of edges at the nodes.
VectorXd means_at_nodes(const ContactLine& line, const Matrix2Xd& at_ends) {
  VectorXd sum = VectorXd::Zero(line.node_count()), ends = sum;
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      sum[line.edge_node(end, e)] += at_ends(end, e);
      ++ends[line.edge_node(end, e)];
    }
  return sum.cwiseQuotient(ends);
}

/// Nothing given is 0.
VectorXd values_or_0(const VectorXd& values, int nodes) {
  return values.size() > 0 ? values : VectorXd::Zero(nodes);
}

ContactLaw<2> frictionless(int nodes) {
  ContactLaw<2> law;
  law.friction = law.gap = VectorXd::Zero(nodes);
  return law;
}

ContactLaw<2> without_bound(ContactLaw<2> law) {
  law.slip_bound.resize(0);
  law.between_nodes = {};
  return law;
}

}  // namespace

void require_coulomb_covered(const SolvedProblem<2>& solved,
                             const Estimate<2>& first) {
  const ContactLine& line = solved.contact;
  if (first.refinement || !line.matches())
    refuse(
        "coulomb=true is for bodies whose meshes match along the contact so "
        "far: give them the same vertices there, or state slipbound=");
  for (int e = 0; e < line.edge_count(); ++e) {
    if (turns(line, e))
      refuse(
          "coulomb=true is for straight contact lines so far: state "
          "slipbound=, "
          "e.g. that of the pressures found, on curves");
    if (friction_varies(line, solved.body.law, e))
      refuse(
          "coulomb=true is for one coefficient of friction along each line: "
          "give such a friction=");
  }
}

ContactLaw<2> with_bound_of(ContactLaw<2> law, const ContactLine& line,
                            const ContactDensities& tractions) {
  const Matrix2Xd bounds = bounds_at_ends(line, law.friction, tractions);
  law.multiplier = Multiplier::force;
  law.slip_bound = means_at_nodes(line, bounds);
  law.between_nodes = {bounds, bounds};
  law.friction.setZero();
  return law;
}

ContactConditions<2> conditions_of_coulomb(const ContactLine& line,
                                           const ContactLaw<2>& law,
                                           const VectorXd& u_hat) {
  const int p = line.node_count();
  const VectorXd slip = slip_of_one_sign(
                     line,
                     displacement_against_foundation(line, law, u_hat).row(1)),
                 gap = values_or_0(law.gap, p),
                 previous = values_or_0(law.previous, p);
  ContactConditions<2> conditions{twice(line), frictionless(2 * p)};
  for (int i = 0; i < 2 * p; ++i) {
    const int node = i % p;
    const double mu = law.friction[node], slope = i < p ? mu : -mu,
                 length = std::hypot(1, mu);
    conditions.contact.normal.col(i) =
        (line.normal.col(node) + slope * line.tangent(node)) / length;
    conditions.law.gap[i] =
        (gap[node] + slope * previous[node] + mu * slip[node]) / length;
  }
  return conditions;
}

CoulombTerms<2> coulomb_terms(const MatchedBodies<2>& bodies,
                              const Estimate<2>& first, double share) {
  const Matrix2Xd none = Matrix2Xd::Zero(2, bodies.contact().edge_count());
  const ContactLaw<2>& law = bodies.body().law;
  BoundPair<2> known = pair_of(bodies, bodies.body(), first);
  VectorXd friction =
      twice_psi<2>(bodies, law, first.displacement, {none, none});
  VectorXd error = error_of(bodies, known);
  return {share, std::move(known), without_bound(law), std::move(friction),
          std::move(error)};
}

BoundedQuantity<2> with_coulombs_law(BoundedQuantity<2> bounded,
                                     const ContactLaw<2>& law, double share) {
  const auto& [topology, line, system, body] = bounded.solved;
  const Estimate<2>& first = bounded.first;
  const VectorXd& u_hat = first.displacement;
  const VectorXd none = VectorXd::Zero(u_hat.size());
  bounded.coulomb = coulomb_terms(bounded.bodies, first, share);
  bounded.sought = bounded.clear = conditions_of_coulomb(line, law, u_hat);
  bounded.further_load =
      share * (nodal_forces<2>(bounded.bodies, first.tractions) -
               force_residual(system, u_hat, none));
  return bounded;
}

}  // namespace ffcontact
