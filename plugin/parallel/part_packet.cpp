// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/part_packet.hpp"

namespace ffcontact::plugin {

namespace {

/// All members, in one order for both ways.
template <class Part, class Visit>
void visit_members(Part& part, const Visit& visit) {
  auto& [of, share, given, taken, contact_counted, contact_known, has_contact] =
      part;
  auto& [place, hooke, boundary, body_loads, stress, moments] = of;
  auto& [mesh, faces, edges, stars] = place.topology;
  visit(mesh.vertices, mesh.cells);
  visit(faces.vertices, faces.cells, faces.of_cell, faces.eta,
        faces.boundary_index);
  visit(edges.vertices, edges.facet_start, edges.facet, edges.of_facet,
        edges.on_boundary);
  visit(place.cell, place.face);
  visit(hooke, boundary.known, boundary.moments, body_loads, stress.mean,
        stress.variation, moments);
  visit(share.cell, share.facet, share.ridge, share.counted);
  visit(given, taken, contact_counted, contact_known, has_contact);
}

}  // namespace

void put(const FacePart& part, Packet& packet) {
  visit_members(part,
                [&](const auto&... member) { (packet.put(member), ...); });
}

FacePart face_part_in(Packet& packet) {
  FacePart part;
  visit_members(part, [&](auto&... member) { (packet.take_to(member), ...); });
  return part;
}

}  // namespace ffcontact::plugin
