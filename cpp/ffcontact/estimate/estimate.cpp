// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/estimate.hpp"

#include <Eigen/LU>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/equilibrium/edge_moments.hpp"
#include "ffcontact/equilibrium/polynomial_stress.hpp"
#include "ffcontact/equilibrium/refined_moments.hpp"
#include "ffcontact/estimate/data_defect.hpp"
#include "ffcontact/estimate/local_mending.hpp"
#include "ffcontact/estimate/rebalancing_displacement.hpp"
#include "ffcontact/estimate/refined_body.hpp"

namespace ffcontact {

namespace {

constexpr double equilibrium_tolerance = 1e-10;
constexpr double cone_tolerance = 1e-12;
constexpr double penetration_tolerance = 1e-12;

/// A body without loads whose stresses are below this part of their terms C du/dx has
/// none: they are the rounding of u.
constexpr double rounding = 1e-12;

/// Equilibrium is judged against sigma_hat and the stresses of u_hat, and against this
/// part of the terms that these are summed from.
constexpr double least_part = 1e-4;

void require_valid(const Mesh& mesh, const ContactLine& line, const ElasticSystem& system,
                   const SolvedBody& body, const EstimateSettings& settings) {
  require_elliptic(body.hooke, mesh.cell_count());
  require_size("A", system.dof_count(), 2 * mesh.vertices.cols());
  require_size("u", body.displacement.size(), 2 * mesh.vertices.cols());
  require_finite("u", body.displacement);
  require_size("contact pressures", body.pressure.cols(), line.node_count());
  require_finite("contact pressure", body.pressure.reshaped());
  require_size("body loads", body.body_loads.cols(), mesh.cell_count());
  require_finite("body load", body.body_loads.reshaped());
  require_valid(body.law, line);
  const RelaxationSettings& relaxation = settings.relaxation;
  if (relaxation.sweeps < 0)
    refuse("sweeps must not be negative, got ", relaxation.sweeps);
  if (!(relaxation.tightness >= 0 && relaxation.tightness < 1))
    refuse("tightness must be in [0, 1), got ", relaxation.tightness);
}

/// The computed solution and, where facing traces do not match, their common refinement.
struct Origin {
  const Mesh& mesh;
  const Edges& edges;
  const ContactLine& line;
  const ElasticSystem& system;
  const SolvedBody& body;
  const CommonRefinement* refinement;  ///< null where traces match
  double stress_terms;                 ///< largest sum of the terms of a stress [MPa]
  /// rigid motions without loads and slip: stresses and tractions are rounding
  bool unstressed;
};

/// Largest displacement, gap or displacement of the load step before [mm].
double largest_displacement(const SolvedBody& body) {
  double largest = body.displacement.cwiseAbs().maxCoeff();
  for (const VectorXd* values : {&body.law.gap, &body.law.previous})
    if (values->size() > 0) largest = std::max(largest, values->cwiseAbs().maxCoeff());
  return largest;
}

/// Largest |C| |grad phi_k| |u_k|, summed over the vertices of a triangle, or what the
/// gap and the displacement of the load step before come to as strains along the line
/// [MPa].
double largest_terms(const Mesh& mesh, const Edges& edges, const ContactLine& line,
                     const SolvedBody& body, const VectorXd& displacement) {
  const Hooke& hooke = body.hooke;
  double given = 0, largest = 0;
  for (const VectorXd* values : {&body.law.gap, &body.law.previous})
    if (values->size() > 0) given = std::max(given, values->cwiseAbs().maxCoeff());
  for (int e = 0; e < line.edge_count(); ++e)
    largest =
        std::max(largest, hooke[edges.cells(0, line.edge[e])].cwiseAbs().maxCoeff() *
                              given / line.length[e]);
#pragma omp parallel for reduction(max : largest)
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Matrix<double, 2, 3> gradients = hat_gradients(mesh, t);
    double strain = 0;
    for (int k = 0; k < 3; ++k)
      strain +=
          gradients.col(k).norm() * displacement.segment<2>(2 * mesh.cells(k, t)).norm();
    largest = std::max(largest, hooke[t].cwiseAbs().maxCoeff() * strain);
  }
  return largest;
}

/// Does a node slide against Tresca's friction? Then stresses are not rounding, however
/// small.
bool slides(const ContactLine& line, const SolvedBody& body) {
  if (!body.law.tresca()) return false;
  const Matrix2Xd w = displacement_against_foundation(line, body.law, body.displacement);
  return (w.row(1).transpose().cwiseProduct(body.law.slip_bound).array().abs() >
          rounding * largest_displacement(body) * body.law.slip_bound.array())
      .any();
}

bool is_unstressed(const Mesh& mesh, const Edges& edges, const ContactLine& line,
                   const std::vector<char>& prescribed, const SolvedBody& body,
                   double stress_terms) {
  const BoundaryTractions given =
      boundary_tractions(mesh, edges, prescribed, body.neumann, ContactLine{}, {});
  // loads on supports are felt by nothing
  if (!given.moments.isZero(0) || !body.body_loads.isZero(0)) return false;
  const double stress =
      stresses(mesh, body.hooke, body.displacement).cwiseAbs().maxCoeff();
  return std::max(stress, body.pressure.cwiseAbs().maxCoeff()) <=
             rounding * stress_terms &&
         !slides(line, body);
}

double largest_value(const std::vector<CompositeStress>& stress) {
  double largest = 0;
  for (const CompositeStress& values : stress)
    largest = std::max(largest, values.cwiseAbs().maxCoeff());
  return largest;
}

/// What admissible fields are built on: the same bodies, with matching traces.
struct Setting {
  const Mesh& mesh;
  const Edges& edges;
  const ContactLine& line;
  const std::vector<char>& prescribed;
  const SolvedBody& body;

