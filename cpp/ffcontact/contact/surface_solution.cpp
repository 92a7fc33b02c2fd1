// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/surface_solution.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/checks/surface_balance.hpp"
#include "ffcontact/contact/checks/surface_supports.hpp"
#include "ffcontact/contact/checks/unheld_bodies.hpp"
#include "ffcontact/contact/condensed_answer.hpp"
#include "ffcontact/contact/multigrid/step_multigrid.hpp"
#include "ffcontact/contact/multigrid_relation.hpp"
#include "ffcontact/contact/refinement.hpp"
#include "ffcontact/contact/surface_relation.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

void require_sound(const SolidMesh& mesh, const ContactSurface& surface,
                   const SurfaceLaw& law, const ElasticSystem& system,
                   const ContactSettings& settings) {
  require_valid(law, surface);
  require_size("A", system.dof_count(), 3 * mesh.vertices.cols());
  require_valid(settings, surface.node_count());
  require_balance(mesh, surface, law, system);
}

/// An answer on the condensed relation, and what the whole body makes of it.
class Answer {
 public:
  Answer(const StatedSurface& stated,
         std::shared_ptr<const CondensedStiffness> stiffness)
      : Answer(stated, surface_relation(stated, stiffness)) {
    solution_.stiffness = std::move(stiffness);
  }

  Answer(const StatedSurface& stated, std::unique_ptr<SurfaceRelation> relation)
      : stated_(stated), relation_(std::move(relation)) {
    solution_.displacement = stated.system.prescribed_value;
    FixedPointResult condensed = relation_->answer();
    solution_.history = std::move(condensed.history);
    take(std::move(condensed.answer));
  }

  /// Corrects the answer of an inexact factor K~: with u the last displacement
  ///     K~ (u' - u) = b - K u + B' P',   (P', v(u')) in the law,
  /// so that u' = u solves the problem itself, as long as that lowers what is missed.
  void correct() {
    constexpr int most_corrections = 20;
    for (int k = 0; k < most_corrections && can_gain(); ++k) {
      const SurfaceSolution last = solution_;
      const double missed = this->missed();
      const ContactRows rows{condensed_.P, condensed_.v};
      relation_->put_loads(
          force_residual(stated_.system, solution_.displacement, no_forces()),
          stated_.v_of(solution_.displacement, solution_.force), rows.P);
      take(relation_->answer_near(rows, limits()));
      solution_.iterations += last.iterations;
      if (this->missed() < missed / least_gain) continue;
      solution_ = last;
      return;
    }
  }

  /// Is more left than rounding? Of an inexact factor, or where a body is much softer than
  /// another: its forces are not much above the rounding of the other's.
  bool is_off() const { return missed() > stated_.settings.tolerance; }

  SurfaceSolution solution() && { return std::move(solution_); }

 private:
  static constexpr int most_systems = 30;  ///< of a correction
  /// Of what is missed by a correction.
  static constexpr double least_gain = 2;
  /// What a violation may be of the residual before a correction, which gains more.
  static constexpr double beside_residual = 1e-3;

  VectorXd no_forces() const {
    return VectorXd::Zero(stated_.system.dof_count());
  }
  /// The law is met as well as the correction after this one will need it.
  NewtonSettings limits() const {
    const double enough =
        std::max(beside_tolerance(), beside_residual * solution_.residual);
    return {most_systems, std::max(stated_.settings.tolerance, enough),
            stated_.settings.report, enough};
  }
  /// Nothing beside what is asked for.
  double beside_tolerance() const { return 1e-2 * stated_.settings.tolerance; }
  double missed() const {
    return std::max(
        {solution_.residual, solution_.complementarity, missed_by_rows_});
  }
  bool can_gain() const {
    return condensed_.status == ContactStatus::converged &&
           (solution_.residual > beside_tolerance() || is_off());
  }

  void take(ActiveSetResult answer) {
    condensed_ = std::move(answer);
    solution_.iterations = condensed_.iterations;
    solution_.state = condensed_.state;
    solution_.displacement +=
        relation_->displacement({condensed_.P, condensed_.v});
    solution_.force = without(stated_.trace.held, on_nodes(condensed_.P))
                          .reshaped(3, stated_.surface.node_count());
    judge();
  }

  VectorXd on_nodes(const VectorXd& rows) const {
    return rows.head(3 * stated_.surface.node_count());
  }

  /// What the theory promises, measured.
  void judge() {
    const auto& [surface, law, system, settings, trace, cones] = stated_;
    const VectorXd& u = solution_.displacement;
    const ResidualDefect residual =
        residual_defect(system, u, stated_.load_of(solution_.force),
                        largest_displacement(law, VectorXd::Zero(1)));
    solution_.residual = residual.of_forces;
    missed_by_rows_ = residual.of_rows;
    LawScales scales = relation_->scales(on_nodes(condensed_.v));
    scales.v = std::max(scales.v, largest_displacement(law, u));
    solution_.complementarity =
        surface_violation(cones, on_nodes(condensed_.P),
                          stated_.v_of(u, solution_.force), scales);
    solution_.status =
        judged_status(condensed_.status, solution_.complementarity,
                      solution_.residual, settings.tolerance);
  }

