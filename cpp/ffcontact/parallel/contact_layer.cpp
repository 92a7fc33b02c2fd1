// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/contact_layer.hpp"

#include "ffcontact/base/flags.hpp"

namespace ffcontact {

namespace {

std::vector<int> cells_of(const FacetSetting<3>& setting) {
  const FacetTopology<3>& topology = setting.body.topology;
  Flags edge(topology.ridges.count(), 0);
  const auto add = [&](int face) {
    for (int k = 0; k < 3 && face >= 0; ++k)
      edge[topology.ridges.of_facet(k, face)] = 1;
  };
  for (const ContactFacet<3>& contact : setting.contact) {
    add(contact.facet);
    add(contact.opposite);
    for (const FacingPart<3>& part : contact.facing) add(part.facet);
  }
  return cells_at(topology, edge);
}

/// With the numbers of their faces in a part.
std::vector<ContactFacet<3>> in_part(std::vector<ContactFacet<3>> contact,
                                     const std::vector<int>& faces) {
  for (ContactFacet<3>& face : contact) {
    face.facet = place_in(faces, face.facet);
    if (face.opposite >= 0) face.opposite = place_in(faces, face.opposite);
    for (FacingPart<3>& part : face.facing)
      part.facet = place_in(faces, part.facet);
  }
  return contact;
}

}  // namespace

ContactLayer::ContactLayer(const FacetSetting<3>& setting,
                           const FaceMoments& moments)
    : of_(setting_of(setting, moments, cells_of(setting))),
      own_{of_.body(), in_part(setting.contact, of_.part.face),
           setting.oscillation},
      forms_(of_.part.topology, of_.hooke),
      pass_(own_, forms_, of_.moments) {}

}  // namespace ffcontact
