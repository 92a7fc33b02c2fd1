// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/fixed_point.hpp"

#include <algorithm>
#include <limits>

namespace ffcontact {

namespace {

constexpr double smallest_damping = 1.0 / 32;

Eigen::VectorXd normal_multipliers(const Eigen::VectorXd& P) {
  return Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<2>>(P.data(), P.size() / 2);
}

double relative_change(const Eigen::VectorXd& g, const Eigen::VectorXd& image) {
  const double scale = image.cwiseAbs().maxCoeff();
  return scale > 0 ? (image - g).cwiseAbs().maxCoeff() / scale : g.cwiseAbs().maxCoeff();
}

}  // namespace

FixedPointResult fixed_point(const CondensedContact& contact, const NodalLaw& law, std::vector<ContactState> state,
                             const NewtonSettings& settings) {
  FixedPointResult result;
  result.answer.violation = std::numeric_limits<double>::infinity();
  Eigen::VectorXd g = Eigen::VectorXd::Zero(law.friction.size());
  double damping = 1;
  int systems = 0;
  while (static_cast<int>(result.history.size()) < settings.max_iterations) {
    const NodalLaw given = law.tresca() ? law : with_given_slip_limit(law, g);
    ActiveSetResult step = active_set_newton(contact, given, state, settings);
    systems += step.iterations;
    state = step.state;

    const Eigen::VectorXd image = normal_multipliers(step.P);
    const double change = law.tresca() ? 0 : relative_change(g, image);
    if (!result.history.empty() && change > result.history.back()) damping = std::max(damping / 2, smallest_damping);
    result.history.push_back(change);
    g += damping * (image - g);

    step.violation = law_violation(law, step.P, step.v, motion_scale(contact, step.v));
    const bool solved = step.status == ContactStatus::converged;
    if (step.violation < result.answer.violation || result.history.size() == 1) result.answer = std::move(step);
    if (solved && (law.tresca() || result.answer.violation <= settings.tolerance)) break;
    result.answer.status = ContactStatus::not_converged;
  }
  result.answer.iterations = systems;
  return result;
}

}  // namespace ffcontact
