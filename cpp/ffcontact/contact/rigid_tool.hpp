// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/contact_solution.hpp"

namespace ffcontact {

/// A rigid foundation that a force pushes and a moment turns.
///
/// Its motion z(x) = (z_x, z_y) + turn (-(y - c_y), x - c_x) about c is a combination of
/// given free ones. Conditions hold for u - z,
///     u_n - n . z <= gap,   friction acts on u_t - t . z - previous,
/// and contact passes on to the body what pushes the tool: for each free motion
///     sum of F_i . z(x_i) = push . z.
/// Friction at nodes that supports hold along the line cannot be told from what these do:
/// it is left out of both.
/// Along motions that contact does not feel (a smooth plane that slides) nothing moves
/// it, or it is returned as it happens to be.
struct RigidTool {
  Vector2d about{0, 0};    ///< c, as the vertices of the mesh [mm]
  Matrix3Xd free;          ///< (z_x, z_y, turn) of each free motion [3 x m]
  Vector3d push{0, 0, 0};  ///< force [N/mm] and moment about c [N]
};

/// (n . z, t . z) at the nodes [2 x p].
Matrix2Xd tool_components(const Mesh& mesh, const ContactLine& line,
                          const RigidTool& tool, const Vector3d& motion);

/// Its free motions at all vertices of the mesh [2 * vertices x m].
MatrixXd tool_fields(const Mesh& mesh, const RigidTool& tool);

/// A solution with its tool.
struct ToolSolution {
  Vector3d motion;  ///< of the tool [mm, mm, 1]
  /// the law against the moved foundation, in which its motion is a gap and a previous
  /// displacement: what is left is a problem of prescribed motion
  ContactLaw<2> law;
  ContactSolution<2> solution;
  /// what the forces miss of the push along the free motions, relative to it
  double imbalance;
};

/// One factorisation; the motion is condensed with the contact line, as an opposite body
/// without stiffness is, then the body is solved against the moved foundation.
/// @param law  against the foundation before it moves
/// @throws std::invalid_argument  as solve_contact; if the line faces a body, no motion is
///                                free or a value is not finite, or no contact forces
///                                balance the push
ToolSolution solve_contact_with_tool(const Mesh& mesh, const ContactLine& line,
                                     const ContactLaw<2>& law,
                                     const ElasticSystem& system,
                                     const RigidTool& tool,
                                     const ContactSettings& settings = {});

}  // namespace ffcontact
