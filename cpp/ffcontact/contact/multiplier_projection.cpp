// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multiplier_projection.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/nodal_law.hpp"

namespace ffcontact {

namespace {

/// The law with the bound that g gives, in units of P.
NodalLaw law_of_step(const ContactLine& line, const ContactLaw& law, const Eigen::VectorXd& given_pressure) {
  const NodalLaw nodal = nodal_law(law, line);
  if (given_pressure.size() == 0 || law.tresca()) return nodal;
  if (law.multiplier == Multiplier::pressure) return with_given_slip_limit(nodal, given_pressure);
  return with_given_slip_limit(nodal, contact_mass(line) * given_pressure);
}

}  // namespace

MultiplierProjection projected_multipliers(const ContactLine& line, const ContactLaw& law,
                                           const Eigen::Ref<const Eigen::Matrix2Xd>& pressure,
                                           const Eigen::Ref<const Eigen::VectorXd>& given_pressure) {
  require_valid(law, line);
  require_size("contact pressures", pressure.cols(), line.node_count());
  require_finite("contact pressure", pressure.reshaped());
  if (given_pressure.size() > 0) {
    require_size("g", given_pressure.size(), line.node_count());
    require_finite("g", given_pressure);
  }

  const NodalLaw nodal = law_of_step(line, law, given_pressure);
  const Eigen::SparseMatrix<double> W = weight_of_rows(Multiplier::pressure, line);
  const bool by_force = law.multiplier == Multiplier::force;
  Eigen::VectorXd P = pressure.reshaped();
  if (by_force) P = W * P;
  const Eigen::VectorXd given = P;
  MultiplierProjection result;
  for (int i = 0; i < line.node_count(); ++i) {
    P[2 * i] = std::min(P[2 * i], 0.0);
    const double bound = nodal.bound(i, P[2 * i]);
    P[2 * i + 1] = std::clamp(P[2 * i + 1], -bound, bound);
    if (P.segment<2>(2 * i) != given.segment<2>(2 * i)) ++result.outside;
  }
  if (by_force) P = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>(W).solve(P);
  result.pressure = P.reshaped(2, line.node_count());
  return result;
}

}  // namespace ffcontact
