// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/admissible_tractions.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "ffcontact/base/quadratic_minimum.hpp"

namespace ffcontact {

namespace {

/// Resultants are kept to this part of their scale.
constexpr double resultant_tolerance = 1e-12;

/// Sine of the angle below which a contact tangent is that of its edge.
constexpr double parallel = 1e-13;

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

/// Whether the contact tangent is not that of the edge or of the edge that it faces, as on a line of given directions.
bool skew(const Mesh& mesh, const ContactLine& line, int e) {
  const int i = line.edge_node(0, e), j = line.edge_node(1, e);
  const Eigen::Vector2d side = mesh.vertices.col(line.vertex[j]) - mesh.vertices.col(line.vertex[i]);
  const auto off_tangent = [&](const Eigen::Vector2d& along) {
    return std::abs(line.edge_normal(e).dot(along)) > parallel * line.length[e];
  };
  if (off_tangent(side)) return true;
  Eigen::Vector2d facing = Eigen::Vector2d::Zero();
  visit_opposite(line, j, [&](int vertex, double weight) { facing += weight * mesh.vertices.col(vertex); });
  visit_opposite(line, i, [&](int vertex, double weight) { facing -= weight * mesh.vertices.col(vertex); });
  return off_tangent(facing);
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
  // int |r - density|^2 over an edge of length 1; unknowns (r_n, r_t) at the first and at the second end.
  Eigen::Matrix4d mass = Eigen::Matrix4d::Identity() / 3;
  mass.topRightCorner<2, 2>() = mass.bottomLeftCorner<2, 2>() = Eigen::Matrix2d::Identity() / 6;
  Eigen::Matrix<double, 6, 4> C = Eigen::Matrix<double, 6, 4>::Zero();
  Eigen::Matrix<double, 6, 1> d = Eigen::Matrix<double, 6, 1>::Zero();
  const int nodes[2] = {first_node, second_node};
  for (int end = 0; end < 2; ++end) {
    const double slope = law.tresca() ? 0 : law.friction[nodes[end]];
    C.block<3, 2>(3 * end, 2 * end) << -1, 0, -slope, 1, -slope, -1;
    if (law.tresca()) d.segment<2>(3 * end + 1).setConstant(-law.slip_bound[nodes[end]]);
  }
  const Eigen::Vector4d wanted = density.reshaped();
  Eigen::Matrix2d nearest = quadratic_minimum(mass, -mass * wanted, C, d)->reshaped(2, 2);
  for (int end = 0; end < 2; ++end) {  // rounding
    nearest(0, end) = std::min(nearest(0, end), 0.0);
    const double bound = law.tresca() ? law.slip_bound[nodes[end]] : -law.friction[nodes[end]] * nearest(0, end);
    nearest(1, end) = std::clamp(nearest(1, end), -bound, bound);
  }
  return nearest;
}

ConeCorrection correct_edges_to_cone(const Mesh& mesh, const ContactLine& line, const ContactLaw& law,
                                     const ContactDensities& computed) {
  ConeCorrection correction = correct_to_cone(line, law, computed);
  for (int e = 0; e < line.edge_count(); ++e) {
    if (correction.shift[e] == 0 || !skew(mesh, line, e)) continue;
    set_end_values(correction.densities, e, end_values(computed, e));
    correction.shift[e] = 0;
    correction.uncorrected.push_back(e);
  }
  std::sort(correction.uncorrected.begin(), correction.uncorrected.end());
  return correction;
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

AdmissibleTractions admissible_tractions(const Mesh& mesh, const ContactLine& line, const ContactLaw& law,
                                         const ContactDensities& computed, const Eigen::MatrixXd& motions) {
  const ConeCorrection correction = correct_edges_to_cone(mesh, line, law, computed);
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
