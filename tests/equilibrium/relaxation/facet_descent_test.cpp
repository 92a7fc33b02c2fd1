// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/relaxation/facet_descent.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/energy/short_edge_lines.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "support/cases.hpp"
#include "support/estimates.hpp"
#include "support/problems.hpp"
#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// An irregular rectangle, pulled on the left and clamped at the top.
/// @param stretch  of its triangles along x
Problem loaded_problem(int nx, int ny, Random& random, double stretch = 1) {
  Problem problem =
      body(irregular(nx, ny, stretch * nx, ny, random), material(1000, 0.3));
  add_traction(problem, left, {1, -2});
  clamp(problem, top);
  return problem;
}

/// A plane body as the descent takes it.
struct PlaneBody {
  Problem problem;
  Equilibrated fields;

  explicit PlaneBody(const Problem& stated)
      : problem(stated), fields(equilibrated(stated, solved(stated))) {}

  LoadedFacets<2> loaded() const { return fields.difference(); }
  double square(const EdgeMoments& moments) const {
    double sum = 0;
    for (int t = 0; t < problem.mesh.cell_count(); ++t)
      sum += energy<2>(loaded().topology.corners(t), problem.hooke[t].inverse(),
                       difference_stress<2>(loaded(), moments, t));
    return sum;
  }
  EquilibriumDefect defect(const EdgeMoments& moments) const {
    std::vector<SubcellStress<2>> stress;
    for (int t = 0; t < problem.mesh.cell_count(); ++t)
      stress.push_back(difference_stress<2>(loaded(), moments, t) +
                       fields.sigma(t));
    Equilibrated at = fields;
    at.moments = moments;
    return defect_of(problem, at, stress);
  }
};

struct Descended {
  std::vector<double> falls;
  EdgeMoments moments;
};

Descended descended(const PlaneBody& body, int steps) {
  const FacetShare whole = whole_share<2>(body.loaded().topology);
  const NoExchange<2> none;
  FacetDescent<2> descent(body.loaded(), body.fields.moments, whole, none);
  descent.begin();
  Descended result{{}, body.fields.moments};
  for (int k = 0; k < steps; ++k) result.falls.push_back(descent.step());
  add_corrections<2>(body.loaded().topology, body.fields.boundary.known,
                     descent.corrections(), result.moments);
  return result;
}

RC_GTEST_PROP(FacetDescent, falls_by_what_the_energy_falls_and_stays_balanced,
              ()) {
  const PlaneBody body(problem_of(*random_case(0.5)));
  const double before = body.square(body.fields.moments);
  const Descended after = descended(body, 6);
  double fallen = 0;
  for (double fall : after.falls) {
    RC_ASSERT(fall >= 0);
    fallen += fall;
  }
  RC_ASSERT(std::abs(before - body.square(after.moments) - fallen) <=
            1e-11 * before);
  RC_ASSERT(body.defect(after.moments).largest() < 1e-10);
}

/// All corrections of the stars, as columns, and their energy x'Hx + 2 g'x.
struct Dense {
  PlaneBody body;
  LoadedFacets<2> loaded = body.loaded();
  FacetForms<2> forms{loaded.topology, loaded.hooke};
  FacetShare whole = whole_share<2>(loaded.topology);
  NoExchange<2> none;

  explicit Dense(Random& random, double stretch = 1)
      : body(loaded_problem(4, 3, random, stretch)) {}
  Dense(const Dense&) = delete;

  /// Those of the stars of a line.
  MatrixXd corrections(const RidgeLines& lines, int line) const {
    MatrixXd Z(4 * loaded.topology.facets.count(), 0);
    for (int i = lines.start[line]; i < lines.start[line + 1]; ++i) {
      const MatrixXd own = corrections(lines.ridge[i]);
      Z.conservativeResize(Eigen::NoChange, Z.cols() + own.cols());
      Z.rightCols(own.cols()) = own;
    }
    return Z;
  }

