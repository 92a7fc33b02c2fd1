// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_law.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

void require_valid(const ContactLaw& law, const ContactLine& line) {
  require_size("friction", law.friction.size(), line.node_count());
  require_nonnegative("friction", law.friction);
  if (law.tresca()) {
    require_size("slipbound", law.slip_bound.size(), line.node_count());
    require_nonnegative("slipbound", law.slip_bound);
  }
  if (law.gap.size() > 0) {
    require_size("gap", law.gap.size(), line.node_count());
    require_finite("gap", law.gap);
  }
}

Eigen::SparseMatrix<double> weight_matrix(Multiplier multiplier, const ContactLine& line) {
  if (multiplier == Multiplier::pressure) return contact_mass(line);
  Eigen::SparseMatrix<double> identity(line.node_count(), line.node_count());
  identity.setIdentity();
  return identity;
}

double complementarity_defect(const ContactLine& line, const ContactLaw& law,
                              const Eigen::Ref<const Eigen::VectorXd>& displacement,
                              const Eigen::Ref<const Eigen::Matrix2Xd>& multiplier) {
  const Eigen::SparseMatrix<double> W = weight_matrix(law.multiplier, line);
  Eigen::Matrix2Xd trace = contact_components(line, displacement);
  if (law.gap.size() > 0) trace.row(0) -= law.gap.transpose();
  const Eigen::Matrix2Xd v = trace * W;  // W is symmetric
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(line.node_count());
  const double v_scale = displacement.cwiseAbs().maxCoeff() * (W * ones).maxCoeff();
  const double p_scale = multiplier.cwiseAbs().maxCoeff();
  if (v_scale == 0 || p_scale == 0) return std::max({0.0, v.row(0).maxCoeff(), multiplier.row(0).maxCoeff()});

  Eigen::VectorXd tresca_bound;
  if (law.tresca()) tresca_bound = law.multiplier == Multiplier::force ? contact_mass(line) * law.slip_bound : law.slip_bound;

  double defect = 0;
  for (int i = 0; i < line.node_count(); ++i) {
    const double Pn = multiplier(0, i) / p_scale, Pt = multiplier(1, i) / p_scale;
    const double vn = v(0, i) / v_scale, vt = v(1, i) / v_scale;
    const double bound = law.tresca() ? tresca_bound[i] / p_scale : -law.friction[i] * Pn;
    defect = std::max({defect, Pn, vn, std::abs(Pn * vn),           // (3.17)-(3.19)
                       std::abs(Pt) - bound,                       // (3.20)
                       std::min(bound - std::abs(Pt), std::abs(vt)),  // (3.21)
                       Pt * vt});                                  // (3.22)
  }
  return defect;
}

}  // namespace ffcontact
