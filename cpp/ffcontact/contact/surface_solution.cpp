// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/surface_solution.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/coarse_start.hpp"
#include "ffcontact/contact/condensed_answer.hpp"
#include "ffcontact/contact/refinement.hpp"
#include "ffcontact/contact/surface_answer.hpp"
#include "ffcontact/contact/surface_balance.hpp"
#include "ffcontact/contact/surface_newton.hpp"
#include "ffcontact/contact/surface_trace.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"

namespace ffcontact {

namespace {

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

/// The problem as it was stated, and how its surface moves.
struct StatedSurface {
  const ContactSurface& surface;
  const SurfaceLaw& law;
  const ElasticSystem& system;
  const ContactSettings& settings;
  const SurfaceTrace& trace;
  const NodalLaw cones = nodal_law(law, surface);

  /// Forces of the nodes on all dofs.
  VectorXd load_of(const Matrix3Xd& force) const {
    return nodal_load(surface, force, system.dof_count());
  }
  /// v of a displacement on all dofs.
  VectorXd v_of(const VectorXd& displacement) const {
    return trace.weight *
           displacement_against_foundation(surface, law, displacement)
               .reshaped();
  }
};

/// An answer on the condensed relation, and what the whole body makes of it.
class Answer {
 public:
  Answer(const StatedSurface& stated,
         std::shared_ptr<const CondensedStiffness> stiffness)
      : stated_(stated),
        contact_(condensed_contact(stated.trace.trace, stated.trace.primary,
                                   stated.system.load, *stiffness)) {
    solution_.stiffness = std::move(stiffness);
    solution_.displacement = stated.system.prescribed_value;
    const auto& held = stated.trace.held;
    if (solution_.stiffness->precision() == Precision::single) {
      solver_ = StepSolver(contact_, held);
      take(rough_answer(contact_, stated.cones, held, start(), stated.settings,
                        solver_));
    } else {
      FixedPointResult condensed =
          surface_answer(contact_, stated.cones, held, stated.settings);
      solution_.history = std::move(condensed.history);
      take(std::move(condensed.answer));
    }
  }

  /// Corrects the answer of an inexact factor K~: with u the last displacement
  ///     K~ (u' - u) = b - K u + B' P',   (P', v(u')) in the law,
  /// so that u' = u solves the problem itself, as long as that lowers what is missed.
  void correct() {
    constexpr int most_corrections = 20;
    for (int k = 0; k < most_corrections && can_gain(); ++k) {
      const SurfaceSolution last = solution_;
      const ContactRows rows{condensed_.P, condensed_.v};
      contact_ = with_loads(
          std::move(contact_), *solution_.stiffness,
          force_residual(stated_.system, solution_.displacement, no_forces()),
          stated_.v_of(solution_.displacement));
      take(surface_newton(contact_, stated_.cones, stated_.trace.held, rows,
                          solver_, limits()));
      solution_.iterations += last.iterations;
      if (missed_by(solution_) < missed_by(last) / least_gain) continue;
      solution_ = last;
      return;
    }
  }

  SurfaceSolution solution() && { return std::move(solution_); }

 private:
  static constexpr int most_systems = 30;  ///< of a correction
  /// Of what is missed by a correction.
  static constexpr double least_gain = 2;
  /// What a violation may be of the residual before a correction, which gains more.
  static constexpr double beside_residual = 1e-3;

  /// Where no states are given that are better.
  std::optional<ContactRows> start() const {
    const ContactSettings& settings = stated_.settings;
    if (!settings.initial_state.empty() && !settings.state_of_another_mesh)
      return std::nullopt;
    return coarse_start(contact_, stated_.cones, stated_.surface,
                        stated_.law.multiplier, stated_.trace.weight);
  }
  VectorXd no_forces() const {
    return VectorXd::Zero(stated_.system.dof_count());
  }
  /// The law is met as well as the correction after this one will need it.
  NewtonSettings limits() const {
    const double enough =
        std::max(beside_tolerance(), beside_residual * solution_.residual);
    return {
        most_systems, std::max(stated_.settings.tolerance, enough), {}, enough};
  }
  /// Nothing beside what is asked for.
  double beside_tolerance() const { return 1e-2 * stated_.settings.tolerance; }
  static double missed_by(const SurfaceSolution& solution) {
    return std::max(solution.residual, solution.complementarity);
  }
  bool can_gain() const {
    return condensed_.status == ContactStatus::converged &&
           (solution_.residual > beside_tolerance() ||
            solution_.complementarity > stated_.settings.tolerance);
  }

