// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/admissible_tractions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ffcontact/estimate/nearest_in_cone.hpp"

namespace ffcontact {

namespace {

/// Sine of the angle below which a contact tangent is that of its edge.
constexpr double parallel = 1e-13;

/// Resultants are the same to this part of the largest density on the whole line; motions
/// are of size 1.
constexpr double rounding = 1e-12;

/// int r phi at the two ends of an edge, Cartesian, one column each: l (2 r_i + r_j) / 6
/// at i.
Matrix2d end_moments(const ContactLine& line, const ContactDensities& densities, int e) {
  Matrix2d frame;
  frame << line.edge_normal(e), line.edge_tangent(e);
  const Matrix2d r = frame * end_values(densities, e).reshaped(2, 2);
  return line.length[e] / 6 * (r + r.rowwise().sum().replicate<1, 2>());
}

/// Whether the contact tangent is not that of the edge or of the edge that it faces, as
/// on a line of given directions.
bool skew(const Mesh& mesh, const ContactLine& line, int e) {
  const int i = line.edge_node(0, e), j = line.edge_node(1, e);
  const Vector2d side =
      mesh.vertices.col(line.vertex[j]) - mesh.vertices.col(line.vertex[i]);
  const auto off_tangent = [&](const Vector2d& along) {
    return std::abs(line.edge_normal(e).dot(along)) > parallel * line.length[e];
  };
  if (off_tangent(side)) return true;
  Vector2d facing = Vector2d::Zero();
  visit_opposite(line, j, [&](int vertex, double weight) {
    facing += weight * mesh.vertices.col(vertex);
  });
  visit_opposite(line, i, [&](int vertex, double weight) {
    facing -= weight * mesh.vertices.col(vertex);
  });
  return off_tangent(facing);
}

bool has_resultants(const ContactLine& line, const ContactDensities& densities,
                    const MatrixXd& motions, const VectorXd& resultants) {
  if (motions.cols() == 0) return true;
  const double largest = std::max(densities.normal.cwiseAbs().maxCoeff(),
                                  densities.tangential.cwiseAbs().maxCoeff());
  return (resultants_of(line, densities, motions) - resultants).cwiseAbs().maxCoeff() <=
         rounding * line.length.sum() * largest;
}

}  // namespace

ConeCorrection correct_edges_to_cone(const Mesh& mesh, const ContactLine& line,
                                     const ContactLaw& law,
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

VectorXd nodal_forces(const Mesh& mesh, const ContactLine& line,
                      const ContactDensities& densities) {
  VectorXd forces = VectorXd::Zero(2 * mesh.vertices.cols());
  for (int e = 0; e < line.edge_count(); ++e) {
    const Matrix2d moments = end_moments(line, densities, e);
    for (int end = 0; end < 2; ++end) {
      const int node = line.edge_node(end, e);
      forces.segment<2>(2 * line.vertex[node]) += moments.col(end);
      visit_opposite(line, node, [&](int vertex, double weight) {
        forces.segment<2>(2 * vertex) -= weight * moments.col(end);
      });
    }
  }
  return forces;
}

std::optional<AdmissibleTractions> admissible_tractions(
    const Mesh& mesh, const ContactLine& line, const ContactLaw& law,
    const ContactDensities& computed, const Matrix2Xd& pressure, const MatrixXd& motions,
    const VectorXd& resultants) {
  const ConeCorrection correction = correct_edges_to_cone(mesh, line, law, computed);
  const bool corrected = correction.uncorrected.empty();
  if (corrected && has_resultants(line, computed, motions, resultants))
    return AdmissibleTractions{correction.densities, computed, correction.shift, {}};
  const ContactDensities near =
      corrected ? correction.densities : edge_densities(line, pressure);
  const auto r = nearest_in_cone(line, law, near, motions, resultants);
  if (!r) return std::nullopt;
  AdmissibleTractions result{*r, *r, VectorXd::Zero(line.edge_count()),
                             std::vector<int>(line.edge_count())};
  std::iota(result.mended.begin(), result.mended.end(), 0);
  return result;
}

}  // namespace ffcontact
