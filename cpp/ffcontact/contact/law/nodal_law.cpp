// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/nodal_law.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// P or v of a node.
using AtNode = Matrix<double, Dynamic, 1, 0, 3, 1>;

AtNode in_parts_of(double scale, AtNode values) {
  for (double& value : values) value = relative(value, scale);
  return values;
}

/// |P_t + b v_t / |v_t||: 0 where the force is the largest and opposes the slip.
double missed_slip(const AtNode& Pt, const AtNode& vt, double bound) {
  return (Pt + bound * vt.stableNormalized()).norm();
}

/// Violation by P and v at one node, all of them and the cone's c and k relative.
double violation(const FrictionCone& cone, const AtNode& P, const AtNode& v) {
  if (cone.bonded) return max_norm(v);
  const Index tangents = P.size() - 1;
  const AtNode Pt = P.tail(tangents), vt = v.tail(tangents);
  const double bound =
      std::min(cone.cohesion - cone.friction * P[0], cone.limit);
  return std::max({P[0], v[0], either_violation(P[0], v[0]),  // (3.17)-(3.19)
                   Pt.norm() - bound,                         // (3.20)
                   either_violation(missed_slip(Pt, vt, bound),
                                    vt.norm())});  // (3.21), (3.22)
}

FrictionCone in_parts_of(double scale, FrictionCone cone) {
  cone.cohesion = relative(cone.cohesion, scale);
  cone.limit = relative(cone.limit, scale);
  return cone;
}

}  // namespace

bool NodalLaw::is_convex() const {
  return std::none_of(cone.begin(), cone.end(), [](const FrictionCone& c) {
    return c.depends_on_contact();
  });
}

bool NodalLaw::is_bonded() const {
  return std::all_of(cone.begin(), cone.end(),
                     [](const FrictionCone& c) { return c.bonded; });
}

NodalLaw with_given_slip_limit(const NodalLaw& law,
                               const Ref<const VectorXd>& normal) {
  NodalLaw given;
  for (int i = 0; i < law.node_count(); ++i) {
    FrictionCone cone = law.cone[i];
    if (!cone.bonded) cone = {cone.bound(normal[i])};
    given.cone.push_back(cone);
  }
  return given;
}

NodalLaw with_share_of_bound(const NodalLaw& law, double s) {
  NodalLaw share = law;
  for (FrictionCone& cone : share.cone) {
    cone.cohesion *= s;
    cone.friction *= s;
    if (cone.limit < infinity) cone.limit *= s;
  }
  return share;
}

double law_violation(const NodalLaw& law, const Ref<const VectorXd>& P,
                     const Ref<const VectorXd>& v, const LawScales& scales,
                     const Flags& idle) {
  if (!P.allFinite() || !v.allFinite()) return infinity;
  const auto is_idle = [&idle](int node) {
    return !idle.empty() && idle[node] != 0;
  };
  const Index d = P.size() / std::max(law.node_count(), 1);
  VectorXd felt = P;
  for (int i = 0; i < law.node_count(); ++i)
    if (is_idle(i)) felt.segment(d * i + 1, d - 1).setZero();
  const double largest_felt = max_norm(felt);
  double p_scale = std::max(scales.P, largest_felt);
  for (int i = 0; largest_felt == 0 && i < law.node_count(); ++i)
    if (!is_idle(i)) p_scale = std::max(p_scale, law.cone[i].cohesion);
  double largest = 0;
  for (int i = 0; i < law.node_count(); ++i) {
    const bool frictionless = is_idle(i) && !law.cone[i].bonded;
    const FrictionCone cone =
        frictionless ? FrictionCone{} : in_parts_of(p_scale, law.cone[i]);
    const AtNode P_i = in_parts_of(p_scale, felt.segment(d * i, d)),
                 v_i = in_parts_of(scales.v, v.segment(d * i, d));
    largest = std::max(largest, violation(cone, P_i, v_i));
  }
  return largest;
}

void put_into_law(const NodalLaw& law, const ContactStates& state,
                  VectorXd& P) {
  for (int i = 0; i < law.node_count(); ++i) {
    Vector2d clamped = law.cone[i].clamped(P.segment<2>(2 * i));
    const int slip = slip_sign(state[i]);
    if (slip != 0) clamped[1] = -slip * law.cone[i].bound(clamped[0]);
    P.segment<2>(2 * i) = clamped;
  }
}

}  // namespace ffcontact