  void take(ActiveSetResult answer) {
    condensed_ = std::move(answer);
    solution_.iterations = condensed_.iterations;
    solution_.state = condensed_.state;
    const VectorXd kept =
        kept_displacement(contact_, condensed_.v(contact_.primary),
                          condensed_.P(contact_.dependent));
    solution_.displacement +=
        solution_.stiffness->extended(contact_.load, kept);
    put_multipliers(stated_.surface, stated_.law, stated_.trace, condensed_.P,
                    solution_);
    judge();
  }

  /// What the theory promises, measured.
  void judge() {
    const auto& [surface, law, system, settings, trace, cones] = stated_;
    const VectorXd& u = solution_.displacement;
    solution_.residual =
        equilibrium_defect(system, u, stated_.load_of(solution_.force),
                           largest_displacement(law, VectorXd::Zero(1)));
    LawScales scales = law_scales(contact_, condensed_.v);
    scales.v = std::max(
        scales.v, largest_weight(law, surface) * largest_displacement(law, u));
    solution_.complementarity =
        surface_violation(cones, condensed_.P, stated_.v_of(u), scales);
    solution_.status =
        judged_status(condensed_.status, solution_.complementarity,
                      solution_.residual, settings.tolerance);
  }

  const StatedSurface& stated_;
  CondensedContact contact_;
  ActiveSetResult condensed_;
  StepSolver solver_;
  SurfaceSolution solution_;
};

/// Single precision where it pays and prescribed displacements hold the body.
bool takes_single_precision(const SolidMesh& mesh, const ElasticSystem& system,
                            const ContactSettings& settings) {
  const auto free_dofs =
      std::count(system.prescribed.begin(), system.prescribed.end(), 0);
  return settings.solver == ContactSolver::newton &&
         free_dofs >= settings.single_precision_from &&
         free_rigid_motions(mesh, system.prescribed).cols() == 0;
}

/// Nothing where single precision is not enough.
std::optional<SurfaceSolution> roughly_factored_solution(
    const StatedSurface& stated) {
  try {
    Answer answer(
        stated, prepared_stiffness(stated.trace.trace.kept_dofs, stated.system,
                                   stated.settings, Precision::single));
    answer.correct();
    SurfaceSolution solution = std::move(answer).solution();
    if (solution.accepted(stated.settings)) return solution;
  } catch (const std::runtime_error&) {
  }
  return std::nullopt;
}

}  // namespace

SurfaceSolution solve_contact(const SolidMesh& mesh,
                              const ContactSurface& surface,
                              const SurfaceLaw& law,
                              const ElasticSystem& system,
                              const ContactSettings& settings) {
  require_sound(mesh, surface, law, system, settings);
  const SurfaceTrace trace = surface_trace(surface, law, system);
  require_clear(mesh, surface, law, system, trace.held);
  const StatedSurface stated{surface, law, system, settings, trace};
  const bool is_rough =
      settings.stiffness ? settings.stiffness->precision() == Precision::single
                         : takes_single_precision(mesh, system, settings);
  if (is_rough)
    if (std::optional<SurfaceSolution> solution =
            roughly_factored_solution(stated))
      return *std::move(solution);
  ContactSettings in_full = settings;
  if (is_rough) in_full.stiffness = nullptr;
  return Answer(stated,
                prepared_stiffness(trace.trace.kept_dofs, system, in_full))
      .solution();
}

}  // namespace ffcontact
