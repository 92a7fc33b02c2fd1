// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/traction_oscillation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/estimate/error/facet_oscillation.hpp"
#include "ffcontact/interface/pairing/convex_polygon.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// Polygons below this part of a face are rounding.
constexpr double no_part = 1e-12;
/// Areas that differ by less are the same.
constexpr double same_area = 1e-10;
/// Corners that are closer to each other, in parts of the face's sides, are one: the
/// direction of a side that is cut at rounding would not say where it goes.
constexpr double no_side = 1e-8;

/// A part of a face, in its first two barycentric coordinates, with the traction there.
struct TractionPiece {
  ConvexPolygon polygon;
  QuadraticOnFace density;
};

/// What acts on one face.
struct FaceContact {
  std::vector<TractionPiece> pieces;
  Matrix3d moments = Matrix3d::Zero();
};

bool is_part(const ConvexPolygon& polygon) {
  return polygon_area(polygon) > 0.5 * no_part;
}

/// The polygon counter-clockwise, whatever side it is seen from, without sides that are
/// too short to have a direction.
ConvexPolygon seen_from_outside(const Matrix3Xd& corners) {
  std::vector<Vector2d> kept;
  for (Index k = 0; k < corners.cols(); ++k) {
    const Vector2d corner = corners.col(k).head<2>();
    const bool is_new =
        std::none_of(kept.begin(), kept.end(), [&](const Vector2d& other) {
          return (corner - other).norm() < no_side;
        });
    if (is_new) kept.push_back(corner);
  }
  ConvexPolygon polygon = packed(kept);
  if (polygon_area(polygon) < 0) polygon.rowwise().reverseInPlace();
  return polygon;
}

ConvexPolygon whole_face() {
  ConvexPolygon triangle(2, 3);
  triangle << 0, 1, 0, 0, 0, 1;
  return triangle;
}

/// The whole triangle that is seen of the other face, where it is the polygon but for what
/// lies beyond this face: its sides are none that were cut.
/// @param seen  its corners on this face
ConvexPolygon with_whole_sides(ConvexPolygon polygon, const Matrix3d& seen) {
  ConvexPolygon triangle = seen_from_outside(seen);
  const double area = polygon_area(intersection(whole_face(), triangle));
  return std::abs(area - polygon_area(polygon)) < same_area ? triangle
                                                            : polygon;
}

/// Adds the traction on one polygon to those on parts that do not overlap.
std::vector<TractionPiece> with_piece(const std::vector<TractionPiece>& parts,
                                      const TractionPiece& added) {
  std::vector<TractionPiece> result;
  for (const TractionPiece& part : parts) {
    ConvexPolygon shared = intersection(part.polygon, added.polygon);
    if (!is_part(shared)) {
      result.push_back(part);
      continue;
    }
    for (ConvexPolygon& rest : difference(part.polygon, added.polygon))
      if (is_part(rest)) result.push_back({std::move(rest), part.density});
    result.push_back({std::move(shared), part.density + added.density});
  }
  return result;
}

/// int of r r' over a polygon.
Matrix3d square_of(const TractionPiece& piece, double face_area) {
  Matrix3Xd corners(3, piece.polygon.cols());
  corners << piece.polygon, 1 - piece.polygon.colwise().sum().array();
  Matrix3d square = Matrix3d::Zero();
  for (const FanTriangle& triangle : fan_of(corners)) {
    const QuadraticOnFace r = piece.density * products_of_places(corners(
                                                  Eigen::all, triangle.corner));
    square +=
        face_area * triangle.share * r * fourfold_products() * r.transpose();
  }
  return square;
}

/// int d d' over a face.
Matrix3d oscillation_of(const FaceContact& contact, double area) {
  const QuadraticOnFace nearest =
      raised(facet_density<3>(contact.moments, area));
  std::vector<TractionPiece> parts{{whole_face(), -nearest}};
  for (const TractionPiece& piece : contact.pieces)
    parts = with_piece(parts, piece);
  Matrix3d square = Matrix3d::Zero();
  for (const TractionPiece& part : parts) square += square_of(part, area);
  return square;
}

/// The traction on the opposite face: the same force on another area, turned round.
QuadraticOnFace opposite_density(const FacingPolygon& polygon,
                                 const QuadraticOnFace& own, double own_area,
                                 double opposite_area) {
  const Matrix3d& place = polygon.own_of_opposite;
  const double ratio = own_area * std::abs(place.determinant()) / opposite_area;
  return -ratio * own * products_of_places(place);
}

std::map<int, FaceContact> contact_of_faces(const SolidMesh& mesh,
                                            const Facets<3>& faces,
                                            const ContactSurface& surface,
                                            const TractionFields& traction) {
  const auto on_face = [&](int m) {
    return along_axes(bent_on_face(surface, m, traction));
  };
  std::map<int, FaceContact> contact;
  if (!surface.against_a_body())
    for (int m = 0; m < surface.face_count(); ++m)
      if (normals_differ(surface, m))
        contact[surface.face[m]].pieces.push_back({whole_face(), on_face(m)});
  for (const FacingPolygon& polygon : surface.polygons) {
    const int m = polygon.contact_face, face = surface.face[m];
    const QuadraticOnFace own = on_face(m);
    const Matrix3d& place = polygon.own_of_opposite;
    contact[face].pieces.push_back(
        {with_whole_sides(seen_from_outside(polygon.own), place), own});
    contact[polygon.opposite_face].pieces.push_back(
        {with_whole_sides(seen_from_outside(polygon.opposite), place.inverse()),
         opposite_density(polygon, own, facet_measure(mesh, faces, face),
                          facet_measure(mesh, faces, polygon.opposite_face))});
  }
  for (const TractionPart& part : traction_parts(mesh, faces, surface))
    contact[part.face].moments += on_face(part.contact_face) * part.weight;
  return contact;
}

}  // namespace

double traction_oscillation(const SolidMesh& mesh, const Facets<3>& faces,
                            const ContactSurface& surface,
                            const HookeTensors<3>& hooke,
                            const TractionFields& traction) {
  OscillationSum sum;
  for (const auto& [face, contact] :
       contact_of_faces(mesh, faces, surface, traction)) {
    if (contact.pieces.empty()) continue;  // flat, on a rigid foundation
    const int cell = faces.cells(0, face);
    const double area = facet_measure(mesh, faces, face);
    sum.add(cell, facet_oscillation_square<3>(corners_of(mesh, cell),
                                              hooke[cell].inverse(), area,
                                              oscillation_of(contact, area)));
  }
  return sum.norm();
}

}  // namespace ffcontact
