// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/surface_solution.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/balance.hpp"
#include "ffcontact/contact/refinement.hpp"
#include "ffcontact/contact/surface_fixed_point.hpp"
#include "ffcontact/contact/surface_newton.hpp"
#include "ffcontact/contact/surface_trace.hpp"

namespace ffcontact {

namespace {

/// Newton is given this many linear systems before the fixed point goes on.
constexpr int most_newton_systems = 100;
/// Penetrations of prescribed vertices below this part of the displacements are rounding.
constexpr double penetration_of_rounding = 1e-10;

/// @throws std::invalid_argument  if prescribed dofs hold a vertex inside the foundation
void require_clear(const SolidMesh& mesh, const ContactSurface& surface,
                   const SurfaceLaw& law, const ElasticSystem& system,
                   const std::vector<char>& held) {
  const VectorXd& given = system.prescribed_value;
  const Matrix3Xd v = displacement_against_foundation(surface, law, given);
  const double least =
      penetration_of_rounding * largest_displacement(law, given);
  for (int i = 0; i < surface.node_count(); ++i)
    if (held[3 * i] && v(0, i) > least) {
      const Vector3d x = mesh.place(surface.vertex[i]);
      refuse(
          "no admissible displacement: prescribed displacements hold vertex ",
          surface.vertex[i], " (", x.x(), ", ", x.y(), ", ", x.z(), ") ",
          v(0, i),
          " inside the foundation; prescribe less there, or a larger gap=");
    }
}

void require_sound(const SolidMesh& mesh, const ContactSurface& surface,
                   const SurfaceLaw& law, const ElasticSystem& system,
                   const ContactSettings& settings) {
  require_valid(law, surface);
  require_size("A", system.dof_count(), 3 * mesh.vertices.cols());
  require_valid(settings, surface.node_count());
  require_balance(mesh, surface, law, system);
}

/// Newton from the given states, and where these lead nowhere from sticking nodes.
ActiveSetResult newton_answer(const CondensedContact& contact,
                              const NodalLaw& law,
                              const std::vector<char>& held,
                              const std::vector<ContactState>& start,
                              const NewtonSettings& limits) {
  const std::vector<ContactState> stick(law.node_count(), ContactState::stick);
  ActiveSetResult best = surface_newton(
      contact, law, held, start,
      {std::min(most_newton_systems, limits.max_iterations), limits.tolerance});
  const int left = limits.max_iterations - best.iterations;
  if (best.status == ContactStatus::converged || left <= 0 || start == stick)
    return best;
  ActiveSetResult again =
      surface_newton(contact, law, held, stick,
                     {std::min(most_newton_systems, left), limits.tolerance});
  const int systems = best.iterations + again.iterations;
  if (again.is_better_than(best)) best = std::move(again);
  best.iterations = systems;
  return best;
}

FixedPointResult condensed_answer(const CondensedContact& contact,
                                  const NodalLaw& law,
                                  const std::vector<char>& held,
                                  const ContactSettings& settings) {
  std::vector<ContactState> start = settings.initial_state;
  if (start.empty()) start.assign(law.node_count(), ContactState::stick);
  const NewtonSettings limits{settings.max_iterations, settings.tolerance};
  if (settings.solver == ContactSolver::fixed_point)
    return surface_fixed_point(contact, law, held, start, limits);
  FixedPointResult newton{newton_answer(contact, law, held, start, limits), {}};
  const int left = limits.max_iterations - newton.answer.iterations;
  if (newton.answer.status == ContactStatus::converged || left <= 0)
    return newton;
  FixedPointResult path =
      surface_fixed_point(contact, law, held, start, {left, limits.tolerance});
  const int systems = newton.answer.iterations + path.answer.iterations;
  if (path.answer.is_better_than(newton.answer)) newton = std::move(path);
  newton.answer.iterations = systems;
  return newton;
}

/// What W multiplies displacements by at most.
double largest_weight(const SurfaceLaw& law, const ContactSurface& surface) {
  return law.multiplier == Multiplier::force ? 1 : surface.area.maxCoeff();
}

void put_multipliers(const ContactSurface& surface, const SurfaceLaw& law,
                     const SurfaceTrace& trace, const VectorXd& P,
                     SurfaceSolution& solution) {
  const int nodes = surface.node_count();
  solution.force = (trace.weight.transpose() * P).reshaped(3, nodes);
  solution.pressure = law.multiplier == Multiplier::pressure
                          ? Matrix3Xd(P.reshaped(3, nodes))
                          : Matrix3Xd(solution.force *
                                      surface.area.cwiseInverse().asDiagonal());
}

}  // namespace

SurfaceSolution solve_contact(const SolidMesh& mesh,
                              const ContactSurface& surface,
                              const SurfaceLaw& law,
                              const ElasticSystem& system,
                              const ContactSettings& settings) {
  require_sound(mesh, surface, law, system, settings);
  SurfaceTrace trace = surface_trace(surface, law, system);
  require_clear(mesh, surface, law, system, trace.held);

  // 1. The body as the surface sees it, P = S v - g.
  SurfaceSolution solution;
  solution.stiffness = settings.stiffness;
  if (!solution.stiffness)
    solution.stiffness = std::make_shared<const CondensedStiffness>(
        system, trace.trace.kept_dofs);
  const CondensedStiffness& stiffness = *solution.stiffness;
  const CondensedContact contact = condensed_contact(
      std::move(trace.trace), trace.primary, system.load, stiffness);

  // 2. The law.
  const NodalLaw cones = nodal_law(law, surface);
  FixedPointResult condensed =
      condensed_answer(contact, cones, trace.held, settings);
  const ActiveSetResult& answer = condensed.answer;
  solution.iterations = answer.iterations;
  solution.history = std::move(condensed.history);
  solution.state = answer.state;

  // 3. Back to the whole body.
  const VectorXd kept = kept_displacement(contact, answer.v(contact.primary),
                                          answer.P(contact.dependent));
  solution.displacement =
      stiffness.extended(contact.load, kept) + system.prescribed_value;
  put_multipliers(surface, law, trace, answer.P, solution);

  // 4. What the theory promises, measured.
  const VectorXd& u = solution.displacement;
  solution.residual = equilibrium_defect(
      system, u, nodal_load(surface, solution.force, u.size()),
      largest_displacement(law, VectorXd::Zero(1)));
  const VectorXd v =
      trace.weight *
      displacement_against_foundation(surface, law, u).reshaped();
  LawScales scales = law_scales(contact, answer.v);
  scales.v = std::max(
      scales.v, largest_weight(law, surface) * largest_displacement(law, u));
  solution.complementarity = surface_violation(cones, answer.P, v, scales);
  solution.status = judged_status(answer.status, solution.complementarity,
                                  solution.residual, settings.tolerance);
  return solution;
}

}  // namespace ffcontact
