// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/estimate.hpp"

#include <Eigen/LU>
#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/edge_moments.hpp"

namespace ffcontact {

namespace {

constexpr double equilibrium_tolerance = 1e-10;
constexpr double cone_tolerance = 1e-12;

void require_valid(const Mesh& mesh, const ContactLine& line, const SolvedBody& body, const EstimateSettings& settings) {
  require_elliptic(body.hooke, mesh.triangle_count());
  require_size("u", body.displacement.size(), 2 * mesh.vertices.cols());
  require_finite("u", body.displacement);
  require_size("contact pressures", body.pressure.cols(), line.node_count());
  require_finite("contact pressure", body.pressure.reshaped());
  require_size("body force", body.body_force.cols(), mesh.triangle_count());
  require_finite("body force", body.body_force.reshaped());
  require_valid(body.law, line);
  if (settings.sweeps < 0) refuse("sweeps must not be negative, got ", settings.sweeps);
}

CompositeStress constant_stress(const Eigen::Vector3d& value) { return value.replicate<1, 9>(); }

TriangleCorners corners_of(const Mesh& mesh, int t) {
  TriangleCorners corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = mesh.corner(t, k);
  return corners;
}

/// Squares of |sigma_hat - C eps(u_hat)| per triangle and of |sigma_hat + C eps(u_hat)| in all; fills sigma_hat.
struct Norms {
  Eigen::VectorXd difference;
  double sum = 0;
};

Norms measure(const Mesh& mesh, const Hooke& hooke, const Eigen::Matrix3Xd& stress, const LoadsPerTriangle& difference,
              std::vector<CompositeStress>& admissible_stress) {
  Norms norms;
  norms.difference.resize(mesh.triangles.cols());
  Eigen::VectorXd sum(mesh.triangles.cols());
  admissible_stress.resize(mesh.triangle_count());
#pragma omp parallel for
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const TriangleCorners corners = corners_of(mesh, t);
    const Eigen::Matrix3d compliance = hooke[t].inverse();
    const CompositeStress tau = composite_stress(corners, difference.col(t)), sigma = constant_stress(stress.col(t));
    norms.difference[t] = energy(corners, compliance, tau);
    sum[t] = energy(corners, compliance, tau + 2 * sigma);
    admissible_stress[t] = sigma + tau;
  }
  norms.sum = sum.sum();
  return norms;
}

void judge(Estimate& estimate) {
  const bool in_equilibrium = estimate.equilibrium.largest() <= equilibrium_tolerance;
  const bool in_cone = estimate.cone <= cone_tolerance;
  estimate.admissible = in_equilibrium && in_cone;
  if (!in_cone)
    estimate.reason = std::to_string(estimate.tractions.uncorrected.size()) +
                      " contact edges have tractions outside the friction cone that (4.1) cannot mend";
  else if (!in_equilibrium)
    estimate.reason = "the stress is not in equilibrium to 1e-10";
}

}  // namespace

Estimate estimate_error(const Mesh& mesh, const Edges& edges, const ContactLine& line, const SolvedBody& body,
                        const EstimateSettings& settings) {
  require_valid(mesh, line, body, settings);
  Estimate estimate;

  // 1. Admissible displacement [CHH01, 4.1].
  estimate.displacement = admissible_displacement(line, body.law, body.displacement);

  // 2. Contact tractions in the cone [CHH01, (4.1)].
  const ContactDensities computed = edge_densities(line, body.pressure);
  estimate.tractions = correct_to_cone(line, body.law, computed);
  estimate.cone = cone_defect(line, body.law, estimate.tractions.densities);

  // 3. Edge tractions in equilibrium, with lambda_h on the contact edges; then r_hat in its place: the change of an edge has
  //    neither resultant nor moment, so every triangle stays balanced.
  const Stars stars = stars_of(mesh, edges);
  const Eigen::Matrix3Xd stress_h = stresses(mesh, body.hooke, body.displacement);
  EdgeMoments moments = equilibrated_moments(
      mesh, edges, stars, stress_h, body.body_force,
      boundary_tractions(mesh, edges, body.prescribed, body.neumann, line, computed));
  const BoundaryTractions boundary =
      boundary_tractions(mesh, edges, body.prescribed, body.neumann, line, estimate.tractions.densities);
  for (int e = 0; e < line.edge_count(); ++e) moments.col(line.edge[e]) = boundary.moments.col(line.edge[e]);

  // 4. Star relaxation of sigma_hat - C eps(u_hat).
  const Eigen::Matrix3Xd stress = stresses(mesh, body.hooke, estimate.displacement);
  LoadsPerTriangle difference = difference_loads(mesh, edges, moments, body.body_force, stress);
  estimate.history = relax_stars(mesh, edges, stars, body.hooke, boundary, settings.sweeps, difference);

  // 5. The error and its parts [CHH01, (2.11)-(2.13)].
  const Norms norms = measure(mesh, body.hooke, stress, difference, estimate.stress);
  const Eigen::VectorXd contact = contact_error(line, body.law, estimate.tractions.densities, estimate.displacement);
  estimate.elastic = std::sqrt(norms.difference.sum());
  estimate.contact = contact.sum();
  estimate.e = std::sqrt(std::max(0.0, norms.difference.sum() + estimate.contact));
  estimate.relative = norms.sum > 0 ? estimate.e / std::sqrt(norms.sum) : 0;
  for (double& squared : estimate.history) squared = std::sqrt(std::max(0.0, squared + estimate.contact));
  estimate.local = norms.difference;
  for (int e = 0; e < line.edge_count(); ++e) estimate.local[edges.triangles(0, line.edge[e])] += contact[e];
  estimate.local = (estimate.local.cwiseMax(0.0) / (norms.sum > 0 ? norms.sum : 1)).cwiseSqrt();

  // 6. What the theory promises, measured.
  estimate.equilibrium = equilibrium_defect(mesh, edges, estimate.stress, body.body_force, boundary);
  judge(estimate);
  return estimate;
}

}  // namespace ffcontact
