// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include "ffcontact/base/appended.hpp"
#include "ffcontact/contact/law/kinetic_friction.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/interface/joined_lines.hpp"
#include "ffcontact/interface/joined_surfaces.hpp"

namespace ffcontact::plugin {

/// Nodes and edges of a line, or what they face, on the line of the body that comes first.
struct OfLine {
  VectorXd abscissa;        ///< of each node [mm, p]
  Matrix2Xd edge_abscissa;  ///< of the ends of each contact edge [mm, 2 x m]
};
struct OfSurface {};

/// The line or surface that carries the multipliers, of one pair of bodies or of all, with
/// what is stated at its nodes.
template <int d>
struct Carrier : std::conditional_t<d == 2, OfLine, OfSurface> {
  LineOrSurface<d> contact;
  ContactLaw<d> law;  ///< multiplier left at its default
  KineticFriction kinetic;
  /// of each node, or nearest to what it faces, in the mesh of the body that comes first
  std::vector<long> own_vertex;
};

inline ContactLine as_one(std::vector<ContactLine> lines) {
  return lines.size() == 1 ? std::move(lines.front()) : joined_lines(lines);
}
inline ContactSurface as_one(const std::vector<ContactSurface>& surfaces) {
  return joined_surfaces(surfaces);
}

inline void append_range(const EdgeRange& more, EdgeRange& range) {
  append(more.least, range.least);
  append(more.most, range.most);
}

inline void append_of_line(const Carrier<2>& more, Carrier<2>& all) {
  append(more.abscissa, all.abscissa);
  append(more.edge_abscissa, all.edge_abscissa);
  append_range(more.law.between_nodes, all.law.between_nodes);
  append_range(more.law.limit_between_nodes, all.law.limit_between_nodes);
  append_range(more.kinetic.between_nodes, all.kinetic.between_nodes);
}

/// But for the line or surface itself.
template <int d>
void append_stated(const Carrier<d>& more, Carrier<d>& all) {
  all.own_vertex.insert(all.own_vertex.end(), more.own_vertex.begin(),
                        more.own_vertex.end());
  using Law = ContactLaw<d>;
  for (VectorXd Law::*nodal :
       {&Law::friction, &Law::slip_bound, &Law::shear_limit, &Law::gap})
    append(more.law.*nodal, all.law.*nodal);
  append(more.kinetic.friction, all.kinetic.friction);
  all.law.bonded = more.law.bonded;
  if constexpr (d == 2) append_of_line(more, all);
}

}  // namespace ffcontact::plugin
