// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/cholesky.hpp"
#include "ffcontact/contact/friction_cone.hpp"

namespace ffcontact {

using EndValues = Matrix<double, 4, Dynamic>;

/// The components (n, t) of [z] at both ends of an edge, one column per motion.
EndValues motions_on_edge(const ContactLine& line, const MatrixXd& motions,
                          int e);

/// int a . b over an edge for end values a and b: a' mass b.
Matrix4d mass_of(const ContactLine& line, int e);

/// The projection Pi_C on the cone of one edge, in L2 of the edge.
class EdgeProjection {
 public:
  /// @param line, law  stay where they are
  EdgeProjection(const ContactLine& line, const ContactLaw& law,
                 const MatrixXd& motions, int e);

  Vector4d operator()(const Vector4d& r) const;

  /// r_0 + sum eta_k [z_k].
  Vector4d moved(const Vector4d& r, const VectorXd& eta) const {
    return r + motions_ * eta;
  }

  VectorXd resultants(const Vector4d& r) const {
    return motions_.transpose() * (mass_ * r);
  }

  VectorXd terms_of_resultants(const Vector4d& r) const {
    return motions_.cwiseAbs().transpose() * (mass_ * r.cwiseAbs());
  }

  /// d resultants / d eta where r is the projection of `outside`.
  MatrixXd slope(const Vector4d& r, const Vector4d& outside) const;

 private:
  /// The conditions that are tight at r. Where r is the apex of the cone it is rounding,
  /// small against `outside` only.
  std::vector<int> held(const Vector4d& r, const Vector4d& outside) const;
  /// What is left of the motions where some conditions stay tight.
  MatrixXd moving_on_face(const std::vector<int>& held) const;

  const ContactLine& line_;
  const ContactLaw& law_;
  int edge_;
  EdgeCone cone_;
  Matrix4d mass_;
  EndValues motions_;
  MatrixXd basis_;      ///< free_end_values
  MatrixXd free_mass_;  ///< the mass on them
  Cholesky half_;       ///< of it
  /// the motions in the coordinates y = half' x of the free end values x [b x k]
  MatrixXd moving_;
};

}  // namespace ffcontact
