// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assembly.hpp"

/// What must hold of every answer, by plain loops over the mesh. Each function lists what
/// does not hold.
namespace ffcontact::fuzz {

struct Find {
  std::string check;   ///< its name, one word
  std::string detail;  ///< where and by how much
};
using Finds = std::vector<Find>;

/// Every labelled edge is on the line once, with its own normal; neighbours share a node
/// exactly where they are straight; and int psi_i phi_j = M Pi for the trace of the
/// opposite body.
Finds line_finds(const Case& problem, const Assembled& parts);

/// Where prescribed values push the line into the foundation whatever the free ones do;
/// unknown also where the line cannot move, where a vertex on rollers locks itself, or
/// where friction wedges one between two lines.
enum class Feasible { yes, no, unknown };
Feasible feasible(const Case& problem, const Assembled& parts);

/// balance: K u = b + contact forces on the free dofs (1e-10 of |K| max|u| + |b|, 1e-9 of
/// the row's own); support: prescribed values; law: (3.17)-(3.22) node by node with our
/// own W (1e-9).
Finds solution_finds(const Case& problem, const Assembled& parts,
                     const ContactSolution<2>& solution);

/// Does no density that is linear on the contact edges, and in the friction cone at nine
/// places of each, have the resultants of the contact forces along the rigid motions that
/// prescribed dofs leave free, and along those of a tool? So it is where a body stands on one end of its line: its
/// reaction is concentrated, which no finite stress of the continuous problem has, and
/// there is no admissible pair.
bool no_density_holds(const Assembled& parts,
                      const ContactSolution<2>& solution);

/// displacement: u_hat keeps prescribed values and does not penetrate (1e-9);
/// divergence, jump, traction: div + f = 0 on each subtriangle, sigma n continuous and
/// equal to the given and the contact tractions (1e-10 of the largest stress of u, of the
/// loads or of sigma_hat); cone: r_hat in the cone all along the edges (1e-12); error: e,
/// its parts, eps and eps_E against our own integrals (1e-8); admissible: the estimate
/// says so itself.
Finds estimate_finds(const Case& problem, const Assembled& parts,
                     const Estimate<2>& estimate);

/// bound: |sigma - sigma_hat|^2 + |u - u_hat|^2 <= e^2 (2.20) for the nodal-force
/// solution (u, sigma) on the mesh cut `times` times into four. For it the inequality is
/// exact up to 2 (sum (M k)_i |w_i| - int k |w|) of u_hat on the fine line and what the
/// rounding left of its residual works on u - u_hat, which are added. For matching traces, Tresca's law and none.
Finds bound_finds(const Case& problem, const Assembled& parts,
                  const Estimate<2>& estimate, int times);

}  // namespace ffcontact::fuzz
