// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/equilibrium/tractions/free_tractions.hpp"

/// The corrections that the stars of boundary vertices allow.
namespace ffcontact {

/// A condition that corrections change by less than this part of what they could is not
/// changed by them. Coordinates far from the origin are known to little more, but stresses
/// whose conditions are left out by this are out of equilibrium by a hundred times it.
constexpr double negligible_change = 1e-12;

/// A boundary edge at the vertex of a star.
struct BoundarySpoke {
  int edge;
  bool runs_along_edge;  ///< does the edge start at the vertex?
  /// moments of the traction, its normal outward, at the vertex and at the other end for
  /// the unknowns (w, y) of the spoke
  Matrix4d moments;
  std::array<int, 4> columns;  ///< of these among the unknowns of the group

  /// Adds the four columns of a matrix for the spoke's unknowns to one for all unknowns.
  template <class Local, class All>
  void spread(const Local& local, All&& all) const {
    for (int c = 0; c < 4; ++c) all.col(columns[c]) += local.col(c);
  }
};

/// The vertices that are relaxed together: one, or those that contact edges join across
/// two bodies. The unknowns of their stars (ridge_form) follow each other.
struct StarGroup {
  std::vector<int> ridge;
  std::vector<int> first;  ///< unknown of each star, and the number of all
  std::vector<BoundarySpoke> spokes;

  StarGroup(const FacetTopology<2>& topology, std::vector<int> ridges);
  int unknowns() const { return first.back(); }
};

/// The contact edge that a boundary spoke is on either body, or -1.
/// @param contact  null: all contact tractions are known
int free_edge(const BoundarySpoke& spoke, const FreeContact* contact);

/// The contact edge whose multipliers the body of a spoke carries, or -1.
int own_edge(const BoundarySpoke& spoke, const FreeContact& contact);

/// Basis of the corrections of a group that leave known boundary tractions alone, r_t
/// where friction may vanish and what r_hat must keep of its work, and load both bodies of
/// a contact edge oppositely [unknowns x n].
/// @param contact  null: contact tractions are known, too
MatrixXd admissible_corrections(const StarGroup& group,
                                const BoundaryTractions& boundary,
                                const FreeContact* contact);

}  // namespace ffcontact
