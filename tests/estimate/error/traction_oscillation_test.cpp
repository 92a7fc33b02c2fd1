// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/traction_oscillation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/estimate/error/facet_oscillation.hpp"
#include "ffcontact/interface/traction_parts.hpp"
#include "support/solid_stacks.hpp"
#include "support/traction_constant.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// kappa_k^2 / (1 - 1/k), which falls with k.
double bound_of_subdivision(int k) {
  return LeastStress(divided_tetrahedron(k), high_x).largest_ratio() /
         (1 - 1.0 / k);
}

TEST(TractionOscillation, constant_is_that_of_a_divided_face) {
  EXPECT_NEAR(bound_of_subdivision(3), 2.789, 1e-3);
  EXPECT_LT(bound_of_subdivision(4), traction_constant<3>);
  EXPECT_GT(bound_of_subdivision(4), traction_constant<3> - 0.01);
}

/// A block with a side that is tilted against that of another one.
inline SolidMesh tilted_brick(Random& random) {
  SolidMesh mesh =
      random_brick(random_cells(1, 3, random), {0, 0, -1}, {3, 2, 1}, random);
  for (auto x : mesh.vertices.colwise()) x.z() -= 0.5 * x.x() + 0.3 * x.y();
  return mesh;
}

/// Two blocks that face each other in part, at random, with tractions at random.
struct FacingTractions {
  SolidStack stack;
  Matrix3Xd traction;
  HookeTensors<3> hooke;

  explicit FacingTractions(Random& random)
      : stack({random_brick(random_cells(1, 3, random), {0.3, -0.4, 0},
                            {3, 2, 1}, random),
               tilted_brick(random)},
              0),
        traction(random_matrix(3, stack.problem.surface.node_count(), random)),
        hooke(stack.problem.mesh.cell_count(), isotropic<3>(2, 1)) {
    ContactSurface& surface = stack.problem.surface;
    if (random() % 2) surface = turned_at_random(surface, 0.5, random);
  }

  double oscillation() const {
    const SolidProblem& problem = stack.problem;
    return traction_oscillation(
        problem.mesh, problem.faces, problem.surface, hooke,
        {traction, tractions_by_face(problem.surface, traction)});
  }
};

/// v = (x'Q x)_c, its values and strains.
struct QuadraticInSpace {
  std::array<Matrix3d, 3> Q;

  explicit QuadraticInSpace(Random& random) {
    for (Matrix3d& q : Q) q = random_matrix(3, 3, random);
  }
  Vector3d operator()(const Vector3d& x) const {
    return {x.dot(Q[0] * x), x.dot(Q[1] * x), x.dot(Q[2] * x)};
  }
  VoigtVector<3> strain(const Vector3d& x) const {
    Matrix3d gradient;
    for (int c = 0; c < 3; ++c)
      gradient.row(c) = ((Q[c] + Q[c].transpose()) * x).transpose();
    const Matrix3d twice = gradient + gradient.transpose();
    VoigtVector<3> strain;
    strain << twice(0, 0) / 2, twice(1, 1) / 2, twice(2, 2) / 2, twice(1, 2),
        twice(0, 2), twice(0, 1);
    return strain;
  }
};

/// int r . [v] by quadrature.
double work_of_tractions(const FacingTractions& pair,
                         const QuadraticInSpace& v) {
  const SolidProblem& problem = pair.stack.problem;
  double work = 0;
  for (const FacingPolygon& polygon : problem.surface.polygons) {
    const int face = problem.surface.face[polygon.contact_face];
    const Matrix3d x = problem.mesh.vertices(Eigen::all,
                                             problem.faces.vertices.col(face)),
                   y = problem.mesh.vertices(
                       Eigen::all,
                       problem.faces.vertices.col(polygon.opposite_face));
    const QuadraticOnFace r = along_axes(
        bent_traction(problem.surface, polygon.contact_face, pair.traction));
    for (const FanTriangle& triangle : fan_of(polygon.own))
      for (const TrianglePoint& point : points_of_triangle()) {
        const Vector3d own =
                           polygon.own(Eigen::all, triangle.corner) * point.at,
                       other = polygon.opposite(Eigen::all, triangle.corner) *
                               point.at;
        work += facet_measure(problem.mesh, problem.faces, face) *
                triangle.share * point.weight *
                value_at(r, own).dot(v(x * own) - v(y * other));
      }
  }
  return work;
}

