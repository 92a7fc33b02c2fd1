// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/shared_response.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/multigrid/surface_unknowns.hpp"
#include "ffcontact/linear/norms.hpp"
#include "support/solid_corners.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The vertices of a brick in a corner, in states at random, with forces, motions and z.
struct RandomResponses {
  SolidCorner corner;
  ElasticSystem system = corner.problem.system();
  SurfaceTrace trace =
      surface_trace(corner.problem.surface, corner.problem.law, system);
  SurfaceUnknowns unknowns = surface_unknowns(corner.problem.surface, trace,
                                              corner.problem.law.layer, system);
  NaturalMap map;
  std::vector<NodeState> states;
  SurfaceEquations equations{trace.held, map, states};

  RandomResponses(const CompliantLayer& layer, Random& random)
      : corner(with_layer(layer, random)),
        map(stiffness(), rows(), trace.held) {
    const VectorXd P = 1e4 * random_vector(rows().size(), random),
                   v = random_vector(rows().size(), random);
    states = map.states(nodal_law(corner.problem.law, corner.problem.surface),
                        {P, v});
  }

 private:
  static SolidCorner with_layer(const CompliantLayer& layer, Random& random) {
    SolidCorner corner(1 + random() % 2, 0.5, random);
    corner.problem.law.layer = layer;
    return corner;
  }
  VectorXd stiffness() const { return VectorXd::Constant(rows().size(), 1e4); }
  VectorXi rows() const {
    const int count = 3 * corner.problem.surface.node_count();
    return VectorXi::LinSpaced(count, 0, count - 1);
  }
};

double side(const Equation& equation, const std::vector<int>& rows,
            const VectorXd& P, const VectorXd& v) {
  double sum = -equation.value;
  for (const Term& term : equation.terms) {
    const auto k = std::find(rows.begin(), rows.end(), term.row) - rows.begin();
    sum += term.P * P[k] + term.v * v[k];
  }
  return sum;
}

void expect_conditions(const SharedVertex& shared,
                       const SurfaceEquations& equations, Random& random) {
  const SharedResponse response = shared_response(shared, equations);
  const int r = shared.row_count(), first = r - shared.coupling;
  const Vector3d F = 1e4 * random_vector(3, random);
  const VectorXd v = random_vector(r, random),
                 z = 1e4 * random_vector(shared.coupling, random);
  const VectorXd P = response.of_force * F + response.of_v * v +
                     response.of_z * z + response.given;
  const VectorXd gives = (shared.layer + softness(shared)).cwiseProduct(P),
                 z_missed = response.z_of_P * P + response.z_of_v * v -
                            response.z_value;
  for (int k = 0; k < r; ++k) {
    const int row = shared.rows[k];
    const double scale = equations.is_fixed(row) ? 1e4 : 1,
                 missed = scale * side(equations.equation(row), shared.rows, P,
                                       v + gives);
    const bool is_z = k >= first && !response.of_z.col(k - first).isZero(0);
    const double left = holds(shared, equations, k)
                            ? shared.E.col(k).dot(P) - F[k]
                        : is_z ? missed - z_missed[k - first]
                               : missed;
    EXPECT_LE(std::abs(left), 1e-9 * P.norm());
    EXPECT_TRUE(!is_z || P[k] == z[k - first]);
  }
}

TEST(SharedResponse, meets_the_conditions_of_its_states) {
  Random random(1);
  for (const CompliantLayer& layer :
       {CompliantLayer{0, 0}, CompliantLayer{1e-4, 0},
        CompliantLayer{1e-4, 1e-3}})
    for (int k = 0; k < 20; ++k) {
      const RandomResponses problem(layer, random);
      for (const SharedVertex& shared : problem.unknowns.shared)
        expect_conditions(shared, problem.equations, random);
    }
}

}  // namespace
}  // namespace ffcontact
