// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/critical_friction.hpp"

#include <algorithm>

#include "ffcontact/contact/uniqueness/slip_pattern.hpp"
#include "ffcontact/linear/dense/dense_lu.hpp"
#include "ffcontact/linear/iterative/krylov.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Reciprocal condition number below which a matrix is singular.
constexpr double singular_matrix = 1e-12;
/// Coefficients below this are those at which the body is not held without friction.
constexpr double none = 1e-6;

/// The law with every coefficient times `factor`.
NodalLaw with_friction(NodalLaw law, double factor) {
  for (FrictionCone& cone : law.cone) cone.friction *= factor;
  return law;
}

bool is_frictionless(const NodalLaw& law) {
  return std::all_of(
      law.cone.begin(), law.cone.end(),
      [](const FrictionCone& c) { return c.frictionless() || c.bonded; });
}

/// The law with a largest coefficient of 1.
NodalLaw normalised(NodalLaw law) {
  const double largest = largest_friction(law);
  if (largest > 0) return with_friction(std::move(law), 1 / largest);
  const double coefficient = is_frictionless(law) ? 1 : 0;
  for (FrictionCone& cone : law.cone)
    if (!cone.bonded) cone.friction = coefficient;
  return law;
}

ContactState at_limit(ContactState state) {
  const int slip = slip_sign(state);
  if (slip == 0) return state;
  return slip > 0 ? ContactState::limited_forward
                  : ContactState::limited_backward;
}

bool slips_by_friction(const FrictionCone& cone, ContactState state) {
  return slip_sign(state) != 0 && !is_limited(state) &&
         cone.depends_on_contact();
}

bool slips_by_friction(const NodalLaw& law, const ContactStates& state) {
  for (std::size_t i = 0; i < state.size(); ++i)
    if (slips_by_friction(law.cone[i], state[i])) return true;
  return false;
}

}  // namespace

double critical_friction(const CondensedContact& contact, const NodalLaw& law,
                         ContactStates state, const Ref<const VectorXd>& P) {
  for (std::size_t i = 0; i < state.size(); ++i)
    if (law.cone[i].at_limit(P[2 * i])) state[i] = at_limit(state[i]);
  const NodalLaw unit = normalised(law);
  if (!slips_by_friction(unit, state)) return infinity;
  const auto matrix_at = [&](double mu) {
    return active_set_matrix(contact, with_friction(unit, mu), state);
  };
  const MatrixXd A_0 = matrix_at(0), A_1 = matrix_at(1) - A_0;
  for (const double shift : {0.0, -1.0}) {
    const DenseLu factor(A_0 + shift * A_1);
    if (factor.reciprocal_condition() < singular_matrix) continue;
    // det(A_0 + mu A_1) = 0 where 1 / (mu - shift) is an eigenvalue
    const double theta = largest_real_eigenvalue(
        [&](const VectorXd& x) { return VectorXd(-factor.solve(A_1 * x)); },
        A_0.rows(), 1 / (none - shift));
    return theta > 0 ? shift + 1 / theta : infinity;
  }
  return 0;
}

}  // namespace ffcontact
