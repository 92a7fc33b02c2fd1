// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "arguments.hpp"
#include "body_dofs.hpp"
#include "ffcontact/contact/contact_law.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "plane_values.hpp"

/// What the parameters of a statement say of labels, line, law and side.
namespace ffcontact::plugin {

/// What is stated for each body.
extern const NamedArguments::Table stated_of_bodies;

/// The parameters of a statement.
NamedArguments::Table statement_table(const basicAC_F0& arguments);

/// The labels of one body in the joined mesh's numbering.
/// @throws std::invalid_argument  if one of several bodies has none, or a label is on no
///                                boundary facet of the body
template <int dim>
std::vector<int> joined_labels(Stack stack, const NamedArguments& named,
                               const std::string& name,
                               const JoinedBodies<dim>& joined, int body);

/// The labels of one body that face the one before it and the one after it.
struct BodyLabels {
  std::vector<int> towards_last, towards_next;
};

/// Those of label=, or label1=, label2=, ...
/// @throws std::invalid_argument  as joined_labels, and if a body between two others has
///                                not two labels
template <int dim>
std::vector<BodyLabels> labels_of_bodies(Stack stack,
                                         const NamedArguments& named,
                                         const JoinedBodies<dim>& joined);

/// The line by its own normals, or along the directions of normal=.
ContactLine stated_line(Stack stack, const NamedArguments& named,
                        const BodyPart& part, const Mesh& mesh,
                        const Edges& edges, const std::vector<int>& labels);

/// The displacement of the load step before on all dofs; empty where no previous= is
/// given.
/// @throws std::invalid_argument  if one has not the dofs of its body
VectorXd stated_previous(Stack stack, const NamedArguments& named,
                         const BodyDofs& bodies);

/// @throws std::invalid_argument  if neither friction= nor slipbound= is given
void require_law(const NamedArguments& named);

/// The law on a line; against a body without gap= the gap is that of the meshes.
/// @throws std::invalid_argument  if the bodies overlap by more than a contact edge
ContactLaw stated_law(Stack stack, const NamedArguments& named,
                      const BodyPart& part, const Mesh& mesh,
                      const Edges& edges, const ContactLine& line,
                      const StatedPlaces& places);

/// Which side of pair number `pair` the script wants, 1 or 2, or 0.
int wanted_side(Stack stack, const NamedArguments& named, int pair, int pairs);

}  // namespace ffcontact::plugin
