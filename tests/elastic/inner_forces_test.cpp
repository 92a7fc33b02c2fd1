// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/inner_forces.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The tractions s n of the boundary, a dim-th of each facet's to each of its vertices:
/// what a uniform stress s makes of them.
template <int dim>
VectorXd tractions_of(const SimplexMesh<dim>& mesh,
                      const VoigtVector<dim>& stress) {
  VectorXd forces = VectorXd::Zero(dim * mesh.vertices.cols());
  const Facets<dim> facets = facets_of(mesh);
  for (int f = 0; f < facets.count(); ++f) {
    if (!facets.on_boundary(f)) continue;
    const Matrix<double, dim, 1> force =
        traction(stress, facet_normal(mesh, facets, f)) *
        facet_measure(mesh, facets, f);
    for (const int v : facets.vertices.col(f))
      forces.segment<dim>(dim * v) += force / dim;
  }
  return forces;
}

template <int dim>
double off_in_uniform_stress(const SimplexMesh<dim>& mesh, Random& random) {
  const VoigtVector<dim> stress = random_vector(voigt_size<dim>, random);
  const VectorXd forces =
      inner_forces<dim>(mesh, stress.replicate(1, mesh.cell_count()));
  return (forces - tractions_of(mesh, stress)).norm();
}

RC_GTEST_PROP(InnerForces, of_a_uniform_stress_are_its_tractions,
              (Random random)) {
  RC_ASSERT(off_in_uniform_stress(irregular(5, 4, 5, 4, random), random) <
            1e-12);
  RC_ASSERT(off_in_uniform_stress(irregular_solid(random), random) < 1e-12);
}

/// Work on a linear displacement is that of the stresses, sum |T| sigma : eps.
RC_GTEST_PROP(InnerForces, work_as_the_stresses_do, (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Matrix3d slope = random_matrix(3, 3, random);
  const Matrix<double, 6, Dynamic> stress =
      random_matrix(6, mesh.cell_count(), random);
  const VectorXd u =
      nodal_values(mesh, [&](const Vector3d& x) { return slope * x; });
  double work = 0;
  for (int t = 0; t < mesh.cell_count(); ++t)
    work += signed_volume(mesh, t) * stress.col(t).dot(strain(mesh, u, t));
  RC_ASSERT(std::abs(inner_forces<3>(mesh, stress).dot(u) - work) < 1e-12);
}

}  // namespace
}  // namespace ffcontact
