// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/admissible_tractions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "ffcontact/base/nonnegative_least_squares.hpp"
#include "ffcontact/base/quadratic_minimum.hpp"

namespace ffcontact {

namespace {

/// Resultants are kept to this part of their scale.
constexpr double resultant_tolerance = 1e-12;

Eigen::Matrix2d end_values(const ContactDensities& densities, int e) {
  Eigen::Matrix2d r;
  r << densities.normal.col(e).transpose(), densities.tangential.col(e).transpose();
  return r;
}

void set_end_values(ContactDensities& densities, int e, const Eigen::Matrix2d& r) {
  densities.normal.col(e) = r.row(0).transpose();
  densities.tangential.col(e) = r.row(1).transpose();
}

/// int r phi at the two ends of an edge, Cartesian, one column each: l (2 r_i + r_j) / 6 at i.
Eigen::Matrix2d end_moments(const ContactLine& line, const ContactDensities& densities, int e) {
  Eigen::Matrix2d frame;
  frame << line.edge_normal(e), line.edge_tangent(e);
  const Eigen::Matrix2d r = frame * end_values(densities, e);
  return line.length[e] / 6 * (r + r.rowwise().sum().replicate<1, 2>());
}

/// Upper factor R of the mass matrix of an edge of length 1, |values|^2 = |R values|^2.
Eigen::Matrix2d mass_factor() {
  Eigen::Matrix2d mass;
  mass << 1.0 / 3, 1.0 / 6, 1.0 / 6, 1.0 / 3;
  return mass.llt().matrixU();
}

/// Nonpositive values nearest to the given ones in L2.
Eigen::Vector2d nearest_nonpositive(const Eigen::Vector2d& values) {
  const Eigen::Matrix2d R = mass_factor();
  return -nonnegative_least_squares(R, -R * values);
}

/// Values between -bound and bound nearest to the given ones in L2.
Eigen::Vector2d nearest_within(const Eigen::Vector2d& values, const Eigen::Vector2d& bound) {
  const Eigen::Matrix2d R = mass_factor(), mass = R.transpose() * R;
  Eigen::Matrix<double, 4, 2> sides;
  sides << Eigen::Matrix2d::Identity(), -Eigen::Matrix2d::Identity();
  const Eigen::Vector2d nearest =
      *quadratic_minimum(mass, -mass * values, sides, Eigen::Vector4d(-bound.replicate<2, 1>()));
  return nearest.cwiseMin(bound).cwiseMax(-bound);  // rounding
}

/// [z] of vertex fields at a node, one column per field.
Eigen::Matrix2Xd jump(const ContactLine& line, int node, const Eigen::MatrixXd& fields) {
  Eigen::Matrix2Xd value = fields.middleRows<2>(2 * line.vertex[node]);
  visit_opposite(line, node, [&](int vertex, double weight) { value -= weight * fields.middleRows<2>(2 * vertex); });
  return value;
}

/// int [z] . r over each edge, one row per motion [k x m].
Eigen::MatrixXd resultants(const ContactLine& line, const ContactDensities& densities, const Eigen::MatrixXd& motions) {
  Eigen::MatrixXd result(motions.cols(), line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    const Eigen::Matrix2d moments = end_moments(line, densities, e);
    result.col(e).setZero();
    for (int end = 0; end < 2; ++end)
      result.col(e) += jump(line, line.edge_node(end, e), motions).transpose() * moments.col(end);
  }
  return result;
}

/// Factors s >= 0 nearest to 1 with C s = wanted; empty when there are none.
Eigen::VectorXd restoring_factors(const Eigen::MatrixXd& C, const Eigen::VectorXd& wanted, double scale) {
  Eigen::VectorXd s = Eigen::VectorXd::Ones(C.cols());
  std::vector<char> switched_off(C.cols(), 0);
  for (Eigen::Index round = 0; round <= C.cols(); ++round) {
    Eigen::MatrixXd active = C;
    for (Eigen::Index e = 0; e < C.cols(); ++e)
      if (switched_off[e]) {
        active.col(e).setZero();
        s[e] = 0;
      } else {
        s[e] = 1;
      }
    s += active.completeOrthogonalDecomposition().solve(wanted - active * s);
    bool inside = true;
    for (Eigen::Index e = 0; e < s.size(); ++e)
      if (s[e] < 0) {
        switched_off[e] = 1;
        inside = false;
      }
    if (inside) break;
  }
  const bool restored = s.minCoeff() >= 0 && (C * s - wanted).cwiseAbs().maxCoeff() <= resultant_tolerance * scale;
  return restored ? s : Eigen::VectorXd();
}

void scale_edges(const Eigen::VectorXd& factors, bool tresca, ContactDensities& densities) {
  densities.normal *= factors.asDiagonal();
  if (!tresca) densities.tangential *= factors.asDiagonal();
}

void restore_resultants(const ContactLine& line, const ContactLaw& law, const ContactDensities& computed,
                        const Eigen::MatrixXd& motions, AdmissibleTractions& result) {
  const Eigen::MatrixXd before = resultants(line, computed, motions);
  ContactDensities scaled = result.balanced;
  Eigen::VectorXd wanted = before.rowwise().sum();
  if (law.tresca()) {
    ContactDensities tangential = result.balanced;
    tangential.normal.setZero();
    wanted -= resultants(line, tangential, motions).rowwise().sum();
    scaled.tangential.setZero();
  }
  const Eigen::VectorXd factors = restoring_factors(resultants(line, scaled, motions), wanted, before.cwiseAbs().sum());
  result.resultants_kept = factors.size() > 0;
  if (!result.resultants_kept) return;
  scale_edges(factors, law.tresca(), result.balanced);
  scale_edges(factors, law.tresca(), result.densities);
  if (!law.tresca()) result.shift.array() *= factors.array();
}

}  // namespace

Eigen::Matrix2d nearest_in_cone(const ContactLaw& law, int first_node, int second_node,
                                const Eigen::Matrix2d& density) {
  Eigen::Matrix2d nearest;
  const int nodes[2] = {first_node, second_node};
  if (law.tresca()) {
    nearest.row(0) = nearest_nonpositive(density.row(0).transpose()).transpose();
    const Eigen::Vector2d bound(law.slip_bound[first_node], law.slip_bound[second_node]);
    nearest.row(1) = nearest_within(density.row(1).transpose(), bound).transpose();
    return nearest;
  }
  // r = a (-1, mu) + b (-1, -mu) with a, b >= 0 at both ends.
  const Eigen::Matrix2d R = mass_factor();
  Eigen::Matrix4d G = Eigen::Matrix4d::Zero();  // rows: normal at both ends, tangential at both ends
  for (int end = 0; end < 2; ++end)
    for (int ray = 0; ray < 2; ++ray) {
      G.block<2, 1>(0, 2 * end + ray) = -R.col(end);
      G.block<2, 1>(2, 2 * end + ray) = (ray == 0 ? 1 : -1) * law.friction[nodes[end]] * R.col(end);
    }
  Eigen::Vector4d target;
  target << R * density.row(0).transpose(), R * density.row(1).transpose();
  const Eigen::Vector4d rays = nonnegative_least_squares(G, target);
  for (int end = 0; end < 2; ++end) {
    nearest(0, end) = -rays[2 * end] - rays[2 * end + 1];
    nearest(1, end) = law.friction[nodes[end]] * (rays[2 * end] - rays[2 * end + 1]);
  }
  return nearest;
}

Eigen::VectorXd nodal_forces(const Mesh& mesh, const ContactLine& line, const ContactDensities& densities) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * mesh.vertices.cols());
  for (int e = 0; e < line.edge_count(); ++e) {
    const Eigen::Matrix2d moments = end_moments(line, densities, e);
    for (int end = 0; end < 2; ++end) {
      const int node = line.edge_node(end, e);
      forces.segment<2>(2 * line.vertex[node]) += moments.col(end);
      visit_opposite(line, node,
                     [&](int vertex, double weight) { forces.segment<2>(2 * vertex) -= weight * moments.col(end); });
    }
  }
  return forces;
}

AdmissibleTractions admissible_tractions(const ContactLine& line, const ContactLaw& law,
                                         const ContactDensities& computed, const Eigen::MatrixXd& motions) {
  const ConeCorrection correction = correct_to_cone(line, law, computed);
  AdmissibleTractions result{correction.densities, computed, correction.shift, correction.uncorrected};
  if (result.mended.empty()) return result;
  for (int e : result.mended) {
    const Eigen::Matrix2d nearest =
        nearest_in_cone(law, line.edge_node(0, e), line.edge_node(1, e), end_values(computed, e));
    set_end_values(result.densities, e, nearest);
    set_end_values(result.balanced, e, nearest);
  }
  if (motions.cols() > 0) restore_resultants(line, law, computed, motions, result);
  return result;
}

}  // namespace ffcontact
