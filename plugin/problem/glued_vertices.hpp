// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/interface/line_or_surface.hpp"
//
#include "problem/pair_sides.hpp"

namespace ffcontact::plugin {

/// The only vertex that a node follows, or -1.
template <class Contact>
int followed_vertex(const Contact& contact, int node) {
  int followed = -1, count = 0;
  visit_opposite(contact, node, [&](int vertex, double) {
    followed = vertex;
    ++count;
  });
  return count == 1 ? followed : -1;
}

/// What is bonded: of which bodies, and the vertices on both of them that have a multiplier
/// there, with what they follow.
template <int d>
class GluedVertices {
 public:
  explicit GluedVertices(const JoinedBodies<d>& joined) : joined_(joined) {}

  void add(const StatedPair& pair, const PairSides<d>& sides) {
    if (!pair.bonded || sides.rigid) return;
    Glued glued{bodies_of(pair, joined_), {}};
    add_nodes(sides.own.contact, glued);
    if (sides.other)
      add_nodes(sides.other->contact, glued);
    else
      add_opposite(sides.own.contact, glued);
    all_.push_back(std::move(glued));
  }

  /// Flags vertices whose jump another pair of the same bodies holds nearly as the node of this
  /// one does: their multipliers would balance each other, as large as it takes. Where it is
  /// the same jump they share its force.
  /// @return whether there are any
  bool hold(const StatedPair& pair, const LineOrSurface<d>& contact,
            Flags& held) const {
    if (pair.bonded) return false;
    const std::set<int> bodies = bodies_of(pair, joined_);
    bool any = false;
    for (const Glued& glued : all_)
      if (glued.bodies == bodies)
        any = hold_beside(glued, contact, held) || any;
    return any;
  }

 private:
  struct Glued {
    std::set<int> bodies;
    std::map<int, int> followed;  ///< -1 where it is not a single vertex
  };

  static bool is_nearly_held(const Glued& glued,
                             const LineOrSurface<d>& contact, int node) {
    const auto found = glued.followed.find(contact.vertex[node]);
    if (found == glued.followed.end()) return false;
    const int follows = followed_vertex(contact, node);
    return follows < 0 || follows != found->second;
  }
  static bool hold_beside(const Glued& glued, const LineOrSurface<d>& contact,
                          Flags& held) {
    bool any = false;
    for (int i = 0; i < contact.node_count(); ++i)
      if (is_nearly_held(glued, contact, i)) {
        held[contact.vertex[i]] = 1;
        any = true;
      }
    return any;
  }
  static void add_nodes(const LineOrSurface<d>& contact, Glued& glued) {
    for (int i = 0; i < contact.node_count(); ++i)
      glued.followed.emplace(contact.vertex[i], followed_vertex(contact, i));
  }
  static void add_opposite(const LineOrSurface<d>& contact, Glued& glued) {
    for (int i = 0; i < contact.node_count(); ++i) {
      const bool is_one = followed_vertex(contact, i) >= 0;
      visit_opposite(contact, i, [&](int vertex, double) {
        glued.followed.emplace(vertex, is_one ? contact.vertex[i] : -1);
      });
    }
  }

  const JoinedBodies<d>& joined_;
  std::vector<Glued> all_;
};

/// The sides of all pairs, of those that are bonded first, as what slides gives way to them.
/// @param sides_of  of pair k, beside what is glued
template <int d, class SidesOf>
std::vector<PairSides<d>> bonded_first(const std::vector<StatedPair>& pairs,
                                       GluedVertices<d>& glued,
                                       const SidesOf& sides_of) {
  std::vector<PairSides<d>> sides(pairs.size());
  for (const bool bonded : {true, false})
    for (int k = 0; k < count_of(pairs); ++k) {
      if (pairs[k].bonded != bonded) continue;
      sides[k] = sides_of(k);
      glued.add(pairs[k], sides[k]);
    }
  return sides;
}

}  // namespace ffcontact::plugin
