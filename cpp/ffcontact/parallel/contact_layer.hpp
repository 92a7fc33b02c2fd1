// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/cone/contact_pass.hpp"
#include "ffcontact/parallel/face_part.hpp"

namespace ffcontact {

/// A ContactPass by itself: all that it needs are the tetrahedra around the edges of the
/// contact faces.
class ContactLayer {
 public:
  /// @param setting  of the whole
  ContactLayer(const FaceSetting& setting, const FaceMoments& moments);
  ContactLayer(const ContactLayer&) = delete;

  /// Of the whole, ascending; those of arguments of pass().
  const std::vector<int>& faces() const { return of_.part.face; }
  ContactRelaxation& pass() { return pass_; }

 private:
  PartSetting of_;
  std::vector<ContactFace> contact_;
  FacetForms<3> forms_;
  ContactPass pass_;
};

}  // namespace ffcontact
