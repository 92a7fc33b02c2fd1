// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/cone/contact_pass.hpp"
#include "ffcontact/parallel/face_part.hpp"

namespace ffcontact {

/// A ContactPass<3> by itself: all that it needs are the tetrahedra around the edges of the
/// contact faces.
class ContactLayer {
 public:
  /// @param setting  of the whole
  ContactLayer(const FacetSetting<3>& setting, const FaceMoments& moments);
  ContactLayer(const ContactLayer&) = delete;

  /// Of the whole, ascending; those of arguments of pass().
  const std::vector<int>& faces() const { return of_.part.face; }
  ContactRelaxation<3>& pass() { return pass_; }

 private:
  PartSetting of_;
  FacetSetting<3> own_;
  FacetForms<3> forms_;
  ContactPass<3> pass_;
};

}  // namespace ffcontact
