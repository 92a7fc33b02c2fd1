// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/solid_problem.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ffcontact/base/appended.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/compliance_ratio.hpp"
#include "ffcontact/interface/joined_surfaces.hpp"
#include "ffcontact/interface/pairing/smooth_surface_distances.hpp"
//
#include "problem/solid_report.hpp"

namespace ffcontact::plugin {

namespace {

/// The other side carries the multipliers of as much of the surface as this at least.
constexpr double as_much = 0.9;

}  // namespace

SolidProblem::SolidProblem(Stack stack, const NamedArguments& named,
                           const std::vector<pmesh3>& meshes)
    : Bodies<3>(meshes) {
  previous_ = stated_previous(stack, named, *this);
  state(stack, named);
}

SolidProblem::SolidProblem(Stack stack, const NamedArguments& named,
                           JoinedSolids whole,
                           const PlacesElsewhere<3>& elsewhere,
                           VectorXd previous)
    : Bodies<3>(std::move(whole)),
      elsewhere_(&elsewhere),
      previous_(std::move(previous)) {
  state(stack, named);
  elsewhere_ = nullptr;
}

void SolidProblem::state(Stack stack, const NamedArguments& named) {
  if (named.given("corner"))
    refuse(
        "corner= is for plane bodies so far: give the surface's normal=[nx, "
        "ny, nz]");
  layer_ = stated_layer(stack, named);
  const std::vector<StatedPair> stated = stated_pairs(stack, named, joined);
  for (const StatedPair& pair : stated) body_of_pair.push_back(pair.body);
  for (const StatedPair& pair : stated) add_pair(stack, named, pair);
  join_carriers();
}

ContactSurface SolidProblem::stated_surface(
    Stack stack, const NamedArguments& named, int body,
    const std::vector<int>& labels) const {
  ContactSurface own = contact_surface(mesh, facets, labels);
  if (!named.given("normal")) return own;
  const std::vector<FacePlace> places = places_of_nodes(own);
  Matrix3Xd direction = Matrix3Xd::Zero(3, mesh.vertices.cols());
  for (int c = 0; c < 3; ++c) {
    const VectorXd values = at_places(stack, named.component("normal", c, 3),
                                      part(body, elsewhere_), places, 0);
    for (int i = own.node_count() - 1; i >= 0; --i)
      direction(c, own.vertex[i]) = values[i];
  }
  return surface_along(mesh, facets, labels, direction);
}

void SolidProblem::require_one_side(const StatedPair& stated,
                                    const ContactSurface& whole) const {
  if (!must_not_face_itself(stated)) return;
  const int touching = touching_face(mesh, facets, whole, stated.labels);
  if (touching < 0) return;
  const Vector3d middle = facet_points(mesh, facets, touching).rowwise().mean();
  refuse_both_sides(mesh.boundary_label[facets.boundary_index[touching]],
                    in_words(Vector3d(mesh.origin + middle)));
}

void SolidProblem::add_pair(Stack stack, const NamedArguments& named,
                            const StatedPair& stated) {
  Pair pair;
  pair.whole = stated_surface(stack, named, stated.body, stated.labels);
  require_one_side(stated, pair.whole);
  if (!stated.rigid())
    pair.polygons = smooth_polygons(pair.whole, stated.opposite);
  report_surfaces(joined, facets, stated,
                  {named.given("normal"), named.given("gap")});
  if (!stated.rigid()) {
    add_facing_pair(stack, named, stated, std::move(pair));
    return;
  }
  pair.own = carrier(stack, named, stated.body, {pair.whole, {}},
                     places_of_nodes(pair.whole));
  pairs_.push_back(std::move(pair));
}

void SolidProblem::add_facing_pair(Stack stack, const NamedArguments& named,
                                   const StatedPair& stated, Pair pair) {
  pair.wanted =
      wanted_side(stack, named, count_of(pairs_), count_of(body_of_pair));
  FacingSurface facing =
      facing_surface(mesh, facets, pair.whole, pair.polygons);
  const std::vector<FacePlace> places = places_of_nodes(facing.surface);
  pair.own = carrier(stack, named, stated.body, std::move(facing), places);
  if (pair.wanted == 2)
    pair.other = exchanged(stack, named, stated);
  else if (pair.wanted == 0)
    pair.other = as_good(pair.own, stack, named, stated);
  pairs_.push_back(std::move(pair));
}

/// With the gap between the smooth surfaces of both bodies.
std::vector<FacingPolygon> SolidProblem::smooth_polygons(
    const ContactSurface& whole, const std::vector<int>& opposite) const {
  std::vector<FacingPolygon> polygons =
      facing_polygons(mesh, facets, whole, opposite);
  smooth_distances(mesh, facets, whole, contact_surface(mesh, facets, opposite),
                   polygons);
  return polygons;
}

/// Contact directions are those of the first body, turned.
SolidProblem::Carrier SolidProblem::exchanged(Stack stack,
                                              const NamedArguments& named,
                                              const StatedPair& stated) const {
  ContactSurface whole = contact_surface(mesh, facets, stated.opposite);
  std::vector<FacingPolygon> polygons = smooth_polygons(whole, stated.labels);
  if (named.given("normal")) {
    const FacingSurface first = facing_surface(mesh, facets, whole, polygons);
    const std::vector<FacePlace> places =
        places_faced(first.surface, whole, polygons);
    Matrix3Xd direction = Matrix3Xd::Zero(3, mesh.vertices.cols());
    for (int i = 0; i < whole.node_count(); ++i)
      direction.col(whole.vertex[i]) = whole.normal.col(i);
    for (int c = 0; c < 3; ++c) {
      const VectorXd values =
          at_places(stack, named.component("normal", c, 3),
                    part(stated.body, elsewhere_), places, 0);
      for (int i = 0; i < first.surface.node_count(); ++i)
        direction(c, first.surface.vertex[i]) = -values[i];
    }
    whole = surface_along(mesh, facets, stated.opposite, direction);
    polygons = smooth_polygons(whole, stated.labels);
  }
  FacingSurface facing = facing_surface(mesh, facets, whole, polygons);
  const std::vector<FacePlace> places =
      places_faced(facing.surface, whole, polygons);
  return carrier(stack, named, stated.body, std::move(facing), places);
}

/// The other side, if it can carry the multipliers and of as much of the surface.
std::optional<SolidProblem::Carrier> SolidProblem::as_good(
    const Carrier& own, Stack stack, const NamedArguments& named,
    const StatedPair& stated) const {
  try {
    Carrier other = exchanged(stack, named, stated);
    if (other.surface.area.sum() >= as_much * own.surface.area.sum())
      return other;
  } catch (const Refusal&) {  // what stands against it
  }
  return std::nullopt;
}

/// @param places  of the nodes on the body that comes first, or of what they face there
SolidProblem::Carrier SolidProblem::carrier(
    Stack stack, const NamedArguments& named, int body, FacingSurface facing,
    const std::vector<FacePlace>& places) const {
  const auto read = [&](const char* name) {
    return at_places(stack, named.expression(name), part(body, elsewhere_),
                     places, 0);
  };
  Carrier result;
  result.law.friction = read("friction");
  if (named.given("kineticfriction")) result.kinetic = read("kineticfriction");
  if (named.given("slipbound"))
    (named.given("friction") ? result.law.shear_limit : result.law.slip_bound) =
        read("slipbound");
  if (named.given("gap")) facing.gap = read("gap");
  result.law.gap = facing.gap;
  result.surface = std::move(facing.surface);
  for (const FacePlace& place : places) {
    Index nearest;
    place.coordinates.maxCoeff(&nearest);
    result.own_vertex.push_back(facets.vertices(nearest, place.face) -
                                joined.first_vertex[body]);
  }
  return result;
}

void SolidProblem::choose_sides(const ElasticSystem& system) {
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const Pair& pair = pairs_[k];
    if (pair.wanted != 0 || !pair.other) continue;
    const double ratio =
        compliance_ratio(mesh, facets, pair.whole, pair.polygons, system);
    side[k] = ratio > much_softer ? 2 : 1;
  }
  join_carriers();
}

