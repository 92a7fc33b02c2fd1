// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/contact_densities.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// What a law lets tractions or multipliers be at one place:
///     P_n <= 0,   |P_t| <= min(c + mu |P_n|, k)
/// Coulomb's law has mu alone, with a shear limit k beside it; Tresca's has c alone, its
/// given bound. In units of P. Where bodies are bonded the cone is all of the plane or space.
struct FrictionCone {
  double cohesion = 0;                                     ///< c
  double friction = 0;                                     ///< mu
  double limit = std::numeric_limits<double>::infinity();  ///< k
  bool bonded = false;

  double bound(double Pn) const {
    if (bonded) return std::numeric_limits<double>::infinity();
    return std::min(cohesion + friction * std::max(0.0, -Pn), limit);
  }
  bool at_limit(double Pn) const { return cohesion - friction * Pn > limit; }
  bool frictionless() const {
    return !bonded && ((cohesion == 0 && friction == 0) || limit == 0);
  }
  /// How far P with |P_t| = `along` is outside, 0 inside.
  double violation(double Pn, double along) const {
    return bonded ? 0 : std::max({0.0, Pn, along - bound(Pn)});
  }
  /// Does friction ask for contact? A bound that is given holds open places, too.
  bool depends_on_contact() const { return friction > 0; }
  /// The nearest P with P_n = min(P_n, 0) and P_t in what that allows.
  Vector2d clamped(const Vector2d& P) const {
    if (bonded) return P;
    const double Pn = std::min(P[0], 0.0), b = bound(Pn);
    return {Pn, std::clamp(P[1], -b, b)};
  }
};

/// The cones at the ends of a contact edge. Between them c, mu and k are linear: nowhere
/// above those of the law (least), or nowhere below (most).
using ConesAtEnds = std::array<FrictionCone, 2>;
ConesAtEnds least_cones(const ContactLine& line, const ContactLaw<2>& law,
                        int edge);
ConesAtEnds most_cones(const ContactLine& line, const ContactLaw<2>& law,
                       int edge);

/// The law on one contact edge as linear conditions C r >= d on the end values r =
/// (r_n,i, r_t,i, r_n,j, r_t,j).
///
/// With its least_cones and p = -r_n:
///     r_n <= 0,   |r_t| <= c + mu p,   |r_t| <= k                   at both ends.
/// Where mu_i and mu_j differ, the edge is in the cone all along if and only if the
/// quadratics c + mu p -+ r_t with the Bernstein coefficients
///     b_0 = (c + mu p -+ r_t)_i,   b_2 = (c + mu p -+ r_t)_j,
///     2 b_1 = c_i + c_j + mu_i p_j + mu_j p_i -+ (r_t,i + r_t,j)
/// have b_1 >= -sqrt(b_0 b_2). Chords between the rays b_2 = rho^2 b_0 with rho = 0,
/// 2^(-rays/2), ..., 2^(rays/2), infinity take the place of the root,
///     (rho_k + rho_l) b_1 + rho_k rho_l b_0 + b_2 >= 0              for neighbours k, l,
/// at most 1.5 % inside it for ratios b_2 / b_0 up to 2^rays. Without friction at an end
/// r_t = 0 there is no inequality: it is not in C. Where bodies are bonded C has no rows.
struct EdgeCone {
  static constexpr int rays = 16;
  static constexpr Index most_rows = 2 * (1 + 2 * 2 + 2 * rays + 2);
  Eigen::Array2<bool> frictionless;  ///< per end
  Matrix<double, Dynamic, 4> C;
  VectorXd d;
};
EdgeCone edge_cone(const ConesAtEnds& cones);
EdgeCone edge_cone(const ContactLine& line, const ContactLaw<2>& law, int edge);

/// Cuts off the rounding of end values r that are in the cone of their edge but for it.
Vector4d clamped_to_cone(const ContactLine& line, const ContactLaw<2>& law,
                         int edge, const Vector4d& r);

/// Largest of r_n and |r_t| - c along all edges, with c from the lower bound of the
/// coefficient, relative to the largest traction; 0 inside the cone.
double cone_defect(const ContactLine& line, const ContactLaw<2>& law,
                   const ContactDensities& densities);

}  // namespace ffcontact
