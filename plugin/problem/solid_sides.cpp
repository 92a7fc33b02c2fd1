// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/contact/checks/compliance_ratio.hpp"
#include "ffcontact/interface/pairing/covered_faces.hpp"
#include "ffcontact/interface/pairing/facing_surface.hpp"
#include "ffcontact/interface/pairing/smooth_surface_distances.hpp"
//
#include "freefem/solid_values.hpp"
#include "problem/glued_vertices.hpp"
#include "problem/pair_sides.hpp"
#include "problem/solid_report.hpp"

namespace ffcontact::plugin {

namespace {

/// The other side carries the multipliers of as much of the surface as this at least.
constexpr double as_much = 0.9;

/// What is stated of surfaces, and what is glued.
struct SurfaceStatement : Statement<3> {
  GluedVertices<3> glued;

  /// Nodes that are left out beside what is glued change what their neighbours follow.
  FacingSurface coupled(const StatedPair& pair, const ContactSurface& surface,
                        const std::vector<FacingPolygon>& polygons) const {
    Flags held(mesh.vertex_count(), 0);
    FacingSurface facing = facing_surface(mesh, facets, surface, polygons);
    while (glued.hold(pair, facing.surface, held))
      facing = facing_surface(mesh, facets, surface, polygons, held);
    return facing;
  }
};

/// By normal=, at places of a body.
Matrix3Xd directions(const Statement<3>& said, int body,
                     const std::vector<FacePlace>& places) {
  Matrix3Xd direction(3, count_of(places));
  for (int c = 0; c < 3; ++c)
    direction.row(c) =
        at_places(said.stack, said.named.component("normal", c, 3),
                  said.part(body), places, 0)
            .transpose();
  return direction;
}

ContactSurface own_surface(const SurfaceStatement& said,
                           const StatedPair& pair) {
  ContactSurface own = contact_surface(said.mesh, said.facets, pair.labels);
  if (!said.named.given("normal") || pair.bonded) return own;
  const Matrix3Xd stated = directions(said, pair.body, places_of_nodes(own));
  Matrix3Xd direction = Matrix3Xd::Zero(3, said.mesh.vertex_count());
  for (int i = own.node_count() - 1; i >= 0; --i)
    direction.col(own.vertex[i]) = stated.col(i);
  return surface_along(said.mesh, said.facets, pair.labels, direction);
}

void require_one_side(const SurfaceStatement& said, const StatedPair& pair,
                      const ContactSurface& own) {
  if (!must_not_face_itself(pair)) return;
  const int touching = touching_face(said.mesh, said.facets, own, pair.labels);
  if (touching < 0) return;
  const Vector3d middle =
      facet_points(said.mesh, said.facets, touching).rowwise().mean();
  refuse_both_sides(
      said.mesh.boundary_label[said.facets.boundary_index[touching]],
      in_words(Vector3d(said.mesh.origin + middle)));
}

/// With the gap between the smooth surfaces of both bodies, where it counts.
std::vector<FacingPolygon> smooth_polygons(const SurfaceStatement& said,
                                           const ContactSurface& own,
                                           const std::vector<int>& opposite,
                                           bool bonded) {
  std::vector<FacingPolygon> polygons =
      facing_polygons(said.mesh, said.facets, own, opposite);
  if (bonded) return polygons;
  smooth_distances(said.mesh, said.facets, own,
                   contact_surface(said.mesh, said.facets, opposite), polygons);
  return polygons;
}

/// @param places  of the nodes on the body that comes first, or of what they face there
/// @param gap     between bodies, where gap= is not given
void put_law(const SurfaceStatement& said, int body,
             const std::vector<FacePlace>& places, VectorXd gap,
             Carrier<3>& carrier) {
  const NamedArguments& named = said.named;
  ContactLaw<3>& law = carrier.law;
  const auto read = [&](const char* name) {
    return at_places(said.stack, named.expression(name), said.part(body),
                     places, 0);
  };
  law.friction = read("friction");
  if (named.given("kineticfriction"))
    carrier.kinetic.friction = read("kineticfriction");
  if (named.given("slipbound"))
    (named.given("friction") ? law.shear_limit : law.slip_bound) =
        read("slipbound");
  law.gap = named.given("gap") ? read("gap") : std::move(gap);
}

Carrier<3> carrier(const SurfaceStatement& said, const StatedPair& pair,
                   FacingSurface facing, const std::vector<FacePlace>& places) {
  Carrier<3> result;
  if (pair.bonded)
    result.law = bonded_law<3>(count_of(places));
  else
    put_law(said, pair.body, places, std::move(facing.gap), result);
  result.contact = std::move(facing.surface);
  for (const FacePlace& place : places) {
    Index nearest;
    place.coordinates.maxCoeff(&nearest);
    result.own_vertex.push_back(said.facets.vertices(nearest, place.face) -
                                said.bodies.joined.first_vertex[pair.body]);
  }
  return result;
}

/// Contact directions are those of the first body, turned.
ContactSurface exchanged_surface(const SurfaceStatement& said,
                                 const StatedPair& pair) {
  ContactSurface whole = contact_surface(said.mesh, said.facets, pair.opposite);
  if (!said.named.given("normal") || pair.bonded) return whole;
  const auto polygons = smooth_polygons(said, whole, pair.labels, pair.bonded);
  const FacingSurface first =
      facing_surface(said.mesh, said.facets, whole, polygons);
  const Matrix3Xd stated =
      directions(said, pair.body, places_faced(first.surface, whole, polygons));
  Matrix3Xd direction = Matrix3Xd::Zero(3, said.mesh.vertex_count());
  for (int i = 0; i < whole.node_count(); ++i)
    direction.col(whole.vertex[i]) = whole.normal.col(i);
  for (int i = 0; i < first.surface.node_count(); ++i)
    direction.col(first.surface.vertex[i]) = -stated.col(i);
  return surface_along(said.mesh, said.facets, pair.opposite, direction);
}

Carrier<3> exchanged(const SurfaceStatement& said, const StatedPair& pair) {
  const ContactSurface whole = exchanged_surface(said, pair);
  const auto polygons = smooth_polygons(said, whole, pair.labels, pair.bonded);
  FacingSurface facing = said.coupled(pair, whole, polygons);
  const std::vector<FacePlace> places =
      places_faced(facing.surface, whole, polygons);
  return carrier(said, pair, std::move(facing), places);
}

/// The other side, if it can carry the multipliers and of as much of the surface.
std::optional<Carrier<3>> as_good(const SurfaceStatement& said,
                                  const StatedPair& pair,
                                  const Carrier<3>& own) {
  try {
    Carrier<3> other = exchanged(said, pair);
    if (other.contact.area.sum() >= as_much * own.contact.area.sum())
      return other;
  } catch (const Refusal&) {  // what stands against it
  }
  return std::nullopt;
}

/// The body that is bonded to the other one with all of its faces carries the multipliers, so
/// that none of its corners hangs free: 1 or 2, 0 for either.
int covered_side(const ContactSurface& own,
                 const std::vector<FacingPolygon>& polygons) {
  CoveredFaces first, second;
  for (const FacingPolygon& polygon : polygons) {
    first.add(own.face[polygon.contact_face], polygon.own);
    second.add(polygon.opposite_face, polygon.opposite);
  }
  if (first.covers_all() == second.covers_all()) return 0;
  return first.covers_all() ? 1 : 2;
}

PairSides<3> facing_sides(const SurfaceStatement& said, const StatedPair& pair,
                          const ContactSurface& own,
                          const std::vector<FacingPolygon>& polygons,
                          int wanted) {
  FacingSurface facing = said.coupled(pair, own, polygons);
  const std::vector<FacePlace> places = places_of_nodes(facing.surface);
  if (wanted == 0 && pair.bonded) wanted = covered_side(own, polygons);
  PairSides<3> sides{false, wanted,
                     carrier(said, pair, std::move(facing), places)};
  if (wanted == 2) sides.other = exchanged(said, pair);
  if (wanted != 0) return sides;
  sides.other = as_good(said, pair, sides.own);
  sides.compliance_ratio = [&bodies = said.bodies, own,
                            polygons](const ElasticSystem& system) {
    return compliance_ratio(bodies.joined.mesh, bodies.facets, own, polygons,
                            system);
  };
  return sides;
}

PairSides<3> sides_of(const SurfaceStatement& said,
                      const std::vector<StatedPair>& pairs, int k) {
  const StatedPair& pair = pairs[k];
  const ContactSurface own = own_surface(said, pair);
  require_one_side(said, pair, own);
  std::vector<FacingPolygon> polygons;
  if (!pair.rigid())
    polygons = smooth_polygons(said, own, pair.opposite, pair.bonded);
  if (!pair.bonded)
    report_surfaces(said.bodies.joined, said.facets, pair,
                    {said.named.given("normal"), said.named.given("gap")});
  if (pair.rigid())
    return {true, 1, carrier(said, pair, {own, {}}, places_of_nodes(own))};
  return facing_sides(said, pair, own, polygons,
                      wanted_side(said.stack, said.named, k, count_of(pairs)));
}

}  // namespace

std::vector<PairSides<3>> read_sides(const Statement<3>& said,
                                     const std::vector<StatedPair>& pairs) {
  SurfaceStatement of_surfaces{said, GluedVertices<3>(said.bodies.joined)};
  return bonded_first<3>(pairs, of_surfaces.glued, [&](int k) {
    return sides_of(of_surfaces, pairs, k);
  });
}

}  // namespace ffcontact::plugin
