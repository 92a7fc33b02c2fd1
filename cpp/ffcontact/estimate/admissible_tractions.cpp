// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/admissible_tractions.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

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

void scale_edges(const Eigen::VectorXd& normal, const Eigen::VectorXd& tangential, ContactDensities& densities) {
  densities.normal *= normal.asDiagonal();
  densities.tangential *= tangential.asDiagonal();
}

/// Tresca's bound over |r_t| on each edge, at least 1: how far its tangential density can be multiplied.
Eigen::VectorXd tangential_reserves(const ContactLine& line, const ContactLaw& law, const ContactDensities& densities) {
  Eigen::VectorXd reserve = Eigen::VectorXd::Constant(line.edge_count(), std::numeric_limits<double>::infinity());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      const double r = std::abs(densities.tangential(end, e));
      if (r > 0) reserve[e] = std::min(reserve[e], std::max(1.0, law.slip_bound[line.edge_node(end, e)] / r));
    }
  return reserve.cwiseMin(1e3);
}

/// For Tresca's law: factors (s, t) of the normal and tangential densities nearest to 1, s >= 0 and |t| within the reserves,
/// that give the wanted resultants; empty when there are none [2 m].
Eigen::VectorXd restoring_factors_tresca(const Eigen::MatrixXd& normal, const Eigen::MatrixXd& tangential,
                                         const Eigen::VectorXd& reserve, const Eigen::VectorXd& wanted, double scale) {
  const Eigen::Index m = normal.cols(), k = wanted.size();
  Eigen::MatrixXd R(k, 2 * m), C = Eigen::MatrixXd::Zero(3 * m + 2 * k, 2 * m);
  R << normal / scale, tangential / scale;
  C.topRows(2 * m).setIdentity();
  C.block(2 * m, m, m, m) = -Eigen::MatrixXd::Identity(m, m);
  C.bottomRows(2 * k) << R, -R;
  Eigen::VectorXd d(C.rows());
  d << Eigen::VectorXd::Zero(m), -reserve, -reserve, wanted / scale, -wanted / scale;
  const auto factors =
      quadratic_minimum(Eigen::MatrixXd::Identity(2 * m, 2 * m), Eigen::VectorXd::Constant(2 * m, -1), C, d);
  if (!factors || (R * *factors - wanted / scale).cwiseAbs().maxCoeff() > resultant_tolerance) return {};
  Eigen::VectorXd inside = *factors;  // but for rounding
  inside.head(m) = inside.head(m).cwiseMax(0);
  inside.tail(m) = inside.tail(m).cwiseMin(reserve).cwiseMax(-reserve);
  return inside;
}

void restore_resultants(const ContactLine& line, const ContactLaw& law, const ContactDensities& computed,
                        const Eigen::MatrixXd& motions, AdmissibleTractions& result) {
  const Eigen::MatrixXd before = resultants(line, computed, motions);
  const Eigen::VectorXd wanted = before.rowwise().sum();
  const double scale = before.cwiseAbs().sum();
  Eigen::VectorXd normal, tangential;
  if (law.tresca()) {
    ContactDensities part = result.balanced;
    part.tangential.setZero();
    const Eigen::MatrixXd of_normal = resultants(line, part, motions);
    const Eigen::MatrixXd of_tangential = resultants(line, result.balanced, motions) - of_normal;
    const Eigen::VectorXd factors = restoring_factors_tresca(
        of_normal, of_tangential, tangential_reserves(line, law, result.densities), wanted, scale);
    normal = factors.head(factors.size() / 2);
    tangential = factors.tail(factors.size() / 2);
  } else {
    normal = tangential = restoring_factors(resultants(line, result.balanced, motions), wanted, scale);
  }
  result.resultants_kept = normal.size() > 0;
  if (!result.resultants_kept) return;
  scale_edges(normal, tangential, result.balanced);
  scale_edges(normal, tangential, result.densities);
  result.shift.array() *= tangential.array();
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