/// That of the linear tractions that stand for them, and |v|^2 on the tetrahedra beside.
struct LinearPart {
  double work = 0, energy = 0;
};
LinearPart linear_part(const FacingTractions& pair, const QuadraticInSpace& v) {
  const SolidProblem& problem = pair.stack.problem;
  const SolidMesh& mesh = problem.mesh;
  const Facets<3>& faces = problem.faces;
  const FaceTractions carried = with_contact(
      {Eigen::Array<bool, 3, Dynamic>::Constant(3, faces.count(), false),
       FaceMoments::Zero(9, faces.count())},
      mesh, faces, problem.surface, pair.traction);
  LinearPart part;
  for (int f = 0; f < faces.count(); ++f) {
    if (!carried.known(0, f)) continue;
    const double area = facet_measure(mesh, faces, f);
    const Matrix3d moments = carried.moments.col(f).reshaped(3, 3),
                   density = facet_density<3>(moments, area),
                   x = mesh.vertices(Eigen::all, faces.vertices.col(f));
    for (const TrianglePoint& point : points_of_triangle())
      part.work +=
          area * point.weight * (density * point.at).dot(v(x * point.at));
    const int t = faces.cells(0, f);
    VoigtVector<3> sum = VoigtVector<3>::Zero();
    double squares = 0;
    for (int k = 0; k < 4; ++k) {
      const VoigtVector<3> strain = v.strain(mesh.corner(t, k));
      squares += strain.dot(pair.hooke[t] * strain);
      sum += strain;
    }
    part.energy +=
        signed_volume(mesh, t) / 20 * (squares + sum.dot(pair.hooke[t] * sum));
  }
  return part;
}

RC_GTEST_PROP(TractionOscillation, bounds_the_work_of_what_is_left,
              (Random random)) {
  const FacingTractions pair(random);
  const QuadraticInSpace v(random);
  const LinearPart linear = linear_part(pair, v);
  const double left = work_of_tractions(pair, v) - linear.work;
  RC_ASSERT(std::abs(left) < pair.oscillation() * std::sqrt(linear.energy));
  RC_ASSERT(std::abs(left) > 1e-12);  // there is something left
}

/// |d|' is |d| h^(1/2) over the root of a modulus.
RC_GTEST_PROP(TractionOscillation, scales_with_lengths_and_moduli,
              (Random random)) {
  FacingTractions pair(random);
  const double expected = pair.oscillation(),
               modulus = std::pow(10, *rc::gen::inRange(-9, 10)),
               length = std::pow(10, *rc::gen::inRange(-9, 10));
  for (auto& C : pair.hooke) C *= modulus;
  pair.stack.problem.mesh.vertices *= length;
  const double found =
      pair.oscillation() / std::sqrt(std::pow(length, 3) / modulus);
  RC_ASSERT(std::abs(found / expected - 1) < 1e-9);
}

/// Of tractions at random.
double oscillation_of(const SolidProblem& problem, std::mt19937& random) {
  const ContactSurface& surface = problem.surface;
  const Matrix3Xd traction = random_matrix(3, surface.node_count(), random);
  return traction_oscillation(
      problem.mesh, problem.faces, surface,
      HookeTensors<3>(problem.mesh.cell_count(), isotropic<3>(2, 1)),
      {traction, tractions_by_face(surface, traction)});
}

TEST(TractionOscillation, is_none_where_faces_match) {
  std::mt19937 random(3);
  const SolidMesh upper = brick({3, 2, 1}, {3, 2, 1});
  SolidMesh lower = upper;
  lower.vertices.row(2).array() -= 1;
  const SolidStack stack({upper, lower}, 0);
  const SolidProblem& problem = stack.problem;
  EXPECT_LT(oscillation_of(problem, random), 1e-14);
}

TEST(TractionOscillation, is_none_on_a_rigid_foundation) {
  std::mt19937 random(3);
  const SolidProblem problem(brick({3, 2, 1}, {3, 2, 1}));
  EXPECT_EQ(oscillation_of(problem, random), 0);
}

}  // namespace
}  // namespace ffcontact
