// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/cone/contact_relaxation.hpp"
#include "ffcontact/equilibrium/cone/contact_star.hpp"

namespace ffcontact {

/// Relaxes contact tractions inside the cone: one after the other, the stars of the edges
/// with contact faces take what lowers e^2 most (ContactStar). Where faces of two bodies
/// match (ContactFace::opposite) a star goes through both.
///
/// The order is that of the middles of the edges, whatever their numbers.
/// Stars that have no tetrahedron's face in common are of one colour and change together:
/// the digits do not depend on the number of threads.
class ContactPass : public ContactRelaxation {
 public:
  /// @param boundary  known tractions, those of contact among them
  /// @param contact   stays where it is; empty: a pass does nothing
  /// @param moments   of all faces, from which r_hat is taken
  ContactPass(const Topology<3>& topology, const FaceTractions& boundary,
              const FacetForms<3>& forms,
              const std::vector<ContactFace>& contact,
              const FaceMoments& moments);

  bool is_free() const override { return !contact_.empty(); }
  double contact_part() const override;
  /// @param least_fall  what is nothing in a star
  double pass(double least_fall, Matrix9Xd& corrections,
              Matrix9Xd& residual) override;

 private:
  void colour();
  double relax(const ContactStar& star, const ContactStar::Scales& scales,
               Matrix9Xd& corrections, Matrix9Xd& residual);

  const Topology<3>& topology_;
  const FacetForms<3>& forms_;
  const std::vector<ContactFace>& contact_;
  std::vector<Matrix3d> tractions_;  ///< r_hat of the contact faces
  std::vector<ContactStar> stars_;
  std::vector<std::vector<int>> colours_;  ///< the stars of each
};

}  // namespace ffcontact
