// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/mesh/edges.hpp"

namespace ffcontact {

/// Contact tractions r_hat that star relaxation may change inside the cone, and what they
/// cost.
///
/// For given w_hat the contact part of e^2 is linear in the end values of r_hat, because
/// |r_n| = -r_n in the cone:
///     2 int (mu |r_n||w_t| + r_t w_t + r_n w_n) = sum over edge ends of cost_n r_n + cost_t r_t.
/// In the cone means the conditions of EdgeCone.
struct FreeTractions {
  ContactDensities
      densities;  ///< r_hat, inside the cone before and after [MPa]
  Matrix2Xd
      normal_cost;  ///< cost_n at the two ends of each contact edge [mm^2]
  Matrix2Xd tangential_cost;
  std::vector<int> contact_edge;  ///< contact_edge_numbers
  /// By how much rounding may put r_hat out of the cone: what would do more is left [MPa]
  double rounding = std::numeric_limits<double>::infinity();
};

/// Contact tractions that take part in the relaxation.
struct FreeContact {
  const ContactLine& line;
  const ContactLaw& law;
  FreeTractions& tractions;
  /// vertex fields z_k, linear on the edges, whose int r_hat . z_k stay as they are [2 *
  /// vertices x k]
  MatrixXd kept_work = MatrixXd();
};

/// Number on the contact line of each mesh edge, that of an opposite body which a contact
/// edge faces included, or -1.
std::vector<int> contact_edge_numbers(const ContactLine& line,
                                      const Edges& edges);

}  // namespace ffcontact
