// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/law_of_matrix.hpp"

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/estimate/checks/forces_of_matrix.hpp"

namespace ffcontact {

namespace {

/// Refuses a matrix that differs along the boundary alone, by what a spring would add.
void require_springs_of_matrix(const Mesh& mesh, const ElasticSystem& system,
                               const StatedForces& forces,
                               const Comparison& comparison, bool given,
                               Index dof) {
  Flags on_boundary(mesh.vertex_count(), 0);
  for (const int v : mesh.boundary.reshaped()) on_boundary[v] = 1;
  for (Index k = 0; k < comparison.off.size(); ++k)
    if (comparison.off[k] > stiffness_tolerance && !on_boundary[k / 2]) return;
  const double added = system.stiffness.coeff(dof, dof) -
                       diagonal_of_law(forces, comparison.z.size(), dof);
  if (given)
    refuse("spring= is not that of A: at ", vertex_in_words(mesh, dof / 2),
           " A has ", added,
           " more on its diagonal; give the stiffness of the script's int1d on "
           "its labels, [kx, ky] or [kxx, kxy, kyy]");
  if (added > 0)
    refuse(
        "A is stiffer along the boundary than lambda and G (or hooke) make "
        "it, by ",
        added, " on its diagonal at ", vertex_in_words(mesh, dof / 2),
        ": where the script has springs, int1d of k u v, give "
        "spring=[kx*(label == ...), ky*(label == ...)]");
}

/// C times a coordinate at the centroids: r C, whose integrals are exact.
Hooke weighted(const Mesh& mesh, const Hooke& hooke, int radial) {
  Hooke result = hooke;
  for (int t = 0; t < mesh.cell_count(); ++t)
    result[t] *= mesh.origin[radial] + centroid_of(mesh, t)[radial];
  return result;
}

/// Is A a multiple of the stiffness of a body of revolution, r the given coordinate? On
/// axial displacements alone, which stretch no hoop, it is int r C eps(z) : eps(phi).
bool is_axisymmetric(const Mesh& mesh, const ElasticSystem& system,
                     const Hooke& hooke, int radial) {
  Flags left_out = system.prescribed;
  for (std::size_t dof = radial; dof < left_out.size(); dof += 2)
    left_out[dof] = 1;
  const Hooke by_radius = weighted(mesh, hooke, radial);
  const Comparison axial(
      system.stiffness,
      [&](const VectorXd& u) { return forces_of_law<2>(mesh, by_radius, u); },
      left_out);
  return axial.of_matrix.norm() > 0 && axial.is_multiple();
}

void require_plane(const Mesh& mesh, const ElasticSystem& system,
                   const Hooke& hooke) {
  constexpr const char* axis[] = {"x = 0", "y = 0"};
  for (int radial = 0; radial < 2; ++radial)
    if (is_axisymmetric(mesh, system, hooke, radial))
      refuse("A is the stiffness of an axisymmetric body about ", axis[radial],
             ": contactsolve solves it, but contacterror judges plane bodies "
             "alone");
}

}  // namespace

void require_law_of_matrix(const Mesh& mesh, const ElasticSystem& system,
                           const Hooke& hooke, const BoundarySprings& springs) {
  const StatedForces forces = [&](const VectorXd& u) -> VectorXd {
    const VectorXd of_law = forces_of_law<2>(mesh, hooke, u);
    if (springs.empty()) return of_law;
    return of_law -
           boundary_forces(mesh, spring_moment_changes(mesh, springs, u));
  };
  const auto require_plane_body = [&](const Comparison& comparison,
                                      Index worst) {
    require_plane(mesh, system, hooke);
    require_springs_of_matrix(mesh, system, forces, comparison,
                              !springs.empty(), worst);
  };
  require_forces_of_matrix<2>(mesh, system, forces, require_plane_body);
}

}  // namespace ffcontact
