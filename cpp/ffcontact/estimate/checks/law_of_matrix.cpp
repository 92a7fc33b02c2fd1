// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/law_of_matrix.hpp"

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/estimate/checks/forces_of_matrix.hpp"
#include "ffcontact/mesh/boundary_vertices.hpp"

namespace ffcontact {

namespace {

/// Refuses a matrix that differs along the boundary alone, by what a spring would add.
template <int d>
void require_springs_of_matrix(const SimplexMesh<d>& mesh,
                               const ElasticSystem& system,
                               const StatedForces& forces,
                               const Comparison& comparison, bool given,
                               Index dof) {
  const Flags on_boundary = boundary_vertices(mesh);
  for (Index k = 0; k < comparison.off.size(); ++k)
    if (comparison.off[k] > stiffness_tolerance && !on_boundary[k / d]) return;
  const double added = row_beyond_law(system, forces, dof)[dof];
  if (given)
    refuse("spring= is not that of A: at ", vertex_in_words(mesh, dof / d),
           " A has ", added,
           " more on its diagonal; give the stiffness of the script's ",
           d == 2 ? "int1d on its labels, [kx, ky] or [kxx, kxy, kyy]"
                  : "int2d on its labels, [kx, ky, kz] or [kxx, kxy, kxz, "
                    "kyy, kyz, kzz]");
  if (added > 0)
    refuse(
        "A is stiffer along the boundary than lambda and G (or hooke) make "
        "it, by ",
        added, " on its diagonal at ", vertex_in_words(mesh, dof / d),
        ": where the script has springs, ",
        d == 2 ? "int1d of k u v, give spring=[kx*(label == ...), ky*(label == "
                 "...)]"
               : "int2d of k u v, give spring=[kx*(label == ...), ky*(label == "
                 "...), kz*(label == ...)]");
}

/// Of a cell's centroid, as the script sees it.
template <int d>
double coordinate(const SimplexMesh<d>& mesh, int cell, int c) {
  return mesh.origin[c] + centroid_of(mesh, cell)[c];
}

/// C times a coordinate at the centroids: r C, whose integrals are exact.
template <int d>
HookeTensors<d> weighted(const SimplexMesh<d>& mesh, HookeTensors<d> hooke,
                         int radial) {
  for (int t = 0; t < mesh.cell_count(); ++t)
    hooke[t] *= coordinate<d>(mesh, t, radial);
  return hooke;
}

/// Is A a multiple of the stiffness of a body of revolution, r the given coordinate? On
/// axial displacements alone, which stretch no hoop, it is int r C eps(z) : eps(phi).
template <int d>
bool is_axisymmetric(const SimplexMesh<d>& mesh, const ElasticSystem& system,
                     const HookeTensors<d>& hooke, int radial) {
  Flags left_out = system.prescribed;
  for (std::size_t dof = radial; dof < left_out.size(); dof += d)
    left_out[dof] = 1;
  const HookeTensors<d> by_radius = weighted<d>(mesh, hooke, radial);
  const Comparison axial(
      system.stiffness,
      [&](const VectorXd& u) { return forces_of_law<d>(mesh, by_radius, u); },
      left_out);
  return axial.of_matrix.norm() > 0 && axial.is_multiple();
}

/// Refuses the matrix of a body of revolution.
template <int d>
void require_not_axisymmetric(const SimplexMesh<d>& mesh,
                              const ElasticSystem& system,
                              const HookeTensors<d>& hooke) {
  constexpr const char* axis[] = {"x = 0", "y = 0"};
  if constexpr (d == 2)
    for (int radial = 0; radial < 2; ++radial)
      if (is_axisymmetric<d>(mesh, system, hooke, radial))
        refuse("A is the stiffness of an axisymmetric body about ",
               axis[radial],
               ": contactsolve solves it, but contacterror judges plane "
               "bodies alone");
}

}  // namespace

template <int d>
void require_law_of_matrix(const SimplexMesh<d>& mesh,
                           const ElasticSystem& system,
                           const HookeTensors<d>& hooke,
                           const BoundarySprings<d>& springs) {
  const StatedForces forces = [&](const VectorXd& u) -> VectorXd {
    const VectorXd of_law = forces_of_law<d>(mesh, hooke, u);
    if (springs.empty()) return of_law;
    return of_law -
           boundary_forces<d>(mesh, spring_moment_changes<d>(mesh, springs, u));
  };
  const auto other = [&](const Comparison& comparison, Index worst) {
    require_not_axisymmetric<d>(mesh, system, hooke);
    require_springs_of_matrix<d>(mesh, system, forces, comparison,
                                 !springs.empty(), worst);
  };
  require_forces_of_matrix<d>(mesh, system, forces, other);
}

template void require_law_of_matrix(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const ElasticSystem&,
    const HookeTensors<FFCONTACT_DIMENSION>&,
    const BoundarySprings<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
