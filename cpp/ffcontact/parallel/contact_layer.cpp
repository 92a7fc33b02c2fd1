// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/contact_layer.hpp"

#include "ffcontact/base/flags.hpp"

namespace ffcontact {

namespace {

std::vector<int> cells_of(const FaceSetting& setting) {
  const Topology<3>& topology = setting.topology;
  Flags edge(topology.ridges.count(), 0);
  for (const ContactFace& contact : setting.contact)
    for (int face : {contact.face, contact.opposite})
      for (int k = 0; k < 3 && face >= 0; ++k)
        edge[topology.ridges.of_facet(k, face)] = 1;
  return cells_at(topology, edge);
}

/// With the numbers of their faces in a part.
std::vector<ContactFace> in_part(std::vector<ContactFace> contact,
                                 const std::vector<int>& faces) {
  for (ContactFace& face : contact) {
    face.face = place_in(faces, face.face);
    if (face.opposite >= 0) face.opposite = place_in(faces, face.opposite);
  }
  return contact;
}

}  // namespace

ContactLayer::ContactLayer(const FaceSetting& setting,
                           const FaceMoments& moments)
    : of_(setting_of(setting, moments, cells_of(setting))),
      contact_(in_part(setting.contact, of_.part.face)),
      forms_(of_.part.topology, of_.hooke),
      pass_(of_.part.topology, of_.boundary, forms_, contact_, of_.moments) {}

}  // namespace ffcontact
