// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/rigid_motions.hpp"

#include <Eigen/Eigenvalues>
#include <numeric>
#include <sstream>

namespace ffcontact {

namespace {

int root(std::vector<int>& parent, int v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

/// Vertices of each connected part that has triangles.
std::vector<std::vector<int>> connected_parts(const Mesh& mesh) {
  std::vector<int> parent(mesh.vertex_count()), part_of(mesh.vertex_count(), -1);
  std::iota(parent.begin(), parent.end(), 0);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 2; ++k)
      parent[root(parent, mesh.cells(k, t))] = root(parent, mesh.cells(k + 1, t));
  std::vector<char> used(mesh.vertex_count(), 0);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) used[mesh.cells(k, t)] = 1;

  std::vector<std::vector<int>> parts;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (!used[v]) continue;
    int& part = part_of[root(parent, v)];
    if (part < 0) {
      part = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    parts[part].push_back(v);
  }
  return parts;
}

struct Frame {
  Vector2d centre;
  double radius;
  /// The three rigid motions at a point: along x, along y, around the centre.
  Matrix<double, 2, 3> motions_at(const Vector2d& x) const {
    const Vector2d r = (x - centre) / radius;
    Matrix<double, 2, 3> motions;
    motions << 1, 0, -r.y(), 0, 1, r.x();
    return motions;
  }
};

Frame frame_of(const Mesh& mesh, const std::vector<int>& part) {
  Vector2d centre = Vector2d::Zero();
  for (int v : part) centre += mesh.vertices.col(v) / static_cast<double>(part.size());
  double radius = 0;
  for (int v : part) radius = std::max(radius, (mesh.vertices.col(v) - centre).norm());
  return {centre, radius};
}

/// Coefficients of the combinations of the three motions that vanish on the prescribed
/// dofs.
MatrixXd unstopped(const Mesh& mesh, const std::vector<int>& part, const Frame& frame,
                   const std::vector<char>& prescribed) {
  Matrix3d normal_matrix = Matrix3d::Zero();
  for (int v : part)
    for (int c = 0; c < 2; ++c)
      if (prescribed[2 * v + c]) {
        const Vector3d row = frame.motions_at(mesh.vertices.col(v)).row(c);
        normal_matrix += row * row.transpose();
      }
  // eigenvalues ascending
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(normal_matrix);
  // A motion is free when it is 1e-5 of the largest on all prescribed dofs; the
  // eigenvalues are sums of squares.
  const double threshold = 1e-10 * std::max(eigen.eigenvalues()[2], 1.0);
  int free = 0;
  while (free < 3 && eigen.eigenvalues()[free] <= threshold) ++free;
  return eigen.eigenvectors().leftCols(free);
}

}  // namespace

MatrixXd free_rigid_motions(const Mesh& mesh, const std::vector<char>& prescribed) {
  MatrixXd basis(2 * mesh.vertices.cols(), 0);
  for (const std::vector<int>& part : connected_parts(mesh)) {
    const Frame frame = frame_of(mesh, part);
    const MatrixXd combinations = unstopped(mesh, part, frame, prescribed);
    const Index first = basis.cols();
    if (combinations.cols() == 0) continue;
    basis.conservativeResize(Eigen::NoChange, first + combinations.cols());
    basis.rightCols(combinations.cols()).setZero();
    for (int v : part)
      basis.block(2 * v, first, 2, combinations.cols()) =
          frame.motions_at(mesh.vertices.col(v)) * combinations;
  }
  return basis;
}

std::string motion_in_words(const Mesh& mesh, const Ref<const VectorXd>& motion) {
  // A rigid motion is an affine field: two vertices that move differently tell the
  // rotation, otherwise it is a translation.
  const double largest = motion.cwiseAbs().maxCoeff();
  std::vector<int> moving;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (motion.segment<2>(2 * v).cwiseAbs().maxCoeff() > 0) moving.push_back(v);
  const int a = moving.front();
  int b = a;
  for (int v : moving)
    if ((mesh.vertices.col(v) - mesh.vertices.col(a)).norm() >
        (mesh.vertices.col(b) - mesh.vertices.col(a)).norm())
      b = v;

  const Vector2d u_a = motion.segment<2>(2 * a),
                 arm = mesh.vertices.col(b) - mesh.vertices.col(a);
  const Vector2d difference = motion.segment<2>(2 * b) - u_a;
  const double rotation =
      arm.norm() > 0
          ? (arm.x() * difference.y() - arm.y() * difference.x()) / arm.squaredNorm()
          : 0;
  const auto rounded = [](double x) { return std::abs(x) < 1e-9 ? 0.0 : x; };
  std::ostringstream words;
  words.precision(4);
  if (std::abs(rotation) * arm.norm() < 1e-6 * largest) {
    const Vector2d direction = u_a.normalized();
    words << "translation along (" << rounded(direction.x()) << ", "
          << rounded(direction.y()) << ")";
  } else {
    const Vector2d centre = mesh.vertices.col(a) + Vector2d(-u_a.y(), u_a.x()) / rotation;
    words << "rotation about (" << rounded(mesh.origin.x() + centre.x()) << ", "
          << rounded(mesh.origin.y() + centre.y()) << ")";
  }
  return words.str();
}

}  // namespace ffcontact