  BoundaryTractions boundary_with(const ContactDensities& densities) const {
    return boundary_tractions(mesh, edges, prescribed, body.neumann, line, densities);
  }
};

/// Contact tractions r_hat, those to build nodal equilibrium with, and the stresses that
/// are in equilibrium with them.
struct Start {
  ContactDensities densities, balanced;
  Matrix3Xd stress;  ///< on the triangles of the origin
};

Matrix3Xd computed_stresses(const Origin& origin) {
  if (origin.unstressed) return Matrix3Xd::Zero(3, origin.mesh.cells.cols());
  return stresses(origin.mesh, origin.body.hooke, origin.body.displacement);
}

/// What sigma_hat and r_hat are compared with: u_hat, or, where u has no stress and
/// slides nowhere, what u_hat differs by from it.
struct Compared {
  VectorXd displacement;
  ContactLaw law;
  Matrix3Xd stress;
};

Compared compared(const Origin& origin, const Setting& setting, const VectorXd& u_hat) {
  const auto& [mesh, edges, line, prescribed, body] = setting;
  if (!origin.unstressed) return {u_hat, body.law, stresses(mesh, body.hooke, u_hat)};
  Compared change{u_hat - body.displacement, body.law, {}};
  change.law.gap.resize(0);
  change.law.previous.resize(0);
  change.stress = stresses(mesh, body.hooke, change.displacement);
  if (change.stress.cwiseAbs().maxCoeff() <= rounding * origin.stress_terms) {
    change.displacement.setZero();
    change.stress.setZero();
  }
  return change;
}

/// p at the nodes of the setting.
Matrix2Xd nodal_pressures(const Origin& origin) {
  const Matrix2Xd p = lumped_pressures(origin.line, origin.system.prescribed,
                                       forces_of(origin.line, origin.body.pressure));
  if (!origin.refinement) return p;
  return (origin.refinement->node_weights * p.transpose()).transpose();
}

/// The node on which most of the contact force stands.
[[noreturn]] void refuse_unheld(const Origin& origin) {
  Index node;
  forces_of(origin.line, origin.body.pressure).colwise().norm().maxCoeff(&node);
  const int v = origin.line.vertex[node];
  const Vector2d x = origin.mesh.origin + origin.mesh.vertices.col(v);
  refuse(
      "no tractions in the cone have the resultant and the moment of the contact forces, "
      "most of which act at vertex ",
      v, " (", x.x(), ", ", x.y(),
      "), as where a body stands on one end of its line; hold it otherwise, or let the "
      "line go on there");
}

/// Stresses that balance a small change of the nodal forces: of a displacement that is
/// small, so that its own rounding is nothing.
Matrix3Xd balancing_stresses(const Origin& origin, const VectorXd& force_change) {
  const auto& [mesh, edges, line, system, body, refinement, stress_terms, unstressed] =
      origin;
  const MatrixXd motions = free_rigid_motions(mesh, system.prescribed);
  const VectorXd u =
      body.stiffness
          ? rebalancing_displacement(*body.stiffness, system, line, force_change, motions)
          : rebalancing_displacement(system, line, force_change, motions);
  return stresses(mesh, body.hooke, u);
}

Start start_published(const Origin& origin, const Setting& setting, Estimate& estimate) {
  const ContactDensities computed = edge_densities(setting.line, setting.body.pressure);
  const ConeCorrection correction =
      correct_edges_to_cone(setting.mesh, setting.line, setting.body.law, computed);
  estimate.shift = correction.shift;
  estimate.unmended = correction.uncorrected;
  return {correction.densities, computed, computed_stresses(origin)};
}

MatrixXd refined_motions(const Origin& origin, const MatrixXd& motions) {
  MatrixXd refined(
      origin.refinement ? 2 * origin.refinement->mesh.vertices.cols() : motions.rows(),
      motions.cols());
  for (Index k = 0; k < motions.cols(); ++k)
    refined.col(k) = origin.refinement ? refined_field(*origin.refinement, motions.col(k))
                                       : VectorXd(motions.col(k));
  return refined;
}

Start start_in_cone(const Origin& origin, const Setting& setting, const Stars& stars,
                    Estimate& estimate) {
  const auto& [mesh, edges, line, prescribed, body] = setting;
  const ContactDensities computed = edge_densities(line, body.pressure);
  Start start{{}, {}, computed_stresses(origin)};
  const auto mending =
      line.against_a_body() ? std::nullopt : mend_locally(mesh, line, body.law, computed);
  if (mending) {
    estimate.shift = mending->tractions.shift;
    estimate.mended = mending->tractions.mended;
    start.densities = mending->tractions.densities;
    start.balanced = mending->tractions.balanced;
    add_balancing_stresses(mesh, stars, body.hooke, line, computed, *mending,
                           start.stress);
    return start;
  }
  // Rigid motions as the loads know them: on the old mesh, whose facing edges need not be
  // of one length.
  const MatrixXd motions = free_rigid_motions(origin.mesh, origin.system.prescribed);
  const VectorXd forces = nodal_forces(origin.mesh, origin.line,
                                       edge_densities(origin.line, origin.body.pressure));
  const auto admissible = admissible_tractions(
      mesh, line, body.law, computed, nodal_pressures(origin),
      refined_motions(origin, motions), motions.transpose() * forces);
  if (!admissible) refuse_unheld(origin);
  const AdmissibleTractions& tractions = *admissible;
  estimate.shift = tractions.shift;
  estimate.mended = tractions.mended;
  start.densities = tractions.densities;
  start.balanced = tractions.balanced;
  const VectorXd balanced = nodal_forces(mesh, line, tractions.balanced);
  const VectorXd change =
      (origin.refinement ? unrefined_forces(*origin.refinement, balanced) : balanced) -
      forces;
  if (change.cwiseAbs().maxCoeff() <= rounding * forces.cwiseAbs().maxCoeff())
    return start;
  start.stress += balancing_stresses(origin, change);
  return start;
}

double longest_edge(const Origin& origin) {
  double longest = 0;
  for (int e = 0; e < origin.edges.count(); ++e)
    longest = std::max(longest, edge_vector(origin.mesh, origin.edges, e).norm());
  return longest;
}

/// Edge tractions in equilibrium with the balanced contact tractions, on the mesh of the
/// origin.
EdgeMoments first_moments_of(const Origin& origin, const Stars& stars,
                             const BoundaryTractions& boundary, Matrix3Xd& stress) {
  const auto equilibrium = [&] {
    return nodal_equilibrium(origin.mesh, origin.edges, stars, stress,
                             origin.body.body_loads, boundary);
  };
  NodalEquilibrium first = equilibrium();
  try {
    require_balanced(origin.mesh, first,
                     least_part * origin.stress_terms * longest_edge(origin));
  } catch (const Imbalance& imbalance) {
    refuse(imbalance.what(), ", ",
           cause_of(imbalance, origin.mesh, origin.line, origin.system, origin.body));
  }
  if (first.missing.cwiseAbs().maxCoeff() <= rounding * first.scale)
    return std::move(first.moments);
  stress += balancing_stresses(origin, first.missing.reshaped());
  return equilibrium().moments;
}

/// The same on the mesh of the setting.
EdgeMoments first_moments(const Origin& origin, const Setting& setting,
                          const Stars& stars, Start& start) {
  const BoundaryTractions boundary = setting.boundary_with(start.balanced);
  if (!origin.refinement) return first_moments_of(origin, stars, boundary, start.stress);
  const ContactLine none;
  const BoundaryTractions uncut = tractions_of_parts(
      origin.edges, *origin.refinement, boundary,
      boundary_tractions(origin.mesh, origin.edges, origin.system.prescribed,
                         origin.body.neumann, none, ContactDensities{}));
  const EdgeMoments moments =
      first_moments_of(origin, stars_of(origin.mesh, origin.edges), uncut, start.stress);
  return refined_moments(origin.edges, *origin.refinement, moments, start.stress,
                         setting.body.body_loads, boundary);
}

/// Squares of |sigma_hat - C eps(u_hat)| per triangle and of |sigma_hat + C eps(u_hat)|
/// in all; fills sigma_hat.
struct Norms {
  VectorXd difference;
  double sum = 0;
};

Norms measure(const Mesh& mesh, const Hooke& hooke, const Matrix3Xd& stress,
              const EdgeLoadsOfAll& difference, const BodyLoadsOfAll& body_loads,
              std::vector<CompositeStress>& admissible_stress) {
  Norms norms;
  norms.difference.resize(mesh.cells.cols());
  VectorXd sum(mesh.cells.cols());
  admissible_stress.resize(mesh.cell_count());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const TriangleCorners corners = corners_of(mesh, t);
    const Matrix3d compliance = hooke[t].inverse();
    const CompositeStress tau =
        composite_stress(corners, difference.col(t), body_loads.col(t));
    const CompositeStress sigma = stress.col(t).replicate<1, 9>();
    norms.difference[t] = energy(corners, compliance, tau);
    sum[t] = energy(corners, compliance, tau + 2 * sigma);
    admissible_stress[t] = sigma + tau;
  }
  norms.sum = sum.sum();
  return norms;
}

