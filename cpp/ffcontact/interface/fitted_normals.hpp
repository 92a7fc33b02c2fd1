// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Triangles between nodes, all of one orientation.
struct SheetOfNodes {
  Matrix3Xd place;        ///< of each node [3 x p]
  Matrix3Xd normal;       ///< of length 1, as the means of the faces [3 x p]
  Matrix3Xi face_node;    ///< [3 x m]
  Matrix3Xd face_normal;  ///< [3 x m]

  int node_count() const { return static_cast<int>(place.cols()); }
};

/// The normals of smooth sheets at their nodes, where faces turn: that of the surface through
/// the node
///     z = a x + b y + terms of x^2, x y, y^2, x z, y z, z^2, and of x^3, x^2 y, x y^2, y^3
/// which fits the nodes around it on its sheet, two faces far or up to four where these are
/// less than 14, by least squares with weights 1/distance; z is the height over the tangent
/// plane of the given normal. Of quadrics (cylinders, balls, cones, ellipsoids) it is exact,
/// and accurate to h^3 of others, to h^2 on rims, where third order would go astray. A term
/// counts where the terms before it leave 1 % of it [as jets: F. Cazals, M. Pouget,
/// Estimating differential quantities using polynomial fitting of osculating jets, Computer
/// Aided Geometric Design 22, 2005].
///
/// A given normal stays where the faces beside the node lie in one plane (on a rim those beside
/// its neighbours, too), or where the other one would turn from it by more than they do.
Matrix3Xd fitted_normals(const SheetOfNodes& sheet);

}  // namespace ffcontact
