// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/nodal_law.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

Vector2d in_parts_of(double scale, const Vector2d& values) {
  return {relative(values[0], scale), relative(values[1], scale)};
}

/// Violation by P and v at one node, all of them and the cone's c and k relative.
double violation(const FrictionCone& cone, const Vector2d& P,
                 const Vector2d& v) {
  const double Pn = P[0], Pt = P[1], vn = v[0], vt = v[1];
  if (cone.bonded) return max_norm(v);
  const double bound = std::min(cone.cohesion - cone.friction * Pn, cone.limit);
  const double along = Pt * vt > 0 ? either_violation(Pt, vt) : 0.0;
  return std::max({Pn, vn, either_violation(Pn, vn),            // (3.17)-(3.19)
                   std::abs(Pt) - bound,                        // (3.20)
                   either_violation(bound - std::abs(Pt), vt),  // (3.21)
                   along});                                     // (3.22)
}

VectorXd in_units_of_P(const ContactLaw& law, const ContactLine& line,
                       const VectorXd& pressure) {
  if (law.multiplier == Multiplier::pressure || pressure.size() == 0)
    return pressure;
  return contact_mass(line) * pressure;
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

NodalLaw nodal_law(const ContactLaw& law, const ContactLine& line) {
  const VectorXd given = in_units_of_P(law, line, law.slip_bound),
                 limit = in_units_of_P(law, line, law.shear_limit);
  NodalLaw nodal{std::vector<FrictionCone>(line.node_count())};
  for (int i = 0; i < line.node_count(); ++i) {
    FrictionCone& cone = nodal.cone[i];
    (law.tresca() ? cone.cohesion : cone.friction) =
        law.tresca() ? given[i] : law.friction[i];
    if (law.limited()) cone.limit = limit[i];
    cone.bonded = law.bonded;
  }
  return nodal;
}

NodalLaw with_given_slip_limit(const NodalLaw& law,
                               const Ref<const VectorXd>& normal) {
  NodalLaw given;
  for (int i = 0; i < law.node_count(); ++i)
    given.cone.push_back({law.cone[i].bound(normal[i])});
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
  VectorXd felt = P;
  for (int i = 0; i < law.node_count(); ++i)
    if (is_idle(i)) felt[2 * i + 1] = 0;
  const double p_scale = std::max(scales.P, max_norm(felt));
  double largest = 0;
  for (int i = 0; i < law.node_count(); ++i) {
    const bool frictionless = is_idle(i) && !law.cone[i].bonded;
    const FrictionCone cone =
        frictionless ? FrictionCone{} : in_parts_of(p_scale, law.cone[i]);
    const Vector2d P_i = in_parts_of(p_scale, felt.segment<2>(2 * i)),
                   v_i = in_parts_of(scales.v, v.segment<2>(2 * i));
    largest = std::max(largest, violation(cone, P_i, v_i));
  }
  return largest;
}

double complementarity_defect(const ContactLine& line, const ContactLaw& law,
                              const HeldRows& held,
                              const Ref<const VectorXd>& displacement,
                              const Ref<const Matrix2Xd>& multiplier,
                              const LawScales& least) {
  const SparseMatrix W = weight_of_rows(law.multiplier, line);
  const VectorXd v =
      W * steered_displacement(line, law, held, displacement).reshaped();
  const VectorXd weight =
      weight_matrix(law.multiplier, line) * VectorXd::Ones(line.node_count());
  const double largest = largest_displacement(law, displacement);
  const double scale = std::max(least.v, largest * weight.maxCoeff());
  Flags idle(line.node_count(), 0);  // pressures load what is beside them
  if (law.multiplier == Multiplier::force)
    for (int i = 0; i < line.node_count(); ++i) idle[i] = held.row[2 * i + 1];
  return law_violation(nodal_law(law, line), multiplier.reshaped(), v,
                       {scale, least.P}, idle);
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
