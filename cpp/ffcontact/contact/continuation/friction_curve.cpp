// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/continuation/friction_curve.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/contact/newton/surface_step.hpp"

namespace ffcontact {

namespace {

constexpr int most_corrections = 15;
/// Violation of the law by points of the curve.
constexpr double on_curve = 1e-8;
/// Distance to the next point, relative to the step, beyond which it is not the next.
constexpr double farthest = 10;

}  // namespace

FrictionCurve::FrictionCurve(const CondensedContact& contact,
                             const NodalLaw& law, const Flags& held,
                             const ContactRows& start, int most_systems)
    : contact_(contact),
      law_(law),
      held_(held),
      map_(contact, held),
      most_systems_(most_systems) {
  const Index n = start.P.size();
  weight_ = VectorXd::Zero(2 * n + 1);
  for (Index row = 0; row < n; ++row)
    if (!held[row]) {
      const double c = map_.stiffness(static_cast<int>(row / 3));
      weight_[row] = 1 / c;
      weight_[n + row] = c;
    }
  start_ = point(start, 0);
  if (const double size = product(start_, start_); size > 0) weight_ /= size;
  weight_[2 * n] = 1;
}

VectorXd FrictionCurve::point(const ContactRows& rows, double s) const {
  VectorXd z(weight_.size());
  z << rows.P, rows.v, s;
  return z;
}

ContactRows FrictionCurve::rows(const VectorXd& z) {
  const Index n = z.size() / 2;
  return {z.head(n), z.segment(n, n)};
}

NodalLaw FrictionCurve::law(const VectorXd& z) const {
  return with_share_of_bound(law_, std::max(share(z), 0.0));
}

double FrictionCurve::product(const VectorXd& y, const VectorXd& z) const {
  return weight_.cwiseProduct(y).dot(z);
}

double FrictionCurve::violation(const VectorXd& z) const {
  return surface_violation(contact_, law(z), held_, rows(z));
}

std::vector<NodeState> FrictionCurve::states(const VectorXd& z) const {
  return map_.states(law(z), rows(z));
}

ContactStates FrictionCurve::contact_states(const VectorXd& z) const {
  return ffcontact::contact_states(states(z));
}

std::optional<FrictionCurve::Line> FrictionCurve::line_at(const VectorXd& z) {
  if (systems_left() <= 0) return {};
  ++systems_;
  const ContactRows last = rows(z);
  const std::vector<NodeState> states = this->states(z);
  VectorXd bound(law_.node_count());
  for (int i = 0; i < law_.node_count(); ++i)
    bound[i] = law_.cone[i].bound(map_.tau(last, i)[0]);
  const std::optional<StepLine> step = surface_step_line(
      contact_, SurfaceEquations(held_, map_, states), last, bound);
  if (!step) return {};
  return Line{point(step->at, share(z)), point(step->along, 1),
              step->orientation};
}

VectorXd FrictionCurve::direction(const Line& line) const {
  return line.orientation * orientation_ * line.along /
         std::sqrt(product(line.along, line.along));
}

std::optional<FrictionCurve::Place> FrictionCurve::start() {
  const std::optional<Line> line = line_at(start_);
  if (!line) return {};
  orientation_ = line->orientation;
  return Place{start_, direction(*line)};
}

std::optional<FrictionCurve::Place> FrictionCurve::corrected(
    const VectorXd& from, const VectorXd& t, double h) {
  VectorXd z = from + h * t;
  for (int step = 0; step < most_corrections; ++step) {
    const std::optional<Line> line = line_at(z);
    if (!line) return {};
    const double missing = h - product(t, line->at - from);
    z = line->at + missing / product(t, line->along) * line->along;
    if (!z.allFinite()) return {};
    if (violation(z) > on_curve) continue;
    const VectorXd way = z - from;
    if (product(way, way) > std::pow(farthest * h, 2)) return {};
    return Place{z, direction(*line)};
  }
  return {};
}

std::optional<FrictionCurve::Place> FrictionCurve::beyond_kink(
    const Place& from, double h) {
  const std::optional<Line> line = line_at(from.z + h * from.t);
  if (!line) return {};
  std::optional<Place> next = corrected(from.z, direction(*line), h);
  if (next && contact_states(next->z) == contact_states(from.z)) return {};
  return next;
}

}  // namespace ffcontact
