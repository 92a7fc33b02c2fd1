// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/coulomb_constant.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <cstdio>

#include "support/bodies.hpp"
#include "support/coulomb.hpp"
#include "support/random.hpp"

namespace ffcontact::test {
namespace {

/// S in the dofs (n, t) of the bottom of a rectangle, from the dense stiffness.
struct DenseTraces {
  MatrixXd nn, nt, tt;

  explicit DenseTraces(const Problem& problem) {
    const std::vector<char> prescribed = prescribed_dofs(problem.A);
    std::vector<int> n, t, inside;
    std::vector<char> on_line(prescribed.size(), 0);
    for (int v : problem.line.vertex) {
      if (!prescribed[2 * v + 1]) n.push_back(2 * v + 1);
      if (!prescribed[2 * v]) t.push_back(2 * v);
      on_line[2 * v] = on_line[2 * v + 1] = 1;
    }
    for (std::size_t dof = 0; dof < prescribed.size(); ++dof)
      if (!prescribed[dof] && !on_line[dof])
        inside.push_back(static_cast<int>(dof));
    const MatrixXd K = problem.A;
    const auto condensed = [&](const std::vector<int>& a,
                               const std::vector<int>& b) {
      return MatrixXd(K(a, b) -
                      K(a, inside) *
                          K(inside, inside).partialPivLu().solve(K(inside, b)));
    };
    nn = condensed(n, n);
    // u_n = -u_y
    nt = -condensed(n, t);
    tt = condensed(t, t);
  }
};

/// kappa as the definition has it, where the tangential dofs are those of the first nodes.
double dense_kappa(const Problem& problem, const VectorXd& weight) {
  const DenseTraces S(problem);
  const Index t = S.tt.rows();
  const MatrixXd G = S.tt - S.nt.transpose() * S.nn.partialPivLu().solve(S.nt);
  const auto m = weight.head(t).asDiagonal();
  const MatrixXd top = m * S.nn.topLeftCorner(t, t) * m;
  return std::sqrt(Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(top, G)
                       .eigenvalues()
                       .maxCoeff());
}

SlipPattern pattern_of(const VectorXd& sign, double mu) {
  return {sign, VectorXd::Constant(sign.size(), mu),
          std::vector<char>(sign.size(), 0), false};
}

double kappa_with(const Problem& problem, const SlipPattern& pattern, double mu,
                  StuckNodes stuck = StuckNodes::may_slip) {
  return coulomb_constant(Condensed(problem).contact, pattern, mu, stuck);
}

TEST(coulomb_constant, is_the_largest_eigenvalue_of_its_definition) {
  std::mt19937 random(1);
  for (int cells : {2, 4, 8}) {
    const Problem problem = example_1(Multiplier::force, cells);
    const Index p = problem.line.node_count();
    VectorXd sign = VectorXd::Ones(p);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(kappa_with(problem, pattern_of(sign, 0.5), 0.5) /
                      dense_kappa(problem, sign),
                  1, 1e-7);
      sign = random_vector(p, random).cwiseSign();
    }
  }
}

TEST(coulomb_constant, weighs_a_coefficient_that_varies) {
  std::mt19937 random(2);
  const Problem problem = example_1(Multiplier::force, 4);
  SlipPattern pattern =
      pattern_of(VectorXd::Ones(problem.line.node_count()), 0);
  pattern.slope = random_vector(pattern.slope.size(), random).cwiseAbs();
  EXPECT_NEAR(kappa_with(problem, pattern, 0.8) /
                  dense_kappa(problem, pattern.slope / 0.8),
              1, 1e-7);
}

/// With phi on a small part of a wide block it is that of the half plane, where both
/// quadratic forms are |k| times a number in Fourier space: kappa^2 = 1 / (1 - beta^2) for
/// every phi, beta = (1 - 2 nu) / (2 (1 - nu)) the coupling of n and t.
TEST(coulomb_constant, of_a_half_plane) {
  for (double nu : {0.0, 0.2, 0.4}) {
    Problem problem = body(rectangle(128, 64, 2, 1), material(13e3, nu));
    clamp(problem, top);
    const double beta = (1 - 2 * nu) / (2 * (1 - nu)),
                 exact = 1 / std::sqrt(1 - beta * beta);
    SlipPattern pattern =
        pattern_of(VectorXd::Ones(problem.line.node_count()), 0.5);
    for (int i = 0; i < problem.line.node_count(); ++i)
      pattern.sticks[i] =
          std::abs(problem.mesh.vertices(0, problem.line.vertex[i]) - 1) > 0.2;
    const double kappa = kappa_with(problem, pattern, 0.5, StuckNodes::stick);
    std::printf("nu %.1f: kappa %.4f, half plane %.4f\n", nu, kappa, exact);
    EXPECT_NEAR(kappa / exact, 1, 0.02);
  }
}

/// The largest value and what Aitken's extrapolation makes of the last three.
struct Sequence {
  std::vector<double> kappa;
  double limit() const {
    const std::size_t n = kappa.size();
    const double last = kappa[n - 1] - kappa[n - 2],
                 before = kappa[n - 2] - kappa[n - 3];
    return kappa[n - 1] + last * last / (before - last);
  }
};

void expect_sequence(const char* name, const Sequence& sequence,
                     const std::vector<double>& checked) {
  std::printf("%s:", name);
  for (std::size_t k = 0; k < checked.size(); ++k) {
    std::printf(" %.4f", sequence.kappa[k]);
    EXPECT_NEAR(sequence.kappa[k], checked[k], 1e-4);
    if (k > 0) {
      EXPECT_GT(sequence.kappa[k], sequence.kappa[k - 1]);
    }
  }
  std::printf(" -> %.4f\n", sequence.limit());
}

TEST(coulomb_constant, of_example_1) {
  for (Multiplier multiplier : {Multiplier::force, Multiplier::pressure}) {
    Sequence sequence;
    for (int cells : {8, 16, 32, 64})
      sequence.kappa.push_back(kappa_of(example_1(multiplier, cells)));
    expect_sequence("example 1", sequence, {1.6415, 1.6660, 1.6767, 1.6812});
  }
}

TEST(coulomb_constant, of_example_2) {
  for (Multiplier multiplier : {Multiplier::force, Multiplier::pressure}) {
    Sequence sequence;
    for (int cells : {16, 32, 64, 128})
      sequence.kappa.push_back(kappa_of(example_2(multiplier, 0.3, cells)));
    expect_sequence("example 2", sequence, {1.0885, 1.1374, 1.1718, 1.1965});
  }
}

TEST(coulomb_constant, is_none_without_friction_that_depends_on_pressure) {
  Problem problem = example_1(Multiplier::force, 4);
  problem.law.slip_bound = everywhere(problem.line, 1);
  EXPECT_EQ(kappa_of(problem), 0);
  problem = example_1(Multiplier::force, 4);
  set_friction(problem, 0);
  EXPECT_EQ(kappa_of(problem), 0);
  problem = example_1(Multiplier::force, 4);
  problem.law.shear_limit = everywhere(problem.line, 1e-3);
  EXPECT_EQ(kappa_of(problem, solved(problem), StuckNodes::stick), 0);
  EXPECT_TRUE(std::isinf(kappa_of(problem)));
}

TEST(coulomb_constant, is_lower_where_sticking_nodes_are_held) {
  const Problem problem = example_2(Multiplier::force, 0.1, 16);
  const ContactSolution<2> solution = solved(problem);
  EXPECT_LT(kappa_of(problem, solution, StuckNodes::stick),
            kappa_of(problem, solution) - 1e-3);
}

/// Where the sign changes, v with v_n = |phi| bends sharply: kappa grows like log 1/h.
TEST(coulomb_constant, grows_with_refinement_where_the_sign_changes) {
  double last = 0, growth = 0;
  for (int cells : {8, 16, 32}) {
    const Problem problem = example_1(Multiplier::force, cells);
    VectorXd sign = VectorXd::Ones(problem.line.node_count());
    sign.head(cells).setConstant(-1);
    const double kappa = kappa_with(problem, pattern_of(sign, 0.5), 0.5);
    std::printf("one change, %d: %.2f\n", cells, kappa);
    if (growth > 0) {
      EXPECT_NEAR((kappa - last) / growth, 1, 0.15);
    }
    if (last > 0) growth = kappa - last;
    last = kappa;
  }
}

/// A body on two sides of a corner, one that slips where its normal dof is prescribed, and
/// one that moves along t without energy while the sign of slip changes.
TEST(coulomb_constant, is_infinite_where_no_displacement_follows) {
  const auto kappa = [](const Problem& problem) {
    const VectorXd sign = VectorXd::Ones(problem.line.node_count());
    return kappa_with(problem, pattern_of(sign, 0.5), 0.5);
  };
  Problem corner =
      body(rectangle(4, 4, 1, 1), material(1e3, 0.3), {bottom, right});
  clamp(corner, left);
  set_friction(corner, 0.5);
  EXPECT_TRUE(std::isinf(kappa(corner)));

  Problem held = example_1(Multiplier::force, 4);
  EXPECT_TRUE(std::isfinite(kappa(held)));
  prescribe(held, left, 1);
  EXPECT_TRUE(std::isinf(kappa(held)));

  Problem loose = body(rectangle(4, 4, 1, 1), material(1e3, 0.3));
  set_friction(loose, 0.5);
  VectorXd sign = VectorXd::Ones(5);
  EXPECT_TRUE(std::isfinite(kappa_with(loose, pattern_of(sign, 0.5), 0.5)));
  sign.head(2).setConstant(-1);
  EXPECT_TRUE(std::isinf(kappa_with(loose, pattern_of(sign, 0.5), 0.5)));
}

/// The last node of the upper line moves along t with the body below alone.
TEST(coulomb_constant, of_a_node_whose_opposite_vertices_move) {
  const auto kappa = [](double stiffness_below) {
    Bodies two =
        bodies({shifted(rectangle(4, 3, 4, 3), {1, 4}), rectangle(8, 4, 8, 4)},
               {material(1e3, 0.3), material(stiffness_below, 0.3)},
               {{0, bottom, 1, top}});
    clamp(two.problem, two.label(1, bottom));
    prescribe(two.problem, two.label(0, right), 0);
    set_friction(two.problem, 0.5);
    const VectorXd sign = VectorXd::Ones(two.problem.line.node_count());
    return kappa_with(two.problem, pattern_of(sign, 0.5), 0.5);
  };
  Problem alone = body(rectangle(4, 3, 4, 3), material(1e3, 0.3));
  prescribe(alone, right, 0);
  const VectorXd sign = VectorXd::Ones(alone.line.node_count());
  const double on_a_foundation = kappa_with(alone, pattern_of(sign, 0.5), 0.5);
  std::printf("kappa %.4f, on the foundation %.4f\n", kappa(1e3),
              on_a_foundation);
  EXPECT_TRUE(std::isfinite(kappa(1e3)));
  EXPECT_NEAR(kappa(1e9), on_a_foundation, 1e-3);
}

TEST(coulomb_constant, bound_is_e_over_the_root_of_what_is_left) {
  EXPECT_NEAR(coulomb_bound(3, 0.5, 1.5), 6, 1e-14);
  EXPECT_EQ(coulomb_bound(3, 0, 1.5), 3);
  EXPECT_EQ(coulomb_bound(3, 0.5, 0), 3);
  EXPECT_TRUE(std::isinf(coulomb_bound(3, 0.5, 2)));
  EXPECT_TRUE(std::isinf(coulomb_bound(3, 0.5, 1e300)));
}

}  // namespace
}  // namespace ffcontact::test
