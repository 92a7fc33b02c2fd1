// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/interface/stated_places.hpp"
//
#include "freefem/arguments.hpp"
#include "freefem/body_part.hpp"

/// Expressions of the script at points of plane bodies.
namespace ffcontact::plugin {

/// An expression of the script at the nodes of a contact line (x, y, label, N as on the
/// boundary) [p].
/// @return an array of `otherwise` where the expression is null
VectorXd at_nodes(Stack stack, Expression expression, const BodyPart<2>& part,
                  const ContactLine& line, const StatedPlaces& places,
                  double otherwise);

/// An expression at the places of each edge, with the label of the edge [points x edges].
MatrixXd along_edges(Stack stack, Expression expression,
                     const BodyPart<2>& part, const StatedPlaces& places);

}  // namespace ffcontact::plugin
