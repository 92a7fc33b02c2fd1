// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <vector>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/energy/facet_energy.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/mesh/topology.hpp"
#include "support/cells.hpp"
#include "support/solids.hpp"

namespace ffcontact::test {

/// The regular tetrahedron of edge 1 in k^3 tetrahedra, label high_x on one of its faces
/// in k^2 triangles: those of a brick that lie on one monotone path, moved by a linear
/// map.
inline SolidMesh divided_tetrahedron(int k) {
  const SolidMesh cube = brick({k, k, k}, {1, 1, 1});
  SolidMesh mesh;
  mesh.vertices = cube.vertices;
  mesh.cells.resize(4, k * k * k);
  int next = 0;
  for (int t = 0; t < cube.cell_count(); ++t) {
    const Vector3d middle =
        cube.vertices(Eigen::all, cube.cells.col(t)).rowwise().mean();
    if (middle.x() > middle.y() && middle.y() > middle.z())
      mesh.cells.col(next++) = cube.cells.col(t);
  }
  add_boundary(mesh);
  for (Index f = 0; f < mesh.boundary.cols(); ++f) {
    const Matrix3d corners = mesh.vertices(Eigen::all, mesh.boundary.col(f));
    mesh.boundary_label[f] = corners.row(0).minCoeff() == 1 ? high_x : 0;
  }
  Matrix3d path, edges;
  path << 1, 1, 1, 0, 1, 1, 0, 0, 1;
  edges << 1, 0.5, 0.5,                         //
      0, std::sqrt(0.75), std::sqrt(0.75) / 3,  //
      0, 0, std::sqrt(2.0 / 3);
  mesh.vertices = edges * path.inverse() * mesh.vertices;
  return mesh;
}

/// The least energy |tau|^2 (Frobenius) of stresses on a mesh in equilibrium with linear
/// tractions on the faces of one label and none on the others.
class LeastStress {
 public:
  LeastStress(const SolidMesh& mesh, int label)
      : topology_(topology_of(mesh)), first_(topology_.facets.count(), -1) {
    const Facets<3>& faces = topology_.facets;
    for (int f = 0; f < faces.count(); ++f)
      if (!faces.on_boundary(f)) first_[f] = 9 * inner_++;
    for (int f = 0; f < faces.count(); ++f)
      if (faces.on_boundary(f) &&
          mesh.boundary_label[faces.boundary_index[f]] == label) {
        first_[f] = 9 * (inner_ + static_cast<int>(loaded_.size()));
        loaded_.push_back(f);
      }
    assemble();
  }

  /// max over tractions orthogonal to linear functions of |tau|^2 / |d|^2.
  double largest_ratio() const {
    const Index n = 9 * inner_, m = energy_.cols() - n;
    const MatrixXd d = oscillations();
    // + balance' balance changes nothing where balance is 0
    const MatrixXd H = energy_ + balance_.transpose() * balance_;
    const Eigen::LLT<MatrixXd> inner(H.topLeftCorner(n, n));
    const MatrixXd A = balance_.leftCols(n),
                   free = -inner.solve(H.topRightCorner(n, m) * d),
                   reach = inner.solve(A.transpose());
    const MatrixXd off = A * free + balance_.rightCols(m) * d;
    // rigid motions of the whole make six rows of the balance redundant
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> balance;
    balance.setThreshold(1e-9);
    const MatrixXd multipliers = balance.compute(A * reach).solve(off);
    MatrixXd x(n + m, d.cols());
    x << free - reach * multipliers, d;
    const MatrixXd E = x.transpose() * energy_ * x,
                   G = d.transpose() * mass() * d;
    return Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(
               0.5 * (E + E.transpose()), G)
        .eigenvalues()
        .maxCoeff();
  }

 private:
  void assemble() {
    const SolidMesh& mesh = topology_.mesh;
    const Index size = 9 * (inner_ + static_cast<Index>(loaded_.size()));
    energy_ = MatrixXd::Zero(size, size);
    balance_ = MatrixXd::Zero(6 * mesh.cells.cols(), size);
    std::array<Matrix9d, 4> basis;
    basis.fill(Matrix9d::Identity());
    const Matrix<double, 6, 6> compliance = isotropic<3>(0, 0.5).inverse();
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const CellCorners<3> corners = corners_of(mesh, t);
      const MatrixXd loads = loads_by_unknowns(t, size);
      energy_ += loads.transpose() *
                 facet_energy<3>(corners, compliance, basis) * loads;
      balance_.middleRows<6>(6 * t) =
          balance_conditions(corners).leftCols<36>() * loads;
    }
  }

  /// FacetLoads<3> of a tetrahedron [36 x unknowns].
  MatrixXd loads_by_unknowns(int t, Index size) const {
    const auto& [mesh, faces, edges, stars] = topology_;
    MatrixXd loads = MatrixXd::Zero(36, size);
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 3; ++j) {
        const int face = faces.of_cell(k, t),
                  vertex = mesh.cells(vertex_of_facet<3>(k, j), t);
        if (first_[face] < 0) continue;
        const int column = first_[face] + 3 * faces.place_of(vertex, face);
        loads.block<3, 3>(9 * k + 3 * j, column) =
            faces.eta(k, t) * Matrix3d::Identity();
      }
    return loads;
  }

  /// |d|^2 of the moments on the loaded faces.
  MatrixXd mass() const {
    MatrixXd mass = MatrixXd::Zero(9 * loaded_.size(), 9 * loaded_.size());
    for (std::size_t f = 0; f < loaded_.size(); ++f) {
      const double area =
          facet_measure(topology_.mesh, topology_.facets, loaded_[f]);
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          mass.block<3, 3>(9 * f + 3 * a, 9 * f + 3 * b) =
              12 / area * (a == b ? 0.75 : -0.25) * Matrix3d::Identity();
    }
    return mass;
  }

  /// Moments of tractions that are orthogonal to 1 and the coordinates.
  MatrixXd oscillations() const {
    const auto& [mesh, faces, edges, stars] = topology_;
    MatrixXd products(9, 9 * loaded_.size());
    for (std::size_t f = 0; f < loaded_.size(); ++f)
      for (int a = 0; a < 3; ++a) {
        const Vector3d x = mesh.vertices.col(faces.vertices(a, loaded_[f]));
        const Vector3d linear(1, x.y(), x.z());
        for (int g = 0; g < 3; ++g)
          products.block<3, 3>(3 * g, 9 * f + 3 * a) =
              linear[g] * Matrix3d::Identity();
      }
    return products.fullPivLu().kernel();
  }

  Topology<3> topology_;
  std::vector<int> first_, loaded_;
  int inner_ = 0;
  MatrixXd energy_, balance_;
};

}  // namespace ffcontact::test