  const StatedSurface& stated_;
  std::unique_ptr<SurfaceRelation> relation_;
  ActiveSetResult condensed_;
  SurfaceSolution solution_;
  double missed_by_rows_ = 0;  ///< ResidualDefect::of_rows
};

/// Single precision where it pays and prescribed displacements hold the body.
bool takes_single_precision(const SolidMesh& mesh, const ElasticSystem& system,
                            const ContactSettings& settings) {
  return settings.solver == ContactSolver::newton &&
         free_dof_count(system) >= settings.single_precision_from &&
         free_rigid_motions(mesh, system.prescribed).cols() == 0;
}

SurfaceSolution corrected_solution(const StatedSurface& stated,
                                   Precision precision) {
  const auto stiffness = prepared_stiffness(
      stated.trace.trace.kept_dofs, stated.system, stated.settings, precision);
  Answer answer(stated, stiffness);
  if (!stiffness->is_exact() || answer.is_off()) answer.correct();
  return std::move(answer).solution();
}

/// Nothing where single precision is not enough.
std::optional<SurfaceSolution> roughly_factored_solution(
    const StatedSurface& stated) {
  try {
    SurfaceSolution solution = corrected_solution(stated, Precision::single);
    if (solution.accepted(stated.settings)) return solution;
  } catch (const Failure&) {
  }
  return std::nullopt;
}

/// Judged by the balance of loads and contact forces, too.
SurfaceSolution balanced(const SolidMesh& mesh, const StatedSurface& stated,
                         SurfaceSolution solution) {
  const auto& system = stated.system;
  solution.residual = with_balance(
      solution.residual,
      balance_defect(mesh, system, stated.load_of(solution.force)));
  solution.status = judged_status(solution.status, solution.complementarity,
                                  solution.residual, stated.settings.tolerance);
  return solution;
}

bool can_take_multigrid(const StatedSurface& stated) {
  return stated.settings.solver == ContactSolver::newton &&
         has_own_unknowns(stated.trace);
}

/// Where it is asked for, or pays and there is no factor yet.
bool takes_multigrid(const StatedSurface& stated) {
  const ContactSettings& settings = stated.settings;
  const bool can = can_take_multigrid(stated);
  if (settings.linear == LinearSolver::multigrid && !can)
    refuse(
        "solver=\"multigrid\" is for solids whose contact surfaces have no "
        "edges and move where they face what moves: leave it out");
  if (settings.linear != LinearSolver::automatic)
    return settings.linear == LinearSolver::multigrid;
  return can && !settings.stiffness &&
         free_dof_count(stated.system) >= settings.multigrid_from;
}

/// Nothing where Newton's method does not converge with it.
std::optional<SurfaceSolution> multigrid_solution(const SolidMesh& mesh,
                                                  const StatedSurface& stated) {
  Answer answer(stated, multigrid_relation(mesh.vertices, stated));
  if (answer.is_off()) answer.correct();
  SurfaceSolution solution =
      balanced(mesh, stated, std::move(answer).solution());
  solution.multigrid = Multigrid::used;
  if (solution.accepted(stated.settings)) return solution;
  return std::nullopt;
}

/// In single precision where that pays, and in full where that is not enough.
SurfaceSolution factored_solution(const SolidMesh& mesh,
                                  const StatedSurface& stated) {
  const ContactSettings& settings = stated.settings;
  const bool is_rough =
      settings.stiffness
          ? settings.stiffness->precision() == Precision::single
          : takes_single_precision(mesh, stated.system, settings);
  if (is_rough)
    if (std::optional<SurfaceSolution> solution =
            roughly_factored_solution(stated))
      return *std::move(solution);
  ContactSettings in_full = settings;
  if (is_rough) in_full.stiffness = nullptr;
  const StatedSurface again{stated.surface, stated.law, stated.system, in_full,
                            stated.trace};
  return balanced(mesh, again,
                  held_or_refused(mesh, stated.surface, stated.system, [&] {
                    return corrected_solution(again, Precision::full);
                  }));
}

}  // namespace

SurfaceSolution solve_contact(const SolidMesh& mesh,
                              const ContactSurface& surface,
                              const SurfaceLaw& law,
                              const ElasticSystem& system,
                              const ContactSettings& settings) {
  require_sound(mesh, surface, law, system, settings);
  SurfaceTrace trace = surface_trace(surface, law, system);
  trace.trace.free_motions =
      unheld_motions(mesh, system)(trace.trace.kept_dofs, Eigen::all);
  require_feasible(mesh, surface, law, system, trace.held);
  const StatedSurface stated{surface, law, system, settings, trace};
  if (!takes_multigrid(stated)) return factored_solution(mesh, stated);
  if (std::optional<SurfaceSolution> solution =
          multigrid_solution(mesh, stated))
    return *std::move(solution);
  SurfaceSolution solution = factored_solution(mesh, stated);
  solution.multigrid = Multigrid::in_vain;
  return solution;
}

}  // namespace ffcontact
