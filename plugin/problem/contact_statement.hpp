// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "freefem/arguments.hpp"
#include "freefem/plane_values.hpp"
#include "problem/body_dofs.hpp"

/// What the parameters of a statement say of labels, line, law and side.
namespace ffcontact::plugin {

/// The parameters of a statement.
NamedArguments::Table statement_table(const basicAC_F0& arguments);

/// Are the bodies glued to what they face?
bool is_bonded(Stack stack, const NamedArguments& named);

/// What faces each other, by labels in the joined mesh's numbering: a body and one or
/// several others, or a single body and itself or a rigid foundation.
struct StatedPair {
  int body;
  std::vector<int> labels, opposite;  ///< the latter none on a rigid foundation

  bool rigid() const { return opposite.empty(); }
};

/// By label= and opposite=, or label1=, label2=, ...: each body and the one after it, or
/// those of pairs=. Of a body in several pairs each has a label of its own; pairs that share
/// the line of the body that comes first are one.
/// @throws std::invalid_argument  if one of several bodies has no label, or one that is on
///                                no boundary facet of it, or not as many as it faces
///                                bodies; if no law is stated, or bonded= beside
///                                another one or of solids; or a parameter of a body
///                                that there is not, or side= on a rigid foundation
template <int dim>
std::vector<StatedPair> stated_pairs(Stack stack, const NamedArguments& named,
                                     const JoinedBodies<dim>& joined);

/// The body that a label of the joined mesh is of.
template <int dim>
int body_of_label(const JoinedBodies<dim>& joined, int label);

/// Whether what has its labels must not lie on itself, front to front: that would be two
/// rigid foundations, or each side of a crack twice.
bool must_not_face_itself(const StatedPair& pair);

/// @throws std::invalid_argument  always: both sides of a crack have one label
/// @param place  where they lie on each other, in words
[[noreturn]] void refuse_both_sides(int label, const std::string& place);

/// The turn above which a curve has a corner, by corner= [degrees].
/// @throws std::invalid_argument  unless it is from 0 to below 90
double stated_corner(Stack stack, const NamedArguments& named);

/// The line by its own normals and those of curves, or along the directions of normal=; of
/// bonded bodies one node a vertex.
ContactLine stated_line(Stack stack, const NamedArguments& named,
                        const BodyPart& part, const Mesh& mesh,
                        const Edges& edges, const std::vector<int>& labels,
                        const BoundaryCurves& curves);

/// The displacement of the load step before on all dofs; empty where no previous= is
/// given.
/// @throws std::invalid_argument  if one has not the dofs of its body
VectorXd stated_previous(Stack stack, const NamedArguments& named,
                         const BodyDofs& bodies);

/// The law on a line; against a body without gap= the gap is that of the meshes.
ContactLaw stated_law(Stack stack, const NamedArguments& named,
                      const BodyPart& part, const Edges& edges,
                      const ContactLine& line, const StatedPlaces& places);

/// Which side of pair number `pair` the script wants, 1 or 2, or 0.
int wanted_side(Stack stack, const NamedArguments& named, int pair, int pairs);

}  // namespace ffcontact::plugin
