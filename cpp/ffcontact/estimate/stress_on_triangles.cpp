// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/stress_on_triangles.hpp"

#include <Eigen/LU>

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/equilibrium/tractions/refined_moments.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// The smallest of these coordinates says how far inside a point is.
Vector3d barycentric(const CellCorners<2>& corners, const Vector2d& x) {
  // differences first: what is left of them far from the origin is exact
  const Vector2d last = piola_matrix(corners).inverse() * (x - corners.col(0));
  return {1 - last.sum(), last.x(), last.y()};
}

struct Place {
  int triangle;
  Vector3d coordinates;  ///< barycentric
};

/// Where among some triangles a point is farthest inside.
Place place_of(const Mesh& mesh, const std::vector<int>& triangles,
               const Vector2d& x) {
  Place place{triangles.front(), Vector3d::Constant(-infinity)};
  for (int t : triangles) {
    const Vector3d coordinates = barycentric(corners_of(mesh, t), x);
    if (coordinates.minCoeff() > place.coordinates.minCoeff())
      place = {t, coordinates};
  }
  return place;
}

/// The stress at a point of one of some triangles.
Vector3d stress_at(const Mesh& mesh,
                   const std::vector<SubcellStress<2>>& stress,
                   const std::vector<int>& triangles, const Vector2d& x) {
  const auto [t, coordinates] = place_of(mesh, triangles, x);
  int k;  // the subtriangle opposite to the vertex that is farthest away
  coordinates.minCoeff(&k);
  return stress[t].middleCols<3>(3 * k) *
         barycentric(subcell<2>(corners_of(mesh, t), k), x);
}

/// The stress of a fan at the corners of its parent's subtriangles.
SubcellStress<2> stress_on_parent(const CellCorners<2>& parent,
                                  const Mesh& mesh,
                                  const std::vector<SubcellStress<2>>& stress,
                                  const std::vector<int>& fan) {
  constexpr double inwards = 1e-6;
  SubcellStress<2> result;
  for (int k = 0; k < 3; ++k) {
    const CellCorners<2> sub = subcell<2>(parent, k);
    const Vector2d middle = sub.rowwise().mean();
    for (int c = 0; c < 3; ++c) {
      const Vector2d x = sub.col(c) + inwards * (middle - sub.col(c));
      result.col(3 * k + c) = stress_at(mesh, stress, fan, x);
    }
  }
  return result;
}

}  // namespace

std::vector<SubcellStress<2>> stress_on_triangles(const Mesh& mesh,
                                                  const Estimate<2>& estimate) {
  if (!estimate.refinement) return estimate.stress;
  const CommonRefinement& refinement = *estimate.refinement;
  std::vector<SubcellStress<2>> stress(
      estimate.stress.begin(), estimate.stress.begin() + mesh.cell_count());
  for (const auto& [parent, fan] : fans_of(refinement, mesh.cell_count()))
    stress[parent] = stress_on_parent(corners_of(mesh, parent), refinement.mesh,
                                      estimate.stress, fan);
  return stress;
}

}  // namespace ffcontact
