// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "support/solid_problems.hpp"

namespace ffcontact::test {

/// What is wrong with a solution, all of it measured here: equilibrium of every free dof
/// with the forces, the law node by node. Relative to all forces and to |u|, which is
/// small where friction holds: 4.5e-10 at most in 9000 random problems.
struct Defects {
  double balance = 0, tension = 0, penetration = 0, normal = 0, cone = 0,
         slip = 0;
  double largest() const {
    return std::max({balance, tension, penetration, normal, cone, slip});
  }
};

/// The largest |F_t| at a node under a normal force.
inline double bound_at(const SolidProblem& problem, int node,
                       double normal_force) {
  const ContactLaw<3>& law = problem.law;
  const double area = problem.surface.area[node];
  const double bound = law.slip_bound.size() > 0
                           ? law.slip_bound[node] * area
                           : law.friction[node] * normal_force;
  return law.shear_limit.size() > 0
             ? std::min(bound, law.shear_limit[node] * area)
             : bound;
}

inline Defects defects(const SolidProblem& problem,
                       const ContactSolution<3>& solution) {
  Defects found;
  const ElasticSystem system = problem.system();
  const VectorXd& u = solution.displacement;
  VectorXd r = problem.b - problem.A * u;
  for (int i = 0; i < problem.surface.node_count(); ++i) {
    const Vector3d F = problem.surface.frame(i) * solution.force.col(i);
    r.segment<3>(3 * problem.surface.vertex[i]) += F;
    visit_opposite(problem.surface, i, [&](int vertex, double weight) {
      r.segment<3>(3 * vertex) -= weight * F;
    });
  }
  double forces = solution.force.norm() + 1e-300, length = u.norm() + 1e-300;
  for (int dof = 0; dof < r.size(); ++dof)
    if (!system.prescribed[dof])
      forces = std::max(forces, std::abs(problem.b[dof]));
  for (int dof = 0; dof < r.size(); ++dof)
    if (!system.prescribed[dof])
      found.balance = std::max(found.balance, std::abs(r[dof]) / forces);
  for (int i = 0; i < problem.surface.node_count(); ++i) {
    const int vertex = problem.surface.vertex[i];
    Vector3d jump = u.segment<3>(3 * vertex);
    visit_opposite(problem.surface, i, [&](int other, double weight) {
      jump -= weight * u.segment<3>(3 * other);
    });
    Vector3d v = problem.surface.frame(i).transpose() * jump;
    if (problem.law.gap.size() > 0) v[0] -= problem.law.gap[i];
    if (problem.law.previous.size() > 0)
      v.tail<2>() -= problem.law.previous.col(i);
    v /= length;
    const Vector3d F = solution.force.col(i) / forces;
    const double bound = bound_at(problem, i, -F[0] * forces) / forces,
                 Ft = F.tail<2>().norm();
    bool is_free =
        true;  // where a dof is prescribed the cone acts on what is left
    for (int c = 0; c < 3; ++c)
      is_free = is_free && !system.prescribed[3 * vertex + c];
    found.tension = std::max(found.tension, F[0]);
    found.cone = std::max(found.cone, Ft - bound);
    if (!is_free) continue;
    found.penetration = std::max(found.penetration, v[0]);
    found.normal = std::max(found.normal, std::min(-F[0], -v[0]));
    const double vt = v.tail<2>().norm();
    if (vt > 0)
      found.slip = std::max(
          found.slip,
          std::min(vt, (F.tail<2>() + bound * v.tail<2>() / vt).norm()));
  }
  return found;
}

}  // namespace ffcontact::test
