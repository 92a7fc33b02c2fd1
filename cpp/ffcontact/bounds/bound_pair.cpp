// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/bound_pair.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/estimate/contact_steps.hpp"
#include "ffcontact/estimate/error/spring_parts.hpp"

namespace ffcontact {

namespace {

/// int X : C^-1 X on the cells, X at the corners of their subcells as `of` has it.
template <int d, class OfCell>
VectorXd energies(const MatchedBodies<d>& bodies, const OfCell& of) {
  const SimplexMesh<d>& mesh = bodies.topology().mesh;
  VectorXd result(mesh.cell_count());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t)
    result[t] =
        energy<d>(corners_of(mesh, t),
                  VoigtMatrix<d>(bodies.body().hooke[t].inverse()), of(t));
  return result;
}

/// At the corners of the subcells.
template <int d>
SubcellStress<d> in_cell(const LinearStresses<d>& stress, int t) {
  return subcell_values<d>(stress.at_vertices(t));
}

/// |tau - C eps(v)|^2 of each cell.
template <int d>
VectorXd differences(const MatchedBodies<d>& bodies, const BoundPair<d>& pair) {
  const LinearStresses<d> sigma =
      total_stresses(bodies.topology().mesh, bodies.body(), pair.v);
  return energies(bodies, [&](int t) -> SubcellStress<d> {
    return pair.tau[t] - in_cell(sigma, t);
  });
}

/// Of a norm to which another one adds.
VectorXd squares_with(double oscillation, const VectorXd& squares) {
  const double norm = std::sqrt(squares.sum());
  if (norm == 0)
    return VectorXd::Constant(squares.size(),
                              oscillation * oscillation / count_of(squares));
  return std::pow(1 + oscillation / norm, 2) * squares;
}

/// What it adds.
template <int d>
VectorXd oscillation_part(const MatchedBodies<d>& bodies,
                          const BoundPair<d>& pair) {
  if (pair.oscillation == 0)
    return VectorXd::Zero(bodies.topology().mesh.cell_count());
  const VectorXd squares = differences(bodies, pair);
  return squares_with(pair.oscillation, squares) - squares;
}

/// |d+ + d-|^2 + |h+ - h-|^2 of each cell.
template <int d>
VectorXd stresses_apart(const MatchedBodies<d>& bodies,
                        const BoundPair<d>& plus, const BoundPair<d>& minus) {
  const SimplexMesh<d>& mesh = bodies.topology().mesh;
  const LinearStresses<d> above = total_stresses(mesh, bodies.body(), plus.v),
                          below = total_stresses(mesh, bodies.body(), minus.v);
  const auto with_sign = [&](double sign) {
    return energies(bodies, [&, sign](int t) -> SubcellStress<d> {
      return plus.tau[t] - in_cell(below, t) +
             sign * (minus.tau[t] - in_cell(above, t));
    });
  };
  return with_sign(1) + with_sign(-1);
}

/// u_0 = 0
template <int d>
BoundarySprings<d> at_rest(BoundarySprings<d> springs) {
  springs.rest.setZero();
  return springs;
}

/// A quarter of the same of springs, with d = t + K (v - u_0), h = t - K (v - u_0), of each
/// column of the boundary.
template <int d>
VectorXd springs_apart(const SimplexMesh<d>& mesh,
                       const BoundarySprings<d>& springs,
                       const BoundPair<d>& plus, const BoundPair<d>& minus) {
  return spring_norms<d>(mesh, springs, (plus.v + minus.v) / 2,
                         (plus.springs + minus.springs) / 2)
             .difference +
         spring_norms<d>(mesh, at_rest(springs), (plus.v - minus.v) / 2,
                         (minus.springs - plus.springs) / 2)
             .difference;
}

/// 2 Psi on the contact facets.
template <int d>
VectorXd twice_psi(const MatchedBodies<d>& bodies, const VectorXd& v,
                   const FacetDensities<d>& rho,
                   const CoulombTerms<d>* coulomb) {
  if (!coulomb) return twice_psi<d>(bodies, bodies.body().law, v, rho);
  return twice_psi<d>(bodies, coulomb->frictionless, v, rho) +
         coulomb->friction;
}

/// |h - h_hat|^2 of each cell.
template <int d>
VectorXd changes(const MatchedBodies<d>& bodies, const BoundPair<d>& pair,
                 const BoundPair<d>& known) {
  const LinearStresses<d> moved(
      stresses(bodies.topology().mesh, bodies.body().hooke, pair.v - known.v));
  return energies(bodies, [&](int t) -> SubcellStress<d> {
    return pair.tau[t] - known.tau[t] + in_cell(moved, t);
  });
}

/// The same of springs, of each column of the boundary.
template <int d>
VectorXd changes_of_springs(const MatchedBodies<d>& bodies,
                            const BoundPair<d>& pair,
                            const BoundPair<d>& known) {
  return spring_norms<d>(bodies.topology().mesh, at_rest(bodies.body().springs),
                         known.v - pair.v, pair.springs - known.springs)
      .difference;
}

/// |d_hat|^2 + |h - h_hat|^2 / (1 - m) of each cell.
template <int d>
VectorXd distances(const MatchedBodies<d>& bodies, const BoundPair<d>& pair,
                   const CoulombTerms<d>& coulomb) {
  const double weight = 1 / (1 - coulomb.share);
  VectorXd local =
      coulomb.error + weight * changes(bodies, pair, coulomb.known);
  add_spring_parts<d>(bodies.topology().facets,
                      weight * changes_of_springs(bodies, pair, coulomb.known),
                      local);
  return local;
}

template <int d>
double sum_of_distances(const MatchedBodies<d>& bodies,
                        const BoundPair<d>& pair,
                        const CoulombTerms<d>* coulomb) {
  if (!coulomb) return 0;
  return coulomb->share * distances(bodies, pair, *coulomb).sum();
}

/// Without what is below 0, and the same sum.
VectorXd positive_shares(const VectorXd& local) {
  const VectorXd positive = local.cwiseMax(0);
  return positive.isZero(0) ? local : local.sum() / positive.sum() * positive;
}

}  // namespace