/// But for the surface itself.
void SolidProblem::append_carrier(const Carrier& carrier) {
  own_vertex.insert(own_vertex.end(), carrier.own_vertex.begin(),
                    carrier.own_vertex.end());
  first_node.push_back(count_of(own_vertex));
  for (VectorXd SurfaceLaw::*nodal :
       {&SurfaceLaw::friction, &SurfaceLaw::slip_bound,
        &SurfaceLaw::shear_limit, &SurfaceLaw::gap})
    append(carrier.law.*nodal, law.*nodal);
  append(carrier.kinetic, kinetic.friction);
}

void SolidProblem::join_carriers() {
  if (side.empty())
    for (const Pair& pair : pairs_)
      if (!pair.polygons.empty()) side.push_back(std::max(1, pair.wanted));
  law = {};
  kinetic = {};
  own_vertex.clear();
  first_node = {0};
  std::vector<ContactSurface> surfaces;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const bool on_other = !pairs_[k].polygons.empty() && side[k] == 2;
    const Carrier& carrier = on_other ? *pairs_[k].other : pairs_[k].own;
    surfaces.push_back(carrier.surface);
    append_carrier(carrier);
  }
  surface = joined_surfaces(surfaces);
  if (previous_.size() > 0)
    law.previous = contact_components(surface, previous_).bottomRows<2>();
  law.layer = layer_;
  require_valid(law, surface);
  if (kinetic.given()) require_kinetic(kinetic.friction, law.friction);
}

Matrix3Xd SolidProblem::places() const {
  return mesh.vertices(Eigen::all, surface.vertex).colwise() + mesh.origin;
}

}  // namespace ffcontact::plugin
