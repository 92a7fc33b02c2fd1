// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/forces_of_matrix.hpp"

#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"

namespace ffcontact {

namespace {

/// Refuses a matrix that differs by something on one dof's diagonal.
template <int dim>
void require_no_penalty(const SimplexMesh<dim>& mesh,
                        const ElasticSystem& system, const StatedForces& forces,
                        Index dof) {
  const VectorXd more = row_beyond_law(system, forces, dof);
  const double added = more[dof];
  if (more.cwiseAbs().sum() <= (1 + 1e-3) * std::abs(added))
    refuse("A has ", added, " more on its diagonal at ",
           vertex_in_words(mesh, dof / dim),
           " than lambda and G (or hooke) give: a penalty in place of a "
           "prescribed displacement, or a spring at a point; prescribe with "
           "on() and tgv 1e30, -1 or -2, and spread springs over ",
           dim == 2 ? "an edge" : "a face");
}

/// The dof at which A is off the most, or -1.
Index worst_dof(const Comparison& comparison) {
  Index worst;
  return comparison.off.maxCoeff(&worst) <= stiffness_tolerance ? -1 : worst;
}

template <int dim>
void require_no_factor(const SimplexMesh<dim>& mesh,
                       const Comparison& comparison, Index dof) {
  if (comparison.is_multiple())
    refuse("lambda and G (or hooke) are not those of A: A is ",
           comparison.factor(), " times the stiffness of the law at ",
           vertex_in_words(mesh, dof / dim),
           "; give the constants of the script's varf");
}

template <int dim>
[[noreturn]] void refuse_row(const SimplexMesh<dim>& mesh,
                             const Comparison& comparison, Index dof) {
  refuse("A is not the stiffness of lambda and G (or hooke): its row of ",
         vertex_in_words(mesh, dof / dim), " is off by ", comparison.off[dof],
         " of its terms; give the law of the script's varf in every region, "
         "and A without springs that spring= does not name");
}

}  // namespace

template <int dim>
std::string vertex_in_words(const SimplexMesh<dim>& mesh, Index vertex) {
  const auto v = static_cast<int>(vertex);
  return "vertex " + std::to_string(v) + " " + in_words(mesh.place(v));
}

template <int dim>
void require_forces_of_matrix(
    const SimplexMesh<dim>& mesh, const ElasticSystem& system,
    const StatedForces& forces,
    const std::function<void(const Comparison&, Index)>& other) {
  const Comparison comparison(system.stiffness, forces, system.prescribed);
  const Index worst = worst_dof(comparison);
  if (worst < 0) return;
  require_no_penalty(mesh, system, forces, worst);
  require_no_factor(mesh, comparison, worst);
  other(comparison, worst);
  refuse_row(mesh, comparison, worst);
}

template std::string vertex_in_words(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                     Index);
template void require_forces_of_matrix(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const ElasticSystem&,
    const StatedForces&, const std::function<void(const Comparison&, Index)>&);

}  // namespace ffcontact
