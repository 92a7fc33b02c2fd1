// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/estimate.hpp"

#include <Eigen/LU>
#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/equilibrium/edge_moments.hpp"
#include "ffcontact/estimate/rebalancing_displacement.hpp"

namespace ffcontact {

namespace {

constexpr double equilibrium_tolerance = 1e-10;
constexpr double cone_tolerance = 1e-12;

void require_valid(const Mesh& mesh, const ContactLine& line, const ElasticSystem& system, const SolvedBody& body,
                   const EstimateSettings& settings) {
  require_elliptic(body.hooke, mesh.triangle_count());
  require_size("A", system.dof_count(), 2 * mesh.vertices.cols());
  require_size("u", body.displacement.size(), 2 * mesh.vertices.cols());
  require_finite("u", body.displacement);
  require_size("contact pressures", body.pressure.cols(), line.node_count());
  require_finite("contact pressure", body.pressure.reshaped());
  require_size("body loads", body.body_loads.cols(), mesh.triangle_count());
  require_finite("body load", body.body_loads.reshaped());
  require_valid(body.law, line);
  const RelaxationSettings& relaxation = settings.relaxation;
  if (relaxation.sweeps < 0) refuse("sweeps must not be negative, got ", relaxation.sweeps);
  if (!(relaxation.tightness >= 0 && relaxation.tightness < 1))
    refuse("tightness must be in [0, 1), got ", relaxation.tightness);
}

/// Contact tractions r_hat, those to build nodal equilibrium with, and the stresses that are in equilibrium with them.
struct Start {
  ContactDensities densities, balanced;
  Eigen::Matrix3Xd stress;
};

Start start_published(const Mesh& mesh, const ContactLine& line, const SolvedBody& body, Estimate& estimate) {
  const ContactDensities computed = edge_densities(line, body.pressure);
  const ConeCorrection correction = correct_to_cone(line, body.law, computed);
  estimate.shift = correction.shift;
  estimate.unmended = correction.uncorrected;
  return {correction.densities, computed, stresses(mesh, body.hooke, body.displacement)};
}

Start start_in_cone(const Mesh& mesh, const ContactLine& line, const ElasticSystem& system, const SolvedBody& body,
                    Estimate& estimate) {
  const ContactDensities computed = edge_densities(line, body.pressure);
  const Eigen::MatrixXd motions = free_rigid_motions(mesh, system.prescribed);
  const AdmissibleTractions tractions = admissible_tractions(line, body.law, computed, motions);
  estimate.shift = tractions.shift;
  estimate.mended = tractions.mended;
  if (!tractions.resultants_kept)
    refuse(
        "no tractions in the cone have the resultants of the computed contact forces: the body stands on a single "
        "point");
  Eigen::VectorXd u = body.displacement;
  if (!tractions.mended.empty())
    u += rebalancing_displacement(
        system, line, nodal_forces(mesh, line, tractions.balanced) - nodal_forces(mesh, line, computed), motions);
  return {tractions.densities, tractions.balanced, stresses(mesh, body.hooke, u)};
}

/// Squares of |sigma_hat - C eps(u_hat)| per triangle and of |sigma_hat + C eps(u_hat)| in all; fills sigma_hat.
struct Norms {
  Eigen::VectorXd difference;
  double sum = 0;
};

Norms measure(const Mesh& mesh, const Hooke& hooke, const Eigen::Matrix3Xd& stress, const EdgeLoadsOfAll& difference,
              const BodyLoadsOfAll& body_loads, std::vector<CompositeStress>& admissible_stress) {
  Norms norms;
  norms.difference.resize(mesh.triangles.cols());
  Eigen::VectorXd sum(mesh.triangles.cols());
  admissible_stress.resize(mesh.triangle_count());
#pragma omp parallel for
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const TriangleCorners corners = corners_of(mesh, t);
    const Eigen::Matrix3d compliance = hooke[t].inverse();
    const CompositeStress tau = composite_stress(corners, difference.col(t), body_loads.col(t));
    const CompositeStress sigma = stress.col(t).replicate<1, 9>();
    norms.difference[t] = energy(corners, compliance, tau);
    sum[t] = energy(corners, compliance, tau + 2 * sigma);
    admissible_stress[t] = sigma + tau;
  }
  norms.sum = sum.sum();
  return norms;
}

/// e after every sweep from the last square and what every sweep took off.
std::vector<double> error_history(double last_square, const std::vector<double>& falls) {
  std::vector<double> squares(falls.size() + 1, last_square);
  for (std::size_t k = falls.size(); k > 0; --k) squares[k - 1] = squares[k] + falls[k - 1];
  for (double& square : squares) square = std::sqrt(std::max(0.0, square));
  return squares;
}

/// Adds the contact part of each edge to its triangle, or half of it to each of the two that face each other there.
void share_contact_part(const Edges& edges, const ContactLine& line, const Eigen::VectorXd& contact_part,
                        Eigen::VectorXd& local) {
  for (int e = 0; e < line.edge_count(); ++e) {
    const int opposite = line.against_a_body() ? line.opposite_edge[e] : -1;
    local[edges.triangles(0, line.edge[e])] += (opposite < 0 ? 1 : 0.5) * contact_part[e];
    if (opposite >= 0) local[edges.triangles(0, opposite)] += 0.5 * contact_part[e];
  }
}

/// Contact tractions beside the largest stress: makes what is relative to the former relative to the latter, where an open
/// contact line carries nothing but rounding.
double share_of_contact(const ContactDensities& densities, const Eigen::Matrix3Xd& stress) {
  const double contact = std::max(densities.normal.cwiseAbs().maxCoeff(), densities.tangential.cwiseAbs().maxCoeff());
  return contact > 0 ? contact / std::max(contact, stress.cwiseAbs().maxCoeff()) : 0;
}

void judge(Estimate& estimate) {
  const bool in_equilibrium = estimate.equilibrium.largest() <= equilibrium_tolerance;
  const bool in_cone = estimate.cone <= cone_tolerance;
  estimate.admissible = in_equilibrium && in_cone;
  if (!in_cone)
    estimate.reason = std::to_string(estimate.unmended.size()) +
                      " contact edges have tractions outside the friction cone that (4.1) cannot mend";
  else if (!in_equilibrium)
    estimate.reason = "the stress is not in equilibrium to 1e-10";
}

}  // namespace

