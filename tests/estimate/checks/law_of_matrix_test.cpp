// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/law_of_matrix.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "support/estimates.hpp"
#include "support/pi.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// What the estimate says when one thing about the data of example 1 is wrong.
template <class Spoil>
std::string sentence_about(Multiplier multiplier, Spoil spoil) {
  Problem problem = example_1(multiplier, 4);
  const ContactSolution<2> solution = solved(problem);
  SolvedBody<2> body = solved_body(problem, solution);
  spoil(problem, body, solution);
  return refusal([&] {
    estimate_error(topology_of(problem.mesh), problem.line, problem.system(),
                   body, EstimateSettings<2>{});
  });
}

TEST(DataDefect, names_the_law_and_its_factor) {
  const std::string sentence = sentence_about(
      Multiplier::force,
      [](Problem&, SolvedBody<2>& body, const ContactSolution<2>&) {
        for (Matrix3d& C : body.hooke) C *= 2;
      });
  EXPECT_TRUE(says(
      sentence, "lambda and G (or hooke) are not those of A: A is 0.5 times"))
      << sentence;
}

/// Displacements alone load the body, and nothing touches the foundation: equilibrium
/// does not see the factor.
TEST(DataDefect, names_the_law_where_equilibrium_cannot) {
  Problem problem = body(rectangle(6, 6, 1, 1), material(1000, 0.3), {left});
  clamp(problem, bottom);
  clamp(problem, top, [](const Vector2d& x) -> Vector2d {
    return {0.01 * (1 + x.x()), 0.01};
  });
  SolvedBody<2> body = solved_body(problem, solved(problem));
  ASSERT_EQ(body.multipliers.cwiseAbs().maxCoeff(), 0);
  for (Matrix3d& C : body.hooke) C *= 2;
  EXPECT_TRUE(says(refusal([&] {
                     estimate_error(topology_of(problem.mesh), problem.line,
                                    problem.system(), body, {});
                   }),
                   "A is 0.5 times the stiffness of the law"));
}

TEST(DataDefect, names_the_vertex_where_the_law_of_one_region_is_off) {
  const std::string sentence = sentence_about(
      Multiplier::force, [](Problem&, SolvedBody<2>& body,
                            const ContactSolution<2>&) { body.hooke[9] *= 3; });
  EXPECT_TRUE(says(
      sentence,
      "A is not the stiffness of lambda and G (or hooke): its row of vertex "))
      << sentence;
}

TEST(DataDefect, names_a_penalty_that_does_not_prescribe) {
  const std::string sentence = sentence_about(
      Multiplier::force,
      [](Problem& problem, SolvedBody<2>&, const ContactSolution<2>&) {
        problem.A.coeffRef(20, 20) += 1e10;
      });
  EXPECT_TRUE(says(sentence, "A has 1e+10 more on its diagonal at vertex 10 "))
      << sentence;
}

/// int c r (C eps : eps(phi) + what the hoop strain u_r / r adds), by one point a
/// triangle.
RowMatrix axisymmetric(const Problem& problem, int radial, double c) {
  const Mesh& mesh = problem.mesh;
  const Material m = material(13e3, 0.2);
  RowMatrix A = problem.A;
  std::vector<Eigen::Triplet<double>> entries;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const double r = centroid_of(mesh, t)[radial];
    const Matrix<double, 2, 3> hats = hat_gradients(mesh, t);
    Matrix<double, 4, 6> B = Matrix<double, 4, 6>::Zero();
    for (int k = 0; k < 3; ++k) {
      B.block<3, 2>(0, 2 * k) << hats(0, k), 0, 0, hats(1, k), hats(1, k),
          hats(0, k);
      B(3, 2 * k + radial) = 1 / (3 * r);
    }
    Matrix4d C = Matrix4d::Zero();
    C.topLeftCorner<3, 3>() = m.hooke();
    C(3, 3) = m.lambda + 2 * m.G;
    for (int i : {0, 1}) C(i, 3) = C(3, i) = m.lambda;
    const Matrix<double, 6, 6> K =
        c * r * signed_area(mesh, t) * B.transpose() * C * B;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        entries.emplace_back(2 * mesh.cells(i / 2, t) + i % 2,
                             2 * mesh.cells(j / 2, t) + j % 2, K(i, j));
  }
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