/// The same for the polynomial construction; sigma_hat by its values at the corners of
/// the subtriangles.
Norms measure_polynomial(const Mesh& mesh, const Hooke& hooke, const Matrix3Xd& stress,
                         const EdgeLoadsOfAll& difference,
                         const BodyLoadsOfAll& body_loads,
                         std::vector<CompositeStress>& values) {
  Norms norms;
  norms.difference.resize(mesh.cells.cols());
  VectorXd sum(mesh.cells.cols());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const PolynomialStress tau = polynomial_stress(corners_of(mesh, t), hooke[t],
                                                   difference.col(t), body_loads.col(t));
    norms.difference[t] = energy(tau, Vector3d::Zero());
    sum[t] = energy(tau, 2 * stress.col(t));
    values[t] = corner_values(tau) + stress.col(t).replicate<1, 9>();
  }
  norms.sum = sum.sum();
  return norms;
}

/// e after every sweep from the last square and what every sweep took off.
std::vector<double> error_history(double last_square, const std::vector<double>& falls) {
  std::vector<double> squares(falls.size() + 1, last_square);
  for (std::size_t k = falls.size(); k > 0; --k)
    squares[k - 1] = squares[k] + falls[k - 1];
  for (double& square : squares) square = std::sqrt(std::max(0.0, square));
  return squares;
}

