// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/remeshing/surface_model.hpp"

namespace ffcontact {

/// The largest curvature of the smooth surfaces at each vertex [1/mm]: the angle by which
/// faces turn at an edge over the mean of their heights above it, exact for the strips of
/// a cylinder, 2/3 of the curvature of a sphere of regular triangles; 0 elsewhere.
VectorXd surface_curvature(const SolidMesh& mesh, const Facets<3>& faces,
                           const SurfaceModel& model);

}  // namespace ffcontact
