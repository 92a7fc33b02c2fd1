// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/contact_face.hpp"
#include "ffcontact/equilibrium/edge_stars.hpp"
#include "ffcontact/equilibrium/face_exchange.hpp"
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
/// Contact tractions change between the steps only (ContactRelaxation); the next direction
/// is conjugate to the last one as ever.
/// Sums are over parts of fixed size and each face gathers what the tetrahedra beside it
/// have for it: the digits do not depend on the number of threads.
///
/// Descents on the shares of a solid go in step. Each knows all faces around its edges, so
/// that z on its own faces needs nothing from others; H p on the tetrahedra of its halo is
/// all that it does, once a step, beside three sums.
class FaceDescent {
 public:
  /// Nothing is exchanged before begin().
  /// @param setting  of the share and its halo; it, share and exchange stay where they are
  /// @param moments  in equilibrium, from which the descent starts
  FaceDescent(const FaceSetting& setting, const FaceMoments& moments,
              const FaceShare& share, const FaceExchange& exchange);

  const FaceForms& forms() const { return forms_; }

  /// @return |sigma_hat - sigma|^2 at first [N mm]
  double begin();

  /// One step; returns by how much e^2 fell.
  double step();

  /// x and -(g + H x) [9 x faces], right on counted faces and, the latter, around edges.
  Matrix9Xd& corrections() { return corrections_; }
  Matrix9Xd& residual() { return residual_; }

 private:
  void gather(Matrix9Xd& y) const;
  double dot(const Matrix9Xd& a, const Matrix9Xd& b) const;
  void add(double factor, const Matrix9Xd& y, Matrix9Xd& x) const;
  void turn_direction();

  const FaceSetting& setting_;
  const FaceShare& share_;
  const FaceExchange& exchange_;
  FaceForms forms_;
  EdgeStars stars_;
  Matrix9Xd corrections_, residual_, direction_, next_;
  FaceImages images_;  ///< slopes, then H p
  Matrix9Xd image_;    ///< H p
  double square_ = 0;  ///< p'Hp; 0: no direction yet
  double of_share_ =
      0;  ///< |sigma_hat - sigma|^2 on its own tetrahedra at first
};

/// Adds the moments of corrections (w, y), but for those of components that are known and
/// not of contact.
void add_corrections(const FaceSetting& setting, const Matrix9Xd& corrections,
                     FaceMoments& moments);

}  // namespace ffcontact