/// Adds the contact part of each edge to its triangle, or half of it to each of the two
/// that face each other there.
void share_contact_part(const Edges& edges, const ContactLine& line,
                        const VectorXd& contact_part, VectorXd& local) {
  for (int e = 0; e < line.edge_count(); ++e) {
    const int opposite = line.against_a_body() ? line.opposite_edge[e] : -1;
    local[edges.cells(0, line.edge[e])] += (opposite < 0 ? 1 : 0.5) * contact_part[e];
    if (opposite >= 0) local[edges.cells(0, opposite)] += 0.5 * contact_part[e];
  }
}

/// Sums over the parts of the computed solution's triangles.
VectorXd local_sums(const Origin& origin, const VectorXd& local) {
  if (!origin.refinement) return local;
  VectorXd sums = VectorXd::Zero(origin.mesh.cells.cols());
  for (Index t = 0; t < local.size(); ++t) sums[origin.refinement->parent[t]] += local[t];
  return sums;
}

/// Contact tractions beside the largest stress: makes what is relative to the former
/// relative to the latter, where an open contact line carries nothing but rounding.
double share_of_contact(const ContactDensities& densities, const Matrix3Xd& stress) {
  const double contact = std::max(densities.normal.cwiseAbs().maxCoeff(),
                                  densities.tangential.cwiseAbs().maxCoeff());
  return contact > 0 ? contact / std::max(contact, stress.cwiseAbs().maxCoeff()) : 0;
}