template <int d>
BoundPair<d> pair_of(const MatchedBodies<d>& bodies, const SolvedBody<d>& body,
                     const Estimate<d>& estimate) {
  std::vector<SubcellStress<d>> tau;
  for (int t = 0; t < bodies.topology().mesh.cell_count(); ++t)
    tau.push_back(stress_of(bodies.topology(), estimate, body, t));
  return {estimate.displacement,
          std::move(tau),
          facet_densities(estimate),
          std::max(estimate.equilibrium.largest(), estimate.cone),
          estimate.spring_tractions,
          estimate.oscillation};
}

template <int d>
double energy_of(const MatchedBodies<d>& bodies, const VectorXd& v) {
  const LinearStresses<d> sigma =
      total_stresses(bodies.topology().mesh, bodies.body(), v);
  return energies(bodies, [&](int t) { return in_cell(sigma, t); }).sum();
}

template <int d>
VectorXd error_of(const MatchedBodies<d>& bodies, const BoundPair<d>& pair) {
  const auto& [mesh, facets, ridges, stars] = bodies.topology();
  VectorXd local = differences(bodies, pair);
  add_spring_parts<d>(
      facets,
      spring_norms<d>(mesh, bodies.body().springs, pair.v, pair.springs)
          .difference,
      local);
  return local;
}

template <int d>
double excess(const MatchedBodies<d>& bodies, const BoundPair<d>& pair,
              double s, const CoulombTerms<d>* coulomb) {
  const SpringNorms springs = spring_norms<d>(
      bodies.topology().mesh, bodies.body().springs, pair.v, pair.springs);
  const double elastic =
      squares_with(pair.oscillation, differences(bodies, pair)).sum();
  return (elastic + springs.difference.sum() +
          sum_of_distances(bodies, pair, coulomb)) /
             (4 * s) +
         twice_psi<d>(bodies, pair.v, pair.rho, coulomb).sum() / (2 * s);
}

template <int d>
VectorXd width_of_cells(const MatchedBodies<d>& bodies,
                        const BoundPair<d>& plus, const BoundPair<d>& minus,
                        double s, const CoulombTerms<d>* coulomb) {
  VectorXd local = stresses_apart(bodies, plus, minus) / (8 * s);
  for (const BoundPair<d>* pair : {&plus, &minus}) {
    local += oscillation_part(bodies, *pair) / (4 * s);
    if (coulomb)
      local += coulomb->share / (4 * s) * distances(bodies, *pair, *coulomb);
  }
  const auto& [mesh, facets, ridges, stars] = bodies.topology();
  add_spring_parts<d>(
      facets, springs_apart(mesh, bodies.body().springs, plus, minus) / (2 * s),
      local);
  for (const BoundPair<d>* of_v : {&plus, &minus})
    for (const BoundPair<d>* of_rho : {&plus, &minus}) {
      const VectorXd part = twice_psi<d>(bodies, of_v->v, of_rho->rho, coulomb);
      add_contact_part<d>(bodies, part / (4 * s), local);
    }
  return coulomb ? positive_shares(local) : local;
}

template BoundPair<FFCONTACT_DIMENSION> pair_of(
    const MatchedBodies<FFCONTACT_DIMENSION>&,
    const SolvedBody<FFCONTACT_DIMENSION>&,
    const Estimate<FFCONTACT_DIMENSION>&);
template double energy_of(const MatchedBodies<FFCONTACT_DIMENSION>&,
                          const VectorXd&);
template VectorXd error_of(const MatchedBodies<FFCONTACT_DIMENSION>&,
                           const BoundPair<FFCONTACT_DIMENSION>&);
template double excess(const MatchedBodies<FFCONTACT_DIMENSION>&,
                       const BoundPair<FFCONTACT_DIMENSION>&, double,
                       const CoulombTerms<FFCONTACT_DIMENSION>*);
template VectorXd width_of_cells(const MatchedBodies<FFCONTACT_DIMENSION>&,
                                 const BoundPair<FFCONTACT_DIMENSION>&,
                                 const BoundPair<FFCONTACT_DIMENSION>&, double,
                                 const CoulombTerms<FFCONTACT_DIMENSION>*);

}  // namespace ffcontact
