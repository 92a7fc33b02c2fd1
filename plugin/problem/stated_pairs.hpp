// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "ffcontact/mesh/joined_mesh.hpp"
//
#include "freefem/arguments.hpp"

/// What the parameters of a statement say of who faces whom.
namespace ffcontact::plugin {

/// What faces each other, by labels in the joined mesh's numbering: a body and one or
/// several others, or a single body and itself or a rigid foundation.
struct StatedPair {
  int body;
  std::vector<int> labels, opposite;  ///< the latter none on a rigid foundation
  bool bonded;                        ///< glued to what they face

  bool rigid() const { return opposite.empty(); }
};

/// By label= and opposite=, or label1=, label2=, ...: each body and the one after it, or
/// those of pairs=. Of a body in several pairs each has a label of its own; pairs that share
/// the line of the body that comes first are one.
/// @throws std::invalid_argument  if one of several bodies has no label, or one that is on
///                                no boundary facet of it, or not as many as it faces
///                                bodies, or side= is given on a rigid foundation; and
///                                as require_law_of_bodies
template <int dim>
std::vector<StatedPair> stated_pairs(Stack stack, const NamedArguments& named,
                                     const JoinedBodies<dim>& joined);

/// The body that a label of the joined mesh is of.
template <int dim>
int body_of_label(const JoinedBodies<dim>& joined, int label);

/// The bodies that a pair is of.
template <int dim>
std::set<int> bodies_of(const StatedPair& pair,
                        const JoinedBodies<dim>& joined) {
  std::set<int> bodies{pair.body};
  for (const int label : pair.opposite)
    bodies.insert(body_of_label(joined, label));
  return bodies;
}

/// Whether what has its labels must not lie on itself, front to front: that would be two
/// rigid foundations, or each side of a crack twice.
bool must_not_face_itself(const StatedPair& pair);

/// @throws std::invalid_argument  always: both sides of a crack have one label
/// @param place  where they lie on each other, in words
[[noreturn]] void refuse_both_sides(int label, const std::string& place);

/// Which side of pair number `pair` the script wants, 1 or 2, or 0.
int wanted_side(Stack stack, const NamedArguments& named, int pair, int pairs);

}  // namespace ffcontact::plugin
