// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/pairing/facing_polygons.hpp"
//
#include "freefem/body_part.hpp"

namespace ffcontact::plugin {

/// A place on a boundary face.
struct FacePlace {
  int face;
  Vector3d coordinates;  ///< barycentric
};

/// The nodes of a surface on their own body, each on the first face that has it [p].
std::vector<FacePlace> places_of_nodes(const ContactSurface& surface);

/// What the nodes of a part of `whole` face on the opposite body, or what a place of their
/// faces does that is near [p].
std::vector<FacePlace> places_faced(const ContactSurface& part,
                                    const ContactSurface& whole,
                                    const std::vector<FacingPolygon>& polygons);

/// An expression of the script at places of a solid; x, y, z, N, label and region are
/// those of the faces.
/// @return an array of `otherwise` where the expression is null
VectorXd at_places(Stack stack, Expression expression, const BodyPart<3>& part,
                   const std::vector<FacePlace>& places, double otherwise);

}  // namespace ffcontact::plugin