Estimate estimate_error(const Mesh& mesh, const Edges& edges, const ContactLine& line, const ElasticSystem& system,
                        const SolvedBody& body, const EstimateSettings& settings) {
  require_valid(mesh, line, system, body, settings);
  Estimate estimate;
  const auto boundary_with = [&](const ContactDensities& densities) {
    return boundary_tractions(mesh, edges, system.prescribed, body.neumann, line, densities);
  };

  // 1. Admissible displacement [CHH01, 4.1].
  estimate.displacement = admissible_displacement(line, body.law, body.displacement, system.prescribed);
  const Eigen::Matrix3Xd stress = stresses(mesh, body.hooke, estimate.displacement);

  // 2. Contact tractions in the cone [CHH01, (4.1)] and stresses that balance them at every node.
  const Start start = settings.tractions == Tractions::published ? start_published(mesh, line, body, estimate)
                                                                 : start_in_cone(mesh, line, system, body, estimate);

  // 3. Edge tractions in equilibrium, before the shifts of (4.1); then the shifted ones: the change of an edge has neither
  //    resultant nor moment, so every triangle stays balanced.
  const Stars stars = stars_of(mesh, edges);
  EdgeMoments moments =
      equilibrated_moments(mesh, edges, stars, start.stress, body.body_loads, boundary_with(start.balanced));
  const BoundaryTractions boundary = boundary_with(start.densities);
  const std::vector<int> contact_edge = contact_edge_numbers(line, edges);
  for (int e = 0; e < edges.count(); ++e)
    if (contact_edge[e] >= 0) moments.col(e) = boundary.moments.col(e);

  // 4. Star relaxation of sigma_hat - C eps(u_hat), and of r_hat in the cone.
  EdgeLoadsOfAll difference = difference_loads(mesh, edges, moments, stress);
  const TractionCosts costs = traction_costs(line, body.law, estimate.displacement);
  FreeTractions tractions{start.densities, costs.normal, costs.tangential, contact_edge};
  FreeContact contact{line, body.law, tractions};
  const std::vector<double> falls =
      relax_stars(mesh, edges, stars, body.hooke, boundary, body.body_loads, settings.relaxation, difference,
                  settings.tractions == Tractions::free ? &contact : nullptr);
  estimate.tractions = tractions.densities;

  // 5. The error and its parts [CHH01, (2.11)-(2.13)].
  const Norms norms = measure(mesh, body.hooke, stress, difference, body.body_loads, estimate.stress);
  const Eigen::VectorXd contact_part = contact_error(line, body.law, estimate.tractions, estimate.displacement);
  estimate.elastic = std::sqrt(norms.difference.sum());
  estimate.contact = contact_part.sum();
  const double square = norms.difference.sum() + estimate.contact, scale = norms.sum > 0 ? norms.sum : 1;
  estimate.e = std::sqrt(std::max(0.0, square));
  estimate.relative = estimate.e / std::sqrt(scale);
  estimate.history = error_history(square, falls);
  estimate.local = norms.difference;
  share_contact_part(edges, line, contact_part, estimate.local);
  estimate.local = (estimate.local.cwiseMax(0.0) / scale).cwiseSqrt();

  // 6. What the theory promises, measured.
  estimate.equilibrium =
      equilibrium_defect(mesh, edges, estimate.stress, body.body_loads, boundary_with(estimate.tractions));
  estimate.cone = cone_defect(line, body.law, estimate.tractions) * share_of_contact(estimate.tractions, stress);
  judge(estimate);
  return estimate;
}

}  // namespace ffcontact
