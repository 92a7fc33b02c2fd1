// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/bound_pair.hpp"

#include <Eigen/LU>

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"

namespace ffcontact {

namespace {

/// int X : C^-1 X on the cells, X at the corners of their subcells as `of` has it.
template <int d, class OfCell>
VectorXd energies(const SolvedProblem<d>& solved, const OfCell& of) {
  const SimplexMesh<d>& mesh = solved.topology.mesh;
  VectorXd result(mesh.cell_count());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t)
    result[t] =
        energy<d>(corners_of(mesh, t),
                  VoigtMatrix<d>(solved.body.hooke[t].inverse()), of(t));
  return result;
}

/// At the corners of the subcells.
template <int d>
SubcellStress<d> in_cell(const LinearStresses<d>& stress, int t) {
  return subcell_values<d>(stress.at_vertices(t));
}

}  // namespace

template <int d>
double energy_of(const SolvedProblem<d>& solved, const VectorXd& v) {
  const LinearStresses<d> sigma =
      total_stresses(solved.topology.mesh, solved.body, v);
  return energies(solved, [&](int t) { return in_cell(sigma, t); }).sum();
}

template <int d>
double excess(const SolvedProblem<d>& solved, const BoundPair<d>& pair,
              double s) {
  const LinearStresses<d> sigma =
      total_stresses(solved.topology.mesh, solved.body, pair.v);
  const VectorXd squares = energies(solved, [&](int t) -> SubcellStress<d> {
    return pair.tau[t] - in_cell(sigma, t);
  });
  return squares.sum() / (4 * s) +
         twice_psi<d>(solved, pair.v, pair.rho).sum() / (2 * s);
}

template <int d>
VectorXd width_of_cells(const SolvedProblem<d>& solved,
                        const BoundPair<d>& plus, const BoundPair<d>& minus,
                        double s) {
  const SimplexMesh<d>& mesh = solved.topology.mesh;
  const LinearStresses<d> above = total_stresses(mesh, solved.body, plus.v),
                          below = total_stresses(mesh, solved.body, minus.v);
  VectorXd local = energies(solved,
                            [&](int t) -> SubcellStress<d> {
                              return plus.tau[t] + minus.tau[t] -
                                     in_cell(above, t) - in_cell(below, t);
                            }) /
                       (8 * s) +
                   energies(solved, [&](int t) -> SubcellStress<d> {
                     return plus.tau[t] - minus.tau[t] + in_cell(above, t) -
                            in_cell(below, t);
                   }) / (8 * s);
  for (const BoundPair<d>* of_v : {&plus, &minus})
    for (const BoundPair<d>* of_rho : {&plus, &minus}) {
      const VectorXd part = twice_psi<d>(solved, of_v->v, of_rho->rho);
      add_to_cells<d>(solved, part / (4 * s), local);
    }
  return local;
}

template double energy_of(const SolvedProblem<FFCONTACT_DIMENSION>&,
                          const VectorXd&);
template double excess(const SolvedProblem<FFCONTACT_DIMENSION>&,
                       const BoundPair<FFCONTACT_DIMENSION>&, double);
template VectorXd width_of_cells(const SolvedProblem<FFCONTACT_DIMENSION>&,
                                 const BoundPair<FFCONTACT_DIMENSION>&,
                                 const BoundPair<FFCONTACT_DIMENSION>&, double);

}  // namespace ffcontact
