// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/coulomb_constant.hpp"

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
          std::vector<char>(sign.size(), 0)};
}

double kappa_with(const Problem& problem, const SlipPattern& pattern, double mu,
                  StuckNodes stuck = StuckNodes::may_slip) {
  return coulomb_constant(Condensed(problem).contact, pattern, mu, stuck);
}

TEST(coulomb_constant, is_the_largest_eigenvalue_of_its_definition) {
  Random random(1);
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
  Random random(2);
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

}  // namespace
}  // namespace ffcontact::test
