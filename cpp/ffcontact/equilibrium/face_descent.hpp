// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/contact_pass.hpp"
#include "ffcontact/equilibrium/edge_stars.hpp"
#include "ffcontact/equilibrium/solid_residual.hpp"

namespace ffcontact {

/// What a solid's face moments are relaxed for: the least
///     e^2 = |sigma_hat - sigma|^2 + 2 sum of contact_term
/// with r_hat in the cone.
struct FaceSetting {
  const SolidTopology& topology;
  const HookeTensors<3>& hooke;
  const FaceTractions& boundary;
  const SolidBodyLoadsOfAll& body_loads;
  const Matrix6Xd& stress;  ///< sigma, constant per tetrahedron [MPa]
  /// faces whose tractions, known in `boundary`, may change in the cone
  std::vector<ContactFace> contact = {};
};

/// The loads of sigma_hat - sigma on one tetrahedron's faces. With the body loads they are
/// in equilibrium when sigma_hat is.
FaceLoads difference_loads(const FaceSetting& setting,
                           const FaceMoments& moments, int cell);

/// sigma_hat - sigma on one tetrahedron [MPa].
SolidStress difference_stress(const FaceSetting& setting,
                              const FaceMoments& moments, int cell);

/// Conjugate gradients for the corrections x = (w, y) of all faces that lower
///     e^2 = |sigma_hat - sigma|^2 = e_0^2 + 2 g'x + x'H x
/// most, from zero, with the additive solves of all edge stars: with r = -(g + H x) and
/// the last direction p,
///     z = EdgeStars r,   p <- z - (z'Hp / p'Hp) p,   x <- x + (r'p / p'Hp) p.
/// Every direction is self-equilibrated and leaves known boundary tractions alone.
/// Contact tractions change between the steps only (contact_pass); the next direction is
/// conjugate to the last one as ever.
/// Sums are over parts of fixed size and each face gathers what the tetrahedra beside it
/// have for it: the digits do not depend on the number of threads.
class FaceDescent {
 public:
  /// @param setting  stays where it is
  /// @param moments  in equilibrium, from which the descent starts
  FaceDescent(const FaceSetting& setting, const FaceMoments& moments);

  /// |sigma_hat - sigma|^2 and the contact part of e^2 at first [N mm]
  double first_square() const { return first_square_; }
  double first_contact_part() const { return first_contact_part_; }

  /// One step; returns by how much e^2 fell.
  double step();

  /// One ContactPass; returns by how much e^2 fell.
  double contact_pass();

  /// The moments of x [N, 9 x faces], 0 on components known but for contact.
  FaceMoments correction() const;

 private:
  void gather(Matrix9Xd& y) const;
  double dot(const Matrix9Xd& a, const Matrix9Xd& b) const;
  void add(double factor, const Matrix9Xd& y, Matrix9Xd& x) const;
  void turn_direction();

  const FaceSetting& setting_;
  FaceForms forms_;
  EdgeStars stars_;
  ContactPass contact_;
  Matrix9Xd corrections_, residual_, direction_, next_;
  Matrix<float, 36, Dynamic> images_;  ///< of tetrahedra: slopes, then H p
  Matrix9Xd image_;                    ///< H p
  double square_ = 0;                  ///< p'Hp; 0: no direction yet
  double first_square_ = 0, first_contact_part_ = 0;
};

}  // namespace ffcontact
