// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/fixed_point.hpp"

#include <algorithm>
#include <limits>

#include "ffcontact/contact/convex_contact.hpp"

namespace ffcontact {

namespace {

constexpr double smallest_damping = 1.0 / 32;
/// Newton from the states of a step is given this many linear systems.
constexpr int newton_systems = 10;

VectorXd normal_multipliers(const VectorXd& P) {
  return Map<const VectorXd, 0, Eigen::InnerStride<2>>(P.data(), P.size() / 2);
}

double relative_change(const VectorXd& g, const VectorXd& image) {
  const double scale = image.cwiseAbs().maxCoeff();
  return scale > 0 ? (image - g).cwiseAbs().maxCoeff() / scale
                   : g.cwiseAbs().maxCoeff();
}

/// Where g is 0 P(g) is frictionless, and its states know no direction. Coulomb's law has
/// one as soon as P_n is not quite 0.
void follow_slip(const NodalLaw& law, const NodalLaw& given,
                 ActiveSetResult& answer) {
  for (std::size_t i = 0; i < answer.state.size(); ++i) {
    const int node = static_cast<int>(i);
    if (law.cone[node].frictionless() || !given.cone[node].frictionless() ||
        is_open(answer.state[i]))
      continue;
    const double vt = answer.v[2 * node + 1];
    answer.state[i] = vt > 0   ? ContactState::slip_forward
                      : vt < 0 ? ContactState::slip_backward
                               : ContactState::stick;
  }
}

}  // namespace

FixedPointResult fixed_point(const CondensedContact& contact,
                             const NodalLaw& law,
                             std::vector<ContactState> state,
                             const NewtonSettings& settings, bool with_newton) {
  FixedPointResult result;
  result.answer.violation = std::numeric_limits<double>::infinity();
  VectorXd g = VectorXd::Zero(law.node_count());
  const bool convex = law.is_convex();
  double damping = 1;
  int systems = 0;
  const auto left = [&] { return settings.max_iterations - systems; };
  while (left() > 0) {
    const NodalLaw given = with_given_slip_limit(law, g);
    ActiveSetResult step =
        solve_convex(contact, given, state, {left(), settings.tolerance});
    systems += step.iterations;
    const bool same_states = step.state == state,
               solved = step.status == ContactStatus::converged;
    state = step.state;

    const VectorXd image = normal_multipliers(step.P);
    const double change = convex ? 0 : relative_change(g, image);
    if (!result.history.empty() && change > result.history.back())
      damping = std::max(damping / 2, smallest_damping);
    result.history.push_back(change);
    g += damping * (image - g);

    step.violation = law_violation(contact, law, {step.P, step.v});
    const bool found =
        solved && (convex || step.violation <= settings.tolerance);
    if (found || step.violation < result.answer.violation ||
        result.history.size() == 1)
      result.answer = std::move(step);
    if (found) {  // the law at g is Coulomb's but for the last digits
      follow_slip(law, given, result.answer);
      put_into_law(law, result.answer.state, result.answer.P);
      break;
    }
    result.answer.status = ContactStatus::not_converged;
    if (!with_newton || same_states || left() <= 0) continue;
    ActiveSetResult newton = active_set_newton(
        contact, law, state,
        {std::min(newton_systems, left()), settings.tolerance});
    systems += newton.iterations;
    if (newton.status != ContactStatus::converged) continue;
    result.answer = std::move(newton);
    break;
  }
  result.answer.iterations = systems;
  return result;
}

}  // namespace ffcontact
