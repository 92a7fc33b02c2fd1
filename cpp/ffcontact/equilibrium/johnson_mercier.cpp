// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/johnson_mercier.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

namespace {

constexpr int coefficients = 96, loads_on_faces = 36, loads_of_solid = 48;

using SolidStressMap =
    /// corner stresses (column-major 6 x 16) from face and body loads
    Matrix<double, coefficients, loads_of_solid>;

/// The vertices of each edge, and those that are not on it.
constexpr std::array<std::array<int, 4>, 6> edges_of_tetrahedron{
    {{0, 1, 2, 3},
     {0, 2, 1, 3},
     {0, 3, 1, 2},
     {1, 2, 0, 3},
     {1, 3, 0, 2},
     {2, 3, 0, 1}}};

Vector3d barycentre(const TetrahedronCorners& corners) {
  return corners.rowwise().mean();
}

TetrahedronCorners subtetrahedron(const TetrahedronCorners& corners, int k) {
  TetrahedronCorners x;
  for (int j = 0; j < 3; ++j) x.col(j) = corners.col(vertex_of_face(k, j));
  x.col(3) = barycentre(corners);
  return x;
}

/// Gradients of the barycentric coordinates.
TetrahedronCorners gradients(const TetrahedronCorners& corners) {
  const Matrix3d rows = piola_matrix(corners).inverse();
  TetrahedronCorners columns;
  columns << -rows.colwise().sum().transpose(), rows.transpose();
  return columns;
}

/// f on subtetrahedron k from the moments int f phi_i: the mean of phi_i over
/// subtetrahedron k is 1/16 for i = k and 5/16 otherwise.
Matrix4d force_per_body_load(double volume) {
  Matrix4d means = Matrix4d::Constant(5.0 / 16);
  means.diagonal().setConstant(1.0 / 16);
  return (volume / 4 * means).inverse();
}

/// The conditions of the header on the reference tetrahedron, one column for every
/// coefficient: divergences, jumps, moments.
MatrixXd reference_conditions() {
  const TetrahedronCorners corners = reference_tetrahedron();
  MatrixXd conditions(12 + 54 + loads_on_faces, coefficients);
  for (int unit = 0; unit < coefficients; ++unit) {
    SolidStress stress = SolidStress::Zero();
    stress.reshaped()[unit] = 1;
    conditions.col(unit) << divergences(corners, stress).reshaped(),
        inner_jumps(corners, stress).reshaped(),
        face_loads_of(corners, stress).reshaped();
  }
  return conditions;
}

/// What the conditions are equal to for unit loads.
MatrixXd reference_right_sides() {
  MatrixXd right = MatrixXd::Zero(12 + 54 + loads_on_faces, loads_of_solid);
  for (int unit = 0; unit < loads_on_faces; ++unit) right(66 + unit, unit) = 1;
  for (int unit = 0; unit < 12; ++unit) {
    SolidBodyLoads loads = SolidBodyLoads::Zero();
    loads.reshaped()[unit] = 1;
    right.col(loads_on_faces + unit).head<12>() =
        -body_force_of(loads, 1.0 / 6).reshaped();
  }
  return right;
}

const SolidStressMap& reference_solid_map() {
  static const SolidStressMap map =
      least_squares_of_columns(reference_conditions(), reference_right_sides());
  return map;
}

/// Integrals of products of corner values over a subtetrahedron of volume V: V/20 (1 +
/// delta).
double solid_mass(double volume, int a, int b) {
  return volume / (a == b ? 10 : 20);
}

}  // namespace

TetrahedronCorners reference_tetrahedron() {
  TetrahedronCorners corners;
  corners << Vector3d::Zero(), Matrix3d::Identity();
  return corners;
}

TetrahedronCorners face_vectors(const TetrahedronCorners& corners) {
  TetrahedronCorners vectors;
  for (int k = 0; k < 4; ++k) {
    const Matrix3d face = corners(Eigen::all, facet_corners<3>[k]);
    vectors.col(k) = facet_vector(face);
  }
  return vectors;
}

