// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/joined_mesh.hpp"
#include "freefem/arguments.hpp"
#include "freefem/plane_values.hpp"
#include "problem/body_dofs.hpp"
#include "problem/carrier.hpp"

/// What the parameters of a statement say of line and law.
namespace ffcontact::plugin {

/// The parameters of a statement.
NamedArguments::Table statement_table(const basicAC_F0& arguments);

/// @throws std::invalid_argument  if no law is stated, or another one where all are bonded; or
///                                a parameter of a body that there is not
void require_law_of_bodies(Stack stack, const NamedArguments& named,
                           int bodies);

/// By compliance=[cn, ct].
/// @throws std::invalid_argument  if previous= is given beside ct, whose part of it is not known
CompliantLayer stated_layer(Stack stack, const NamedArguments& named);

/// @throws std::invalid_argument  if corner= is given, of solids
void require_no_corner(const NamedArguments& named);

/// The turn above which a curve has a corner, by corner= [degrees].
/// @throws std::invalid_argument  unless it is from 0 to below 90
double stated_corner(Stack stack, const NamedArguments& named);

/// The line by its own normals and those of curves, or along the directions of normal=.
ContactLine stated_line(Stack stack, const NamedArguments& named,
                        const BodyPart<2>& part, const std::vector<int>& labels,
                        const BoundaryCurves& curves);

/// The displacement of the load step before on all dofs; empty where no previous= is
/// given.
/// @throws std::invalid_argument  if one has not the dofs of its body
VectorXd stated_previous(Stack stack, const NamedArguments& named,
                         const BodyDofs& bodies);

/// The law and kinetic friction on a line; against a body without gap= the gap is that of
/// the meshes.
void put_law(Stack stack, const NamedArguments& named, const BodyPart<2>& part,
             const ContactLine& line, const StatedPlaces& places,
             Carrier<2>& carrier);

}  // namespace ffcontact::plugin
