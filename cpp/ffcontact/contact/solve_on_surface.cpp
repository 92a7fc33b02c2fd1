// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/checks/surface_balance.hpp"
#include "ffcontact/contact/checks/surface_supports.hpp"
#include "ffcontact/contact/checks/unheld_bodies.hpp"
#include "ffcontact/contact/condensed_answer.hpp"
#include "ffcontact/contact/corrected_answer.hpp"
#include "ffcontact/contact/far_gaps.hpp"
#include "ffcontact/contact/multigrid/surface_unknowns.hpp"
#include "ffcontact/contact/multigrid_relation.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/contact/surface_relation.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"

namespace ffcontact {

namespace {

/// Single precision where it pays and prescribed displacements hold the body.
bool takes_single_precision(const SolidMesh& mesh, const ElasticSystem& system,
                            const ContactSettings& settings) {
  return settings.solver == ContactSolver::newton &&
         free_dof_count(system) >= settings.single_precision_from &&
         free_rigid_motions(mesh, system.prescribed).cols() == 0;
}

ContactSolution<3> corrected_solution(const SolidMesh& mesh,
                                      const StatedSurface& stated,
                                      Precision precision) {
  const auto stiffness = prepared_stiffness(
      stated.trace.trace.kept_dofs, stated.system, stated.settings, precision);
  CorrectedAnswer<3> answer(stated, surface_relation(stated, stiffness));
  if (!stiffness->is_exact() || answer.is_off()) answer.correct();
  ContactSolution<3> solution = answer.solution(mesh);
  solution.stiffness = stiffness;
  return solution;
}

/// Nothing where single precision is not enough.
std::optional<ContactSolution<3>> roughly_factored_solution(
    const SolidMesh& mesh, const StatedSurface& stated) {
  try {
    ContactSolution<3> solution =
        corrected_solution(mesh, stated, Precision::single);
    if (solution.accepted(stated.settings)) return solution;
  } catch (const Failure&) {
  }
  return std::nullopt;
}

bool can_take_multigrid(const StatedSurface& stated) {
  return stated.settings.solver == ContactSolver::newton &&
         !faces_itself(stated.contact, stated.trace);
}

/// Where it is asked for, or pays and there is no factor yet.
bool takes_multigrid(const StatedSurface& stated) {
  const ContactSettings& settings = stated.settings;
  const bool can = can_take_multigrid(stated);
  if (settings.linear == LinearSolver::multigrid && !can)
    refuse(
        "solver=\"multigrid\" is for solids whose contact vertices do not face "
        "each other: leave it out");
  if (settings.linear != LinearSolver::automatic)
    return settings.linear == LinearSolver::multigrid;
  return can && !settings.stiffness &&
         free_dof_count(stated.system) >= settings.multigrid_from;
}

/// Nothing where Newton's method does not converge with it.
std::optional<ContactSolution<3>> multigrid_solution(
    const SolidMesh& mesh, const StatedSurface& stated) {
  CorrectedAnswer<3> answer(stated, multigrid_relation(mesh.vertices, stated));
  if (answer.is_off()) answer.correct();
  ContactSolution<3> solution = answer.solution(mesh);
  solution.multigrid = Multigrid::used;
  if (solution.accepted(stated.settings)) return solution;
  return std::nullopt;
}

/// In single precision where that pays, and in full where that is not enough.
ContactSolution<3> factored_solution(const SolidMesh& mesh,
                                     const StatedSurface& stated) {
  const ContactSettings& settings = stated.settings;
  const bool is_rough =
      settings.stiffness
          ? settings.stiffness->precision() == Precision::single
          : takes_single_precision(mesh, stated.system, settings);
  if (is_rough)
    if (std::optional<ContactSolution<3>> solution =
            roughly_factored_solution(mesh, stated))
      return *std::move(solution);
  ContactSettings in_full = settings;
  if (is_rough) in_full.stiffness = nullptr;
  const StatedSurface again{stated.contact, stated.law, stated.system, in_full,
                            stated.trace};
  return held_or_refused(mesh, stated.contact, stated.system, [&] {
    return corrected_solution(mesh, again, Precision::full);
  });
}

ContactSolution<3> solution_on_surface(const SolidMesh& mesh,
                                       const ContactSurface& surface,
                                       const ContactLaw<3>& law,
                                       const ElasticSystem& system,
                                       const ContactSettings& settings) {
  SurfaceTrace trace = surface_trace(surface, law, system);
  trace.trace.free_motions =
      unheld_motions(mesh, system)(trace.trace.kept_dofs, Eigen::all);
  require_feasible(mesh, surface, law, system, trace.held);
  const StatedSurface stated{surface, law, system, settings, trace};
  if (!takes_multigrid(stated)) return factored_solution(mesh, stated);
  if (std::optional<ContactSolution<3>> solution =
          multigrid_solution(mesh, stated))
    return *std::move(solution);
  ContactSolution<3> solution = factored_solution(mesh, stated);
  solution.multigrid = Multigrid::in_vain;
  return solution;
}

}  // namespace

ContactSolution<3> solve_contact(const SolidMesh& mesh,
                                 const ContactSurface& surface,
                                 const ContactLaw<3>& law,
                                 const ElasticSystem& system,
                                 const ContactSettings& settings) {
  require_valid(mesh, surface, law, system, settings);
  require_balance(mesh, surface, law, system);
  return solved_with_far_gaps<3>(
      law, settings,
      [&](const ContactLaw<3>& near, const ContactSettings& with) {
        return solution_on_surface(mesh, surface, near, system, with);
      });
}

}  // namespace ffcontact
