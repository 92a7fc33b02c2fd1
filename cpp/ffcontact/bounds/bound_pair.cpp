// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/bound_pair.hpp"

#include <Eigen/LU>

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/estimate/error/contact_error.hpp"

namespace ffcontact {

namespace {

/// int X : C^-1 X on the cells, X at the corners of their subcells as `of` has it.
template <class OfCell>
VectorXd energies(const SolvedProblem<2>& solved, const OfCell& of) {
  const Mesh& mesh = solved.topology.mesh;
  VectorXd result(mesh.cell_count());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t)
    result[t] = energy<2>(corners_of(mesh, t),
                          Matrix3d(solved.body.hooke[t].inverse()), of(t));
  return result;
}

/// C eps(v) with the initial stresses.
class StressOf {
 public:
  StressOf(const SolvedProblem<2>& solved, const VectorXd& v)
      : stress_(total_stresses(solved.topology.mesh, solved.body, v)) {}
  SubcellStress<2> operator()(int t) const {
    return subcell_values<2>(stress_.at_vertices(t));
  }

 private:
  LinearStresses<2> stress_;
};

/// 2 Psi on the contact edges.
VectorXd twice_psi(const SolvedProblem<2>& solved, const VectorXd& v,
                   const ContactDensities& rho) {
  return contact_error(solved.contact, solved.body.law, rho, v);
}

}  // namespace

double energy_of(const SolvedProblem<2>& solved, const VectorXd& v) {
  return energies(solved, StressOf(solved, v)).sum();
}

double excess(const SolvedProblem<2>& solved, const BoundPair& pair, double s) {
  const StressOf sigma(solved, pair.v);
  const VectorXd squares = energies(solved, [&](int t) -> SubcellStress<2> {
    return pair.tau[t] - sigma(t);
  });
  return squares.sum() / (4 * s) +
         twice_psi(solved, pair.v, pair.rho).sum() / (2 * s);
}

VectorXd width_of_cells(const SolvedProblem<2>& solved, const BoundPair& plus,
                        const BoundPair& minus, double s) {
  const StressOf above(solved, plus.v), below(solved, minus.v);
  VectorXd local =
      energies(solved,
               [&](int t) -> SubcellStress<2> {
                 return plus.tau[t] + minus.tau[t] - above(t) - below(t);
               }) /
          (8 * s) +
      energies(solved, [&](int t) -> SubcellStress<2> {
        return plus.tau[t] - minus.tau[t] + above(t) - below(t);
      }) / (8 * s);
  VectorXd on_edges = VectorXd::Zero(solved.contact.edge_count());
  for (const BoundPair* of_v : {&plus, &minus})
    for (const BoundPair* of_rho : {&plus, &minus})
      on_edges += twice_psi(solved, of_v->v, of_rho->rho) / (4 * s);
  add_to_cells(solved.topology.facets, solved.contact, on_edges, local);
  return local;
}

}  // namespace ffcontact