  /// Those of one star [4 edges x own].
  MatrixXd corrections(int ridge) const {
    const FacetTopology<2>& topology = loaded.topology;
    const MatrixXd conditions = ridge_conditions<2>(
        topology, ridge, shifts_around<2>(topology, ridge).data(),
        loaded.boundary.known);
    const Index n = unknowns_around<2>(topology.ridges, ridge);
    const MatrixXd basis = conditions.rows() > 0
                               ? kernel_basis(conditions, {1e-9})
                               : MatrixXd(MatrixXd::Identity(n, n));
    MatrixXd Z = MatrixXd::Zero(4 * topology.facets.count(), basis.cols());
    const std::vector<int> around = facets_around<2>(topology.ridges, ridge);
    for (Index j = 0; j < basis.cols(); ++j)
      for (int place = 0; place < count_of(around); ++place)
        Z.col(j).segment<4>(4 * around[place]) =
            at_place<2>(topology, ridge, place, basis.col(j));
    return Z;
  }

  MatrixXd times(const MatrixXd& X) const {
    const Edges& edges = loaded.topology.facets;
    MatrixXd Y = MatrixXd::Zero(X.rows(), X.cols());
    for (Index j = 0; j < X.cols(); ++j) {
      const FacetColumns<2> x = X.col(j).reshaped(4, edges.count());
      for (int t = 0; t < loaded.topology.mesh.cell_count(); ++t) {
        const CellVector<2> y = forms.times(t, unknowns_at<2>(edges, x, t));
        for (int k = 0; k < 3; ++k)
          Y.col(j).segment<4>(4 * edges.of_cell(k, t)) += y.segment<4>(4 * k);
      }
    }
    return Y;
  }
};

/// Of a body whose triangles are stretched so much.
void require_sum_of_lines(Random& random, double stretch) {
  const Dense dense(random, stretch);
  const FacetTopology<2>& topology = dense.loaded.topology;
  const RidgeLines lines = short_edge_lines(topology, dense.whole);
  const FacetColumns<2> r = random_matrix(4, topology.facets.count(), random);
  VectorXd sum = VectorXd::Zero(r.size());
  for (int line = 0; line < lines.count(); ++line) {
    const MatrixXd Z = dense.corrections(lines, line);
    if (Z.cols() > 0)
      sum += Z * least_squares(Z.transpose() * dense.times(Z),
                               Z.transpose() * r.reshaped());
  }
  RidgeStars<2> stars(topology, dense.whole, dense.loaded.boundary,
                      dense.forms);
  FacetColumns<2> z(4, r.cols());
  stars(r, z);
  RC_ASSERT((z.reshaped() - sum).norm() < 1e-4 * sum.norm());
}

RC_GTEST_PROP(RidgeStars, sum_what_every_star_does_alone, (Random random)) {
  require_sum_of_lines(random, 1);
}
RC_GTEST_PROP(RidgeStars, sum_what_every_line_does_alone, (Random random)) {
  require_sum_of_lines(random, 8);
}

RC_GTEST_PROP(FacetDescent, ends_at_the_least_energy_of_all_stars,
              (Random random)) {
  const Dense dense(random);
  const int ridges = dense.loaded.topology.ridges.count();
  RidgeLines all{{0, ridges}, std::vector<int>(ridges)};
  std::iota(all.ridge.begin(), all.ridge.end(), 0);
  const MatrixXd Z = dense.corrections(all, 0);
  FacetDescent<2> descent(dense.loaded, dense.body.fields.moments, dense.whole,
                          dense.none);
  descent.begin();
  const VectorXd slope = Z.transpose() * descent.residual().reshaped();
  const double most =
      slope.dot(least_squares(Z.transpose() * dense.times(Z), slope));
  double fallen = 0;
  for (int step = 0; step < 300; ++step) fallen += descent.step();
  RC_ASSERT(std::abs(most - fallen) < 1e-6 * most);
}

TEST(FacetDescent, keeps_balance_for_hundreds_of_steps) {
  Random random(5);
  const PlaneBody plane(loaded_problem(8, 6, random));
  EXPECT_LT(plane.defect(descended(plane, 400).moments).largest(), 1e-10);
}

TEST(FacetDescent, does_not_depend_on_the_number_of_threads) {
  Random random(31);
  const PlaneBody plane(loaded_problem(8, 6, random));
  EdgeMoments one, two;
  on_threads(2, [&] { two = descended(plane, 6).moments; });
  on_threads(1, [&] { one = descended(plane, 6).moments; });
  EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace ffcontact
