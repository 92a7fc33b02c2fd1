// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/free_tractions.hpp"
#include "ffcontact/equilibrium/star_energy.hpp"

/// The corrections that the stars of boundary vertices allow.
namespace ffcontact {

/// A condition that corrections change by less than this part of what they could is not
/// changed by them. Coordinates far from the origin are known to little more, but stresses
/// whose conditions are left out by this are out of equilibrium by a hundred times it.
constexpr double negligible_change = 1e-12;

/// The vertices that are relaxed together: one, or those that contact edges join across
/// two bodies. The unknowns of their stars follow each other.
struct StarGroup {
  std::vector<StarCorrections> stars;
  std::vector<int> first;  ///< unknown of each star, and the number of all

  StarGroup(const StarSetting& setting, const std::vector<int>& vertices)
      : first(1, 0) {
    for (int v : vertices) {
      stars.emplace_back(setting.space, setting.stars, v);
      first.push_back(first.back() + stars.back().unknowns());
    }
  }
  int unknowns() const { return first.back(); }
};

/// A boundary edge at the vertex of a star.
struct BoundarySpoke {
  const StarCorrections& star;
  int number;
  int first;  ///< unknown of the star

  int edge() const { return star.spoke(number); }
  /// The outward normal is to the right of the first spoke and to the left of the last
  /// one, which runs against its edge.
  bool runs_along_edge() const { return number == 0; }
  /// Moments of the traction at the vertex and at the other end for the four unknowns of
  /// the spoke.
  Matrix4d moments() const {
    return (runs_along_edge() ? 1 : -1) * star.moments(number);
  }
  /// Adds the four columns of a matrix for the spoke's unknowns to one for all unknowns.
  template <class Local, class All>
  void spread(const Local& local, All&& all) const {
    const auto columns = star.columns_of_spoke(number);
    for (int c = 0; c < 4; ++c) all.col(first + columns[c]) += local.col(c);
  }
};

std::vector<BoundarySpoke> boundary_spokes(const StarGroup& group);

/// The contact edge that a boundary spoke is on either body, or -1.
/// @param contact  null: all contact tractions are known
int free_edge(const BoundarySpoke& spoke, const FreeContact* contact);

/// On a contact edge: is the body of the spoke the one with the multipliers?
bool carries_multipliers(const BoundarySpoke& spoke, int contact_edge,
                         const FreeContact& contact);

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
