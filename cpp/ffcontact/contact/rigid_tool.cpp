// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/rigid_tool.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/checks/line_balance.hpp"
#include "ffcontact/contact/condensed_answer.hpp"
#include "ffcontact/contact/far_gaps.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/law/held_rows.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// z(x) of a motion.
Vector2d place_moves(const RigidTool& tool, const Vector3d& motion,
                     const Vector2d& x) {
  const Vector2d r = x - tool.about;
  return motion.head<2>() + motion[2] * Vector2d(-r.y(), r.x());
}

void require_valid(const ContactLine& line, const RigidTool& tool) {
  if (line.against_a_body())
    refuse("push= and moment= move a rigid foundation, not a body");
  if (tool.free.cols() == 0) refuse("the tool has no free motion");
  require_finite("push", tool.push);
  require_finite("free motion of the tool", tool.free.reshaped());
  require_finite("place of the tool", tool.about);
}

VectorXd plus(const VectorXd& values, const VectorXd& more) {
  return values.size() > 0 ? VectorXd(values + more) : more;
}

ContactLaw<2> against_moved(ContactLaw<2> law, const Matrix2Xd& z) {
  law.gap = plus(law.gap, z.row(0));
  law.previous = plus(law.previous, z.row(1));
  return law;
}

/// tool_components as the solver takes them.
Matrix2Xd felt_components(const Mesh& mesh, const ContactLine& line,
                          const ElasticSystem& system, const RigidTool& tool,
                          const Vector3d& motion) {
  Matrix2Xd components = tool_components(mesh, line, tool, motion);
  const Flags held = held_rows(line, system.prescribed);
  for (int i = 0; i < line.node_count(); ++i)
    if (held[2 * i + 1]) components(1, i) = 0;
  return components;
}

/// The tool's free motions as the condensed contact line takes them.
FoundationMotions foundation_of(const Mesh& mesh, const ContactLine& line,
                                const ElasticSystem& system,
                                const RigidTool& tool, const VectorXd& push) {
  FoundationMotions foundation{
      MatrixXd(2 * line.node_count(), tool.free.cols()), push};
  for (Index k = 0; k < tool.free.cols(); ++k)
    foundation.trace.col(k) =
        felt_components(mesh, line, system, tool, tool.free.col(k)).reshaped();
  return foundation;
}

/// Relative, motion by motion, to its load or to what all forces that the tool feels may do
/// along it.
double imbalance_of(const FoundationMotions& foundation,
                    const Matrix2Xd& force) {
  double felt = 0, largest = 0;
  for (Index row = 0; row < force.size(); ++row)
    if (!foundation.trace.row(row).isZero(0))
      felt += std::abs(force.reshaped()[row]);
  for (Index k = 0; k < foundation.load.size(); ++k) {
    const auto z = foundation.trace.col(k);
    const double load = foundation.load[k],
                 off = z.dot(force.reshaped()) - load;
    largest = std::max(
        largest,
        relative(std::abs(off), std::max(std::abs(load), max_norm(z) * felt)));
  }
  return largest;
}

}  // namespace

Matrix2Xd tool_components(const Mesh& mesh, const ContactLine& line,
                          const RigidTool& tool, const Vector3d& motion) {
  Matrix2Xd components(2, line.node_count());
  for (int i = 0; i < line.node_count(); ++i) {
    const Vector2d z =
        place_moves(tool, motion, mesh.vertices.col(line.vertex[i]));
    components.col(i) = line.frame(i).transpose() * z;
  }
  return components;
}

MatrixXd tool_fields(const Mesh& mesh, const RigidTool& tool) {
  MatrixXd fields(2 * mesh.vertices.cols(), tool.free.cols());
  for (Index k = 0; k < fields.cols(); ++k)
    for (Index v = 0; v < mesh.vertices.cols(); ++v)
      fields.col(k).segment<2>(2 * v) =
          place_moves(tool, tool.free.col(k), mesh.vertices.col(v));
  return fields;
}

namespace {

ToolSolution solution_with_tool(const Mesh& mesh, const ContactLine& line,
                                const ContactLaw<2>& law,
                                const ElasticSystem& system,
                                const RigidTool& tool,
                                const ContactSettings& settings) {
  const VectorXd push = tool.free.transpose() * tool.push;

  // 1. The motion, with the condensed contact line.
  const FoundationMotions foundation =
      foundation_of(mesh, line, system, tool, push);
  ContactSettings next = settings;
  next.stiffness =
      prepared_stiffness(contact_dofs(line, system), system, settings);
  const CondensedContact contact =
      condensed_contact(line, law, system, *next.stiffness, foundation,
                        unheld_motions(mesh, system));
  const ActiveSetResult answer =
      condensed_answer(contact, nodal_law(law, line), settings).answer;

  // 2. The body against the moved foundation.
  ToolSolution result;
  result.motion =
      tool.free * opposite_displacement(contact, answer.v(contact.primary),
                                        answer.P(contact.dependent))
                      .head(tool.free.cols());
  result.law =
      against_moved(law, tool_components(mesh, line, tool, result.motion));
  next.initial_state = answer.state;
  result.solution = solve_contact(
      mesh, line,
      against_moved(law,
                    felt_components(mesh, line, system, tool, result.motion)),
      system, next);
  ContactSolution<2>& solution = result.solution;
  solution.iterations += answer.iterations;
  if (answer.status != ContactStatus::converged)
    solution.status = answer.status;

  // 3. What the tool lacks of equilibrium.
  result.imbalance = imbalance_of(foundation, solution.force);
  solution.residual = std::max(solution.residual, result.imbalance);
  solution.status = judged_status(solution.status, solution.complementarity,
                                  solution.residual, settings.tolerance);
  return result;
}

/// What bodies and tool move by at most.
double largest_motion(const Mesh& mesh, const ContactLine& line,
                      const RigidTool& tool, const ToolSolution& found) {
  return max_norm(found.solution.displacement) +
         max_norm(tool_components(mesh, line, tool, found.motion));
}

}  // namespace

ToolSolution solve_contact_with_tool(const Mesh& mesh, const ContactLine& line,
                                     const ContactLaw<2>& law,
                                     const ElasticSystem& system,
                                     const RigidTool& tool,
                                     const ContactSettings& settings) {
  constexpr double clear = 2;
  require_valid(line, tool);
  require_valid(law, line);
  require_valid(settings, line.node_count());
  require_balance(mesh, line, law, system, tool_fields(mesh, tool),
                  tool.free.transpose() * tool.push);
  ToolSolution found =
      solution_with_tool(mesh, line, law, system, tool, settings);
  const double most = clear * largest_motion(mesh, line, tool, found);
  const bool is_far = law.gap.size() > 0 && law.gap.maxCoeff() > most;
  if (found.solution.accepted(settings) || !is_far) return found;

  // Gaps that never close, whose rounding is large beside the forces, are cut.
  ContactSettings next = settings;
  next.stiffness = found.solution.stiffness;
  next.initial_state = found.solution.state;
  ToolSolution cut = solution_with_tool(mesh, line, with_gaps_up_to(law, most),
                                        system, tool, next);
  cut.solution.iterations += found.solution.iterations;
  if (!cut.solution.accepted(settings) ||
      !are_open(cut.solution.state, law.gap, most))
    return found;
  cut.law = against_moved(law, tool_components(mesh, line, tool, cut.motion));
  return cut;
}

}  // namespace ffcontact
