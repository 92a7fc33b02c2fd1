// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>
#include <vector>

#include "ffcontact/base/appended.hpp"
#include "ffcontact/contact/law/kinetic_friction.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/interface/line_or_surface.hpp"

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

/// Values of each node or edge of two pairs: where only one of them has any, those of the other
/// one are 0.
struct AppendedCounts {
  Index all, more;

  template <class Values>
  void append_to(Values& values, const Values& others) const {
    if (values.size() == 0 && others.size() == 0) return;
    values = filled(values, all);
    append(filled(others, more), values);
  }
  void append_to(EdgeRange& range, const EdgeRange& others) const {
    append_to(range.least, others.least);
    append_to(range.most, others.most);
  }

 private:
  static VectorXd filled(const VectorXd& values, Index count) {
    return values.size() > 0 ? values : VectorXd::Zero(count);
  }
  static Matrix2Xd filled(const Matrix2Xd& values, Index count) {
    return values.size() > 0 ? values : Matrix2Xd::Zero(2, count);
  }
};

inline void append_of_line(const Carrier<2>& more, Carrier<2>& all) {
  const AppendedCounts edges{all.edge_abscissa.cols(),
                             more.edge_abscissa.cols()};
  edges.append_to(all.law.between_nodes, more.law.between_nodes);
  edges.append_to(all.law.limit_between_nodes, more.law.limit_between_nodes);
  edges.append_to(all.kinetic.between_nodes, more.kinetic.between_nodes);
  append(more.abscissa, all.abscissa);
  append(more.edge_abscissa, all.edge_abscissa);
}

/// But for the line or surface itself.
template <int d>
void append_stated(const Carrier<d>& more, Carrier<d>& all) {
  const AppendedCounts nodes{count_of(all.own_vertex),
                             count_of(more.own_vertex)};
  using Law = ContactLaw<d>;
  for (VectorXd Law::*nodal :
       {&Law::friction, &Law::slip_bound, &Law::shear_limit, &Law::gap})
    nodes.append_to(all.law.*nodal, more.law.*nodal);
  nodes.append_to(all.kinetic.friction, more.kinetic.friction);
  for (Index i = 0; i < nodes.more; ++i)
    all.law.bonded.push_back(more.law.is_bonded(static_cast<int>(i)));
  all.own_vertex.insert(all.own_vertex.end(), more.own_vertex.begin(),
                        more.own_vertex.end());
  if constexpr (d == 2) append_of_line(more, all);
}

}  // namespace ffcontact::plugin