std::string in_digits(double value) {
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

void judge(Construction construction, const Mesh& mesh, const ContactLine& line,
           const PenetrationDefect& penetration, Estimate& estimate) {
  const bool in_equilibrium = estimate.equilibrium.largest() <= equilibrium_tolerance;
  const bool in_cone = estimate.cone <= cone_tolerance;
  const bool clear = estimate.penetration <= penetration_tolerance;
  estimate.admissible =
      in_equilibrium && in_cone && clear && construction == Construction::composite;
  const Vector2d x = mesh.origin + mesh.vertices.col(line.vertex[penetration.node]);
  if (!clear)
    estimate.reason = "u penetrates by " + in_digits(estimate.penetration) +
                      " of the largest displacement at (" + in_digits(x.x()) + ", " +
                      in_digits(x.y()) + "), where displacements are prescribed";
  else if (!in_cone)
    estimate.reason = "contact tractions leave the friction cone by " +
                      in_digits(estimate.cone) + " of the largest stress" +
                      (estimate.unmended.empty()
                           ? ""
                           : ": (4.1) cannot mend " +
                                 std::to_string(estimate.unmended.size()) + " edges");
  else if (construction == Construction::polynomial)
    estimate.reason =
        "the polynomial construction is in equilibrium in the mean only: its tractions "
        "jump by " +
        in_digits(estimate.equilibrium.jump) + " of the largest";
  else if (!in_equilibrium)
    estimate.reason = "the stress is out of equilibrium by " +
                      in_digits(estimate.equilibrium.largest()) +
                      " of the largest traction";
}

/// Relaxation leaves tractions outside of the cone by its rounding; inside they unbalance
/// the stresses by as little.
void clamp_rounding(const ContactLine& line, const ContactLaw& law,
                    ContactDensities& densities) {
  for (int e = 0; e < line.edge_count(); ++e)
    set_end_values(densities, e, clamped_to_cone(line, law, e, end_values(densities, e)));
}

/// Steps 1 to 6 of the estimate.
void put_estimate(const Origin& origin, const Setting& setting,
                  const EstimateSettings& settings, Estimate& estimate) {
  const auto& [mesh, edges, line, prescribed, body] = setting;

  // 1. Admissible displacement [CHH01, 4.1].
  estimate.displacement =
      admissible_displacement(line, body.law, body.displacement, prescribed);
  const auto [u_hat, law, stress] = compared(origin, setting, estimate.displacement);

  // 2. Contact tractions in the cone [CHH01, (4.1)] and stresses that balance them at
  //    every node.
  const Stars stars = stars_of(mesh, edges);
  Start start = settings.tractions == Tractions::published
                    ? start_published(origin, setting, estimate)
                    : start_in_cone(origin, setting, stars, estimate);

  // 3. Edge tractions in equilibrium, before the shifts of (4.1); then the shifted ones:
  //    the change of an edge has neither
  //    resultant nor moment, so every triangle stays balanced.
  EdgeMoments moments = first_moments(origin, setting, stars, start);
  const BoundaryTractions boundary = setting.boundary_with(start.densities);
  const std::vector<int> contact_edge = contact_edge_numbers(line, edges);
  for (int e = 0; e < edges.count(); ++e)
    if (contact_edge[e] >= 0) moments.col(e) = boundary.moments.col(e);

  // 4. Star relaxation of sigma_hat - C eps(u_hat), and of r_hat in the cone.
  EdgeLoadsOfAll difference = difference_loads(mesh, edges, moments, stress);
  const TractionCosts costs = traction_costs(line, law, start.densities, u_hat);
  FreeTractions tractions{start.densities, costs.normal, costs.tangential, contact_edge};
  FreeContact contact{line, body.law, tractions};
  const std::vector<double> falls = relax_stars(
      mesh, edges, stars, body.hooke, boundary, body.body_loads, settings.relaxation,
      difference,
      settings.tractions == Tractions::free && !origin.unstressed ? &contact : nullptr);
  estimate.tractions = tractions.densities;
  if (settings.tractions != Tractions::published)
    clamp_rounding(line, body.law, estimate.tractions);
  const BoundaryTractions relaxed = setting.boundary_with(estimate.tractions);

  // 5. The error and its parts [CHH01, (2.11)-(2.13)].
  Norms norms =
      measure(mesh, body.hooke, stress, difference, body.body_loads, estimate.stress);
  const VectorXd contact_part = contact_error(line, law, estimate.tractions, u_hat);
  estimate.history = error_history(norms.difference.sum() + contact_part.sum(), falls);
  if (settings.construction == Construction::polynomial)
    norms = measure_polynomial(mesh, body.hooke, stress, difference, body.body_loads,
                               estimate.stress);
  estimate.elastic = std::sqrt(norms.difference.sum());
  estimate.contact = contact_part.sum();
  const double square = norms.difference.sum() + estimate.contact,
               scale = norms.sum > 0 ? norms.sum : 1;
  estimate.e = std::sqrt(std::max(0.0, square));
  estimate.relative = estimate.e / std::sqrt(scale);
  VectorXd local = norms.difference;
  share_contact_part(edges, line, contact_part, local);
  estimate.local = (local_sums(origin, local) / scale).cwiseMax(0.0).cwiseSqrt();

  // to the last digit: above it is what u_hat - u leaves of its own stress
  if (origin.unstressed)
    for (CompositeStress& zero : estimate.stress) zero.setZero();

  // 6. What the theory promises, measured.
  const double least = std::max(
      {stress.cwiseAbs().maxCoeff(), largest_value(estimate.stress),
       least_part * largest_terms(mesh, edges, line, body, estimate.displacement)});
  estimate.equilibrium =
      equilibrium_defect(mesh, edges, estimate.stress, body.body_loads, relaxed, least);
  estimate.cone = cone_defect(line, body.law, estimate.tractions) *
                  share_of_contact(estimate.tractions, stress);
  const PenetrationDefect penetration =
      penetration_defect(line, body.law, estimate.displacement);
  estimate.penetration = penetration.value;
  judge(settings.construction, mesh, line, penetration, estimate);
}

}  // namespace

