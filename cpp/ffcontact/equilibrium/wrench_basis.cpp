// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/wrench_basis.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "ffcontact/equilibrium/face_tractions.hpp"

namespace ffcontact {

namespace {

Matrix3d corners_of_face(const SolidTopology& topology, int face) {
  return facet_points<3>(topology.mesh, topology.faces.vertices.col(face));
}

double size_of_face(const Matrix3d& corners) {
  return std::sqrt(facet_vector(corners).norm());
}

}  // namespace

Matrix3d cross_product_with(const Vector3d& a) {
  Matrix3d matrix;
  matrix << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return matrix;
}

Matrix9d wrench_basis(const Matrix3d& corners) {
  const Matrix3d arms = (corners.colwise() - corners.rowwise().mean().eval()) /
                        size_of_face(corners);
  // W W', whose blocks of forces with moments are 0 about the centroid: 3 I and J
  const Matrix3d J = arms.squaredNorm() * Matrix3d::Identity() -
                     arms * arms.transpose(),
                 inverse = J.inverse();
  Matrix9d V = Matrix9d::Zero();
  for (int i = 0; i < 3; ++i) {
    V.block<3, 3>(3 * i, 0).diagonal().setConstant(1.0 / 3);
    V.block<3, 3>(3 * i, 3) = -cross_product_with(arms.col(i)) * inverse;
  }
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const Vector3d along = (corners.col(b) - corners.col(a)).normalized();
    V.col(6 + k).segment<3>(3 * a) = -along;
    V.col(6 + k).segment<3>(3 * b) = along;
  }
  return V;
}

Matrix6d WrenchShift::matrix() const {
  Matrix6d shift;
  for (int k = 0; k < 6; ++k) shift.col(k) = times(Vector6d::Unit(k));
  return shift;
}

WrenchShift wrench_shift(const SolidTopology& topology, int face, int edge) {
  const auto vertices = topology.faces.vertices.col(face);
  const Vector2i ends = topology.edges.vertices.col(edge);
  const Matrix3d corners = corners_of_face(topology, face);
  const int first = place_of(topology.faces, face, ends[0]);
  // a face runs counter-clockwise as seen from where its normal points to
  const double sign = vertices[(first + 1) % 3] == ends[1] ? 1 : -1;

  const auto& [mesh, faces, edges, stars] = topology;
  const Vector3d arm =
      corners.rowwise().mean() - edge_middle(mesh, edges, edge);
  const double size = size_of_face(corners),
               length = edge_vector(mesh, edges, edge).norm();
  return {arm / size, length / size, sign};
}

WrenchShift balancing_shift(const SolidTopology& topology, int cell, int k,
                            int d) {
  const Facets<3>& faces = topology.faces;
  const Matrix3d given = corners_of_face(topology, faces.of_cell(k, cell)),
                 other = corners_of_face(topology, faces.of_cell(d, cell));
  const double size = size_of_face(other);
  return {(other.rowwise().mean() - given.rowwise().mean()) / size,
          size_of_face(given) / size, -faces.eta(k, cell) * faces.eta(d, cell)};
}

std::array<Matrix9d, 4> wrench_bases(const SolidTopology& topology, int cell) {
  const auto& [mesh, faces, edges, stars] = topology;
  std::array<Matrix9d, 4> bases;
  for (int k = 0; k < 4; ++k) {
    const int face = faces.of_cell(k, cell);
    const Matrix9d V =
        faces.eta(k, cell) * wrench_basis(corners_of_face(topology, face));
    for (int j = 0; j < 3; ++j) {
      const int vertex = mesh.cells(vertex_of_face(k, j), cell);
      bases[k].middleRows<3>(3 * j) =
          V.middleRows<3>(3 * place_of(faces, face, vertex));
    }
  }
  return bases;
}

}  // namespace ffcontact