Matrix3d piola_matrix(const TetrahedronCorners& corners) {
  return corners.rightCols<3>().colwise() - corners.col(0);
}

Matrix<double, 6, 6> piola_voigt(const Matrix3d& B) {
  constexpr auto& place = voigt_place<3>;
  Matrix<double, 6, 6> T = Matrix<double, 6, 6>::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          T(place[i][j], place[a][b]) += B(i, a) * B(j, b);
  return T;
}

SolidStress composite_stress(const TetrahedronCorners& corners,
                             const FaceLoads& on_faces,
                             const SolidBodyLoads& body_loads) {
  const Matrix3d B = piola_matrix(corners), inverse = B.inverse();
  Matrix<double, 3, 16> pulled_back;
  pulled_back << inverse * on_faces, inverse * body_loads;
  SolidStress s;
  s.reshaped() = reference_solid_map() * pulled_back.reshaped();
  return piola_voigt(B) / B.determinant() * s;
}

SolidBodyLoads balancing_body_loads(const FaceLoads& on_faces) {
  return (-0.25 * on_faces.rowwise().sum()).replicate<1, 4>();
}

Matrix<double, 3, 4> body_force_of(const SolidBodyLoads& body_loads,
                                   double volume) {
  return body_loads * force_per_body_load(volume).transpose();
}

double energy(const TetrahedronCorners& corners,
              const Matrix<double, 6, 6>& compliance,
              const SolidStress& stress) {
  const double volume = piola_matrix(corners).determinant() / 24;
  const SolidStress strain = compliance * stress;
  double sum = 0;
  for (int k = 0; k < 16; k += 4)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        sum +=
            solid_mass(volume, a, b) * stress.col(k + a).dot(strain.col(k + b));
  return sum;
}

Matrix<double, 3, 4> divergences(const TetrahedronCorners& corners,
                                 const SolidStress& stress) {
  Matrix<double, 3, 4> result = Matrix<double, 3, 4>::Zero();
  for (int k = 0; k < 4; ++k) {
    const TetrahedronCorners slope = gradients(subtetrahedron(corners, k));
    for (int c = 0; c < 4; ++c)
      result.col(k) += traction(stress.col(4 * k + c), slope.col(c));
  }
  return result;
}

Matrix<double, 3, 18> inner_jumps(const TetrahedronCorners& corners,
                                  const SolidStress& stress) {
  Matrix<double, 3, 18> jumps;
  for (int e = 0; e < 6; ++e) {
    const auto [i, j, k, l] = edges_of_tetrahedron[e];
    Matrix3d face;
    face << corners.col(i), corners.col(j), barycentre(corners);
    const Vector3d n = facet_vector(face).normalized();
    const std::array<int, 3> in_k{place_on_face(k, i), place_on_face(k, j), 3},
        in_l{place_on_face(l, i), place_on_face(l, j), 3};
    for (int c = 0; c < 3; ++c)
      jumps.col(3 * e + c) = traction(
          stress.col(4 * k + in_k[c]) - stress.col(4 * l + in_l[c]), n);
  }
  return jumps;
}

FaceLoads face_loads_of(const TetrahedronCorners& corners,
                        const SolidStress& stress) {
  const TetrahedronCorners vectors = face_vectors(corners);
  FaceLoads loads;
  for (int k = 0; k < 4; ++k) {
    Matrix3d density;
    for (int j = 0; j < 3; ++j)
      density.col(j) = traction(stress.col(4 * k + j), vectors.col(k));
    loads.middleCols<3>(3 * k) = face_moments_of(density, 1);
  }
  return loads;
}

Matrix3d face_density(const Matrix3d& moments, double area) {
  const Vector3d quarter = 0.25 * moments.rowwise().sum();
  return 12 / area * (moments.colwise() - quarter);
}

Matrix3d face_moments_of(const Matrix3d& density, double area) {
  const Vector3d sum = density.rowwise().sum();
  return area / 12 * (density.colwise() + sum);
}

}  // namespace ffcontact
