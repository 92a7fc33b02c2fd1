// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/elastic_system.hpp"

/// What every factor of K that stops before kept dofs has in common, whoever makes it: it
/// is one of R K R with R = diag(K)^-1/2, so that units, and materials or cells that
/// differ by any factor, do not count as singular.
namespace ffcontact {

/// @param memory  of the machine [bytes]
/// @throws std::invalid_argument  if Schur's complement on so many dofs takes more than half
///                                of it in the three copies that dense algebra works with
void require_room_for_schur(int kept, double memory);

/// The kept dofs themselves.
/// @throws std::invalid_argument  if a kept dof is prescribed, out of range or listed
///                                twice, or by require_room_for_schur on this machine
const std::vector<int>& required_kept(const ElasticSystem& system,
                                      const std::vector<int>& kept);

/// R [all dofs]: K_ii^-1/2; 1 where the dof is prescribed, or where nothing holds it, which
/// shows in the factor.
VectorXd inverse_roots(const ElasticSystem& system);

/// Place of each dof in an order of free ones; prescribed ones -1.
std::vector<int> places(const std::vector<int>& order, std::size_t dofs);

/// R^-1 S R^-1 of a Schur complement that is not needed any more.
/// @tparam Scalar  double or float
/// @param R  on the kept dofs
template <class Scalar>
MatrixXd unscaled(Matrix<Scalar, Dynamic, Dynamic> S, const VectorXd& R);

/// @throws std::runtime_error  always: a part of the body is held by nothing
[[noreturn]] void fail_as_singular();

}  // namespace ffcontact
