// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/displacement/following_faces.hpp"

#include <Eigen/LU>
#include <array>
#include <map>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/unions.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/interface/pairing/covered_faces.hpp"

namespace ffcontact {

namespace {

/// Barycentric coordinates nearer to each other are one.
constexpr double same_place = 1e-9;

/// A polygon from either side: the body with the multipliers follows, or its opposite.
std::array<FollowingPart, 2> both_ways(const ContactSurface& surface,
                                       const FacingPolygon& polygon) {
  const int own = surface.face[polygon.contact_face],
            opposite = polygon.opposite_face;
  const Matrix3d& place = polygon.own_of_opposite;
  return {{{own, opposite, polygon.own, place.inverse()},
           {opposite, own, polygon.opposite, place}}};
}

/// The parts on one side of surfaces that hang together.
struct FollowingSide {
  std::vector<FollowingPart> parts;
  CoveredFaces covered;

  void add(FollowingPart part) {
    covered.add(part.face, part.place);
    parts.push_back(std::move(part));
  }
};
using BothSides = std::array<FollowingSide, 2>;

bool second_follows(const BothSides& sides) {
  const bool first = sides[0].covered.covers_all(),
             second = sides[1].covered.covers_all();
  return second &&
         (!first || sides[1].covered.count() > sides[0].covered.count());
}

/// Numbers of the surfaces that hang together, for each facet of the mesh.
std::vector<int> connected_surfaces(const Facets<3>& faces,
                                    const ContactSurface& surface) {
  Unions surfaces(faces.count());
  std::map<int, int> face_at;  // a vertex
  for (const FacingPolygon& polygon : surface.polygons) {
    const int own = surface.face[polygon.contact_face];
    surfaces.join(own, polygon.opposite_face);
    for (const int face : {own, polygon.opposite_face})
      for (const int v : faces.vertices.col(face))
        surfaces.join(face_at.emplace(v, face).first->second, face);
  }
  return surfaces.numbers();
}

}  // namespace

int FollowingPart::vertex_at(Index corner) const {
  Index k;
  const double nearest = place.col(corner).maxCoeff(&k);
  return nearest > 1 - same_place ? static_cast<int>(k) : -1;
}

int FollowingPart::vertex_across(Index corner) const {
  Index k;
  const double farthest = place.col(corner).minCoeff(&k);
  return farthest < same_place ? static_cast<int>(k) : -1;
}

Matrix3d FollowingPart::jumps(const Facets<3>& faces,
                              const Ref<const VectorXd>& displacement) const {
  const auto values = [&](int f) {
    return vectors_at<3>(displacement, faces.vertices.col(f));
  };
  return values(followed) * followed_place - values(face);
}

std::vector<FollowingPart> following_parts(const Facets<3>& faces,
                                           const ContactSurface& surface) {
  const std::vector<int> connected = connected_surfaces(faces, surface);
  std::map<int, BothSides> all;
  for (const FacingPolygon& polygon : surface.polygons) {
    BothSides& sides = all[connected[polygon.opposite_face]];
    auto [own, opposite] = both_ways(surface, polygon);
    sides[0].add(std::move(own));
    sides[1].add(std::move(opposite));
  }
  std::vector<FollowingPart> following;
  for (auto& [number, sides] : all) {
    FollowingSide& side = sides[second_follows(sides)];
    for (FollowingPart& part : side.parts) {
      part.is_covered = side.covered.covers(part.face);
      following.push_back(std::move(part));
    }
  }
  return following;
}

}  // namespace ffcontact
