// SPDX-License-Identifier: GPL-3.0-or-later
// The estimate of solids for sigma = C eps(u) + tau0, tau0 = sigma0 - C eps0.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <functional>

#include "ffcontact/elastic/stiffness.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solid_estimates.hpp"

namespace ffcontact {
namespace {

using namespace test;

const Vector3d size_of_block(80, 40, 40);

SolidProblem pressed_block(Random& random) {
  const double friction[] = {0, 0.3, 1};
  const BlockCase cases[] = {BlockCase::press, BlockCase::shear};
  const SolidMesh mesh = shuffled(
      moved(brick({4, 2, 2}, size_of_block), 20, 0.15, random), random);
  return block_problem(mesh, cases[random() % 2], friction[random() % 3]);
}

using FieldOfSolid = std::function<VoigtVector<3>(const Vector3d&)>;

LinearStresses<3> stresses_at_vertices(const SolidMesh& mesh,
                                       const FieldOfSolid& tau) {
  LinearStresses<3>::Values values(24, mesh.cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 4; ++k)
      values.col(t).segment<6>(6 * k) = tau(mesh.corner(t, k));
  return LinearStresses<3>::of_values(values);
}

/// The solution of a problem whose loads have - int tau0 : eps(phi), and its estimate.
struct Stressed {
  Topology<3> topology;
  SolvedBody<3> body;
  Estimate<3> found;

  Stressed(SolidProblem problem, LinearStresses<3> tau,
           const RelaxationSettings& settings = {})
      : topology(topology_of(problem.mesh)) {
    const SolidMesh& mesh = problem.mesh;
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const auto gradients = hat_gradients(mesh, t);
      for (int k = 0; k < 4; ++k)
        problem.b.segment<3>(3 * mesh.cells(k, t)) -=
            signed_volume(mesh, t) *
            traction(tau.mean.col(t), gradients.col(k));
    }
    body = solved_solid(problem, problem.solve());
    body.initial = std::move(tau);
    found = estimate_error(topology, problem.surface, problem.system(), body,
                           {settings});
  }
};

/// tau0 = - C eps(w) of a w that is 0 on the boundary moves u by w, and no stress.
RC_GTEST_PROP(SolidInitialStrain, of_a_displacement_inside_changes_nothing,
              (Random random)) {
  const SolidProblem problem = pressed_block(random);
  const Estimate<3> without = estimate(problem);
  VectorXd w = 0.02 * random_vector(problem.b.size(), random);
  for (int v : problem.mesh.boundary.reshaped()) w.segment<3>(3 * v).setZero();
  const HookeTensors<3> hooke = solved_solid(problem, problem.solve()).hooke;
  const CellStresses<3> tau = -stresses(problem.mesh, hooke, w);
  RC_ASSERT(tau.cwiseAbs().maxCoeff() > 0);
  const Stressed with(problem, LinearStresses<3>(tau));
  RC_ASSERT(with.found.reason == "");
  // rounding decides which stars of contact faces are worth a change
  RC_ASSERT(std::abs(with.found.e - without.e) < 1e-3 * without.e);
  RC_ASSERT((with.found.local - without.local).norm() <
            1e-2 * without.local.norm());
}

/// With one that varies in the cells, e is the distance of sigma_hat to C eps(u_hat) + tau0
/// at all points, and sigma_hat is admissible.
RC_GTEST_PROP(SolidInitialStress, that_varies_is_in_the_error,
              (Random random)) {
  const SolidProblem problem = pressed_block(random);
  const Matrix<double, 6, 4> S = random_matrix(6, 4, random);
  const Stressed with(
      problem, stresses_at_vertices(problem.mesh, [&](const auto& x) {
        return VoigtVector<3>(100 * S *
                              Vector4d(1, x.x() / 40, x.y() / 40, x.z() / 40));
      }));
  const auto& [topology, body, found] = with;
  RC_ASSERT(found.reason == "");
  RC_ASSERT(found.equilibrium.largest() < 1e-11);
  const LinearStresses<3> total =
      total_stresses(topology.mesh, body, found.displacement);
  double square = 0;
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    square += energy<3>(corners_of(topology.mesh, t), body.hooke[t].inverse(),
                        stress_of(topology, found, body, t) -
                            subcell_values<3>(total.at_vertices(t)));
  RC_ASSERT(std::abs(std::sqrt(square) - found.elastic) < 1e-9 * found.e);
  RC_ASSERT(std::abs(found.history[0] -
                     Stressed(problem, body.initial, {0, 0}).found.e) <
            1e-6 * found.e);
}

TEST(SolidInitialStress, refuses_what_is_not_finite_or_does_not_fit) {
  Random random(5);
  const SolidProblem problem = pressed_block(random);
  SolvedBody<3> body = solved_solid(problem, problem.solve());
  const auto said = [&] {
    return refusal([&] {
      estimate_error(topology_of(problem.mesh), problem.surface,
                     problem.system(), body);
    });
  };
  body.initial =
      LinearStresses<3>(CellStresses<3>::Zero(6, problem.mesh.cell_count()));
  body.initial.mean(2, 7) = std::nan("");
  EXPECT_EQ(said(),
            "the initial strain or stress on tetrahedron 7 is not a finite "
            "number");
  body.initial = LinearStresses<3>(CellStresses<3>::Zero(6, 3));
  EXPECT_EQ(said(), "initial stress has 3 values where " +
                        std::to_string(problem.mesh.cell_count()) +
                        " are needed");
}

}  // namespace
}  // namespace ffcontact