Estimate estimate_error(const Mesh& mesh, const Edges& edges, const ContactLine& line,
                        const ElasticSystem& system, const SolvedBody& body,
                        const EstimateSettings& settings) {
  require_valid(mesh, line, system, body, settings);
  require_law_of_matrix(mesh, system, body.hooke);
  Estimate estimate;
  const double stress_terms = largest_terms(mesh, edges, line, body, body.displacement);
  SolvedBody own;  // where the tractions of u are rounding
  const bool unstressed =
      is_unstressed(mesh, edges, line, system.prescribed, body, stress_terms);
  if (unstressed) {
    own = body;
    own.pressure.setZero();
  }
  const SolvedBody& solved = unstressed ? own : body;
  if (line.matches()) {
    put_estimate({mesh, edges, line, system, solved, nullptr, stress_terms, unstressed},
                 {mesh, edges, line, system.prescribed, solved}, settings, estimate);
    return estimate;
  }
  estimate.refinement = common_refinement(mesh, edges, line);
  const CommonRefinement& refinement = *estimate.refinement;
  const Origin origin{mesh,   edges,       line,         system,
                      solved, &refinement, stress_terms, unstressed};
  const std::vector<char> prescribed = refined_prescribed(refinement, system.prescribed);
  const SolvedBody cut = refined_body(mesh, edges, line, solved, refinement);
  put_estimate(origin,
               {refinement.mesh, refinement.edges, refinement.line, prescribed, cut},
               settings, estimate);
  return estimate;
}

}  // namespace ffcontact
