// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"

namespace ffcontact {

/// An admissible pair obeys the law at every point of the contact boundary, not at nodes
/// alone. Then the integrand of the contact part of e^2,
///     f = c(r_n) |w_t| + r_t . w_t + r_n (w_n - gap),        [CHH01, (2.11), (2.19)]
/// is nowhere negative: |r_t| <= c, r_n <= 0 and w_n <= gap. Where the contact directions
/// of a facet's nodes are the same it follows from its nodes, as r_hat and w_hat are linear
/// between them. Where they differ it does not: with n(x) turning from n_i to n_j, r_hat
/// leaves the cone about n(x) and w_hat . n(x) the gap, and e is no bound.
struct BetweenNodes {
  /// largest -f, of the points of FacetFields [MPa mm], and the facet that has it
  double negative = 0;
  int negative_facet = 0;
  /// largest angle between the directions of two nodes of a facet that carries tractions or
  /// that u_hat penetrates [rad], and that facet; below 1e-11 it is rounding and 0
  double turn = 0;
  int turned_facet = 0;
};

/// |w_t| below this is rounding and counts as 0, as e would pay c times it for any c: a u_hat
/// that differs by rounding has w_t = 0 [mm].
template <class Law>
double rounding_of_slip(const Law& law, const Ref<const VectorXd>& u_hat) {
  constexpr double part = 1e-13;
  return part * largest_displacement(law, u_hat);
}
inline double slip_beyond(double least, double slip) {
  return std::abs(slip) > least ? slip : 0;
}

/// What is linear between the corners of a contact facet, or of a part of it, one column a
/// corner.
template <int dim>
struct FacetFields {
  Matrix<double, dim, Dynamic> normal;  ///< n, of any length between the nodes
  Matrix<double, dim, Dynamic> traction;  ///< r_hat [MPa]
  /// w_hat less the gap along n and the load step before [mm]
  Matrix<double, dim, Dynamic> motion;
  std::vector<FrictionCone> cone;
};

/// f at the corners, at the quarters of the sides between neighbours, and in the middle.
template <int dim>
void note(const FacetFields<dim>& fields,
          const Matrix<double, dim, Dynamic>& normals_of_nodes, int facet,
          BetweenNodes& found);

}  // namespace ffcontact
