// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/estimate/tractions/carrying_edges.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

/// (n, t) at the first end of an edge, (n, t) at the second one, a column each.
using EndValues = Matrix<double, 4, Dynamic>;

/// [z] at both ends of an edge, one column per motion; where directions turn along it the
/// end values with int r . [z] = r' mass z, M' [z] by r's moments M r (moments_of_ends).
/// @param motions  rigid motions z on all dofs [2 v x k]
EndValues motions_on_edge(const ContactLine& line, const MatrixXd& motions,
                          int e);

/// int a . b over an edge for end values a and b: a' mass b.
Matrix4d mass_of(const ContactLine& line, int e);

/// The projection Pi_C of end values r [MPa] of tractions on the cone of one edge, in L2
/// of the edge: |Pi_C r - r| is the least, r_n <= 0 and |r_t| within friction's bound all
/// along, and what Carrying leaves of it; 0 where rounding hides the minimum.
class EdgeProjection {
 public:
  /// @param line, law  stay where they are
  EdgeProjection(const ContactLine& line, const ContactLaw<2>& law,
                 const MatrixXd& motions, int e,
                 Carrying carrying = Carrying::any);

  Vector4d operator()(const Vector4d& r) const;

  /// r_0 + sum eta_k [z_k].
  Vector4d moved(const Vector4d& r, const VectorXd& eta) const {
    return r + motions_ * eta;
  }

  /// int r . [z_k] of each motion [k], N/mm for a translation by 1.
  VectorXd resultants(const Vector4d& r) const {
    return motions_.transpose() * (mass_ * r);
  }

  /// The same of absolute values, which the resultants are rounded against [k].
  VectorXd terms_of_resultants(const Vector4d& r) const {
    return motions_.cwiseAbs().transpose() * (mass_ * r.cwiseAbs());
  }

  /// d resultants / d eta where r is the projection of `outside` [k x k].
  MatrixXd slope(const Vector4d& r, const Vector4d& outside) const;

 private:
  /// The conditions that are tight at r. Where r is the apex of the cone it is rounding,
  /// small against `outside` only.
  std::vector<int> held(const Vector4d& r, const Vector4d& outside) const;
  /// What is left of the motions where some conditions stay tight.
  MatrixXd moving_on_face(const std::vector<int>& held) const;

  const ContactLine& line_;
  const ContactLaw<2>& law_;
  int edge_;
  EdgeCone cone_;
  Matrix4d mass_;
  EndValues motions_;
  MatrixXd basis_;      ///< of the end values that are free
  MatrixXd free_mass_;  ///< the mass on them
  Cholesky half_;       ///< of it
  /// the motions in the coordinates y = half' x of the free end values x [b x k]
  MatrixXd moving_;
};

}  // namespace ffcontact