TEST(DataDefect, names_an_axisymmetric_body) {
  for (int radial : {0, 1}) {
    Problem problem = body(rectangle(4, 3, 4, 3), material(13e3, 0.2));
    problem.A = axisymmetric(problem, radial, 2 * pi);
    clamp(problem, top);
    const std::string expected =
        std::string("A is the stiffness of an axisymmetric body about ") +
        (radial == 0 ? "x = 0" : "y = 0");
    EXPECT_TRUE(says(refusal([&] {
                       require_law_of_matrix(problem.mesh, problem.system(),
                                             problem.hooke);
                     }),
                     expected));
    // another modulus along the axis is none
    problem.A.coeffRef(2, 2) *= 1.01;
    problem.A.coeffRef(3, 3) *= 1.01;
    EXPECT_TRUE(says(refusal([&] {
                       require_law_of_matrix(problem.mesh, problem.system(),
                                             problem.hooke);
                     }),
                     "A is not the stiffness of lambda and G"));
  }
}

TEST(DataDefect, names_a_point_support) {
  Problem problem = example_1(Multiplier::force, 2);
  prescribe_dof(problem, 2 * 5 + 1, 0.01);  // the middle of the loaded side
  const std::string sentence =
      refusal([&] { estimated(problem, solved(problem)); });
  EXPECT_TRUE(says(sentence, "vertex 5 (0, 20)") &&
              says(sentence, "it is the reaction of a point support"))
      << sentence;
}

TEST(DataDefect, names_the_multiplier_that_the_pressures_belong_to) {
  const std::string of_forces = sentence_about(
      Multiplier::force, [](Problem& problem, SolvedBody<2>& body,
                            const ContactSolution<2>& solution) {
        body.multipliers = lumped_pressures(problem.line, solution.force);
        body.law.multiplier = Multiplier::pressure;
      });
  EXPECT_TRUE(
      says(of_forces,
           "pn and pt fit u with multiplier=\"force\", not with \"pressure\""))
      << of_forces;
  const std::string of_pressures = sentence_about(
      Multiplier::pressure, [](Problem& problem, SolvedBody<2>& body,
                               const ContactSolution<2>& solution) {
        body.law.multiplier = Multiplier::force;
        body.multipliers =
            multiplier_density(problem.line, Multiplier::force,
                               prescribed_dofs(problem.A), solution.pressure);
      });
  EXPECT_TRUE(
      says(of_pressures,
           "pn and pt fit u with multiplier=\"pressure\", not with \"force\""))
      << of_pressures;
}

TEST(DataDefect, names_the_loads_that_are_not_those_of_u) {
  const std::string traction = sentence_about(
      Multiplier::force, [](Problem&, SolvedBody<2>& body,
                            const ContactSolution<2>&) { body.neumann *= 2; });
  EXPECT_TRUE(
      says(traction,
           "on the boundary: give the traction=, rest=, initialstrain= and "
           "initialstress= u was computed with"))
      << traction;
  const std::string inside = sentence_about(
      Multiplier::force,
      [](Problem&, SolvedBody<2>& body, const ContactSolution<2>&) {
        body.body_loads.array() += 1;
      });
  EXPECT_TRUE(says(inside,
                   "inside the body: give the bodyforce=, initialstrain= and "
                   "initialstress= u was computed with"))
      << inside;
  const std::string contact = sentence_about(
      Multiplier::force,
      [](Problem&, SolvedBody<2>& body, const ContactSolution<2>&) {
        body.multipliers *= 1.1;
      });
  EXPECT_TRUE(
      says(contact, "on the contact line: give pn and pt of the solution u"))
      << contact;
}

}  // namespace
}  // namespace ffcontact
