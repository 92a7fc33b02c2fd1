// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/rigid_motions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

using Vertices = std::vector<int>;

int root(std::vector<int>& parent, int v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

/// For each vertex one of its part, the same for all of them; -1 where it has no cell.
template <int dim>
std::vector<int> roots_of(const SimplexMesh<dim>& mesh) {
  std::vector<int> parent(mesh.vertex_count()), roots(mesh.vertex_count(), -1);
  std::iota(parent.begin(), parent.end(), 0);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < dim; ++k)
      parent[root(parent, mesh.cells(k, t))] =
          root(parent, mesh.cells(k + 1, t));
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (const int v : mesh.cells.col(t)) roots[v] = root(parent, v);
  return roots;
}

/// Vertices of each connected part that has cells.
template <int dim>
std::vector<Vertices> connected_parts(const SimplexMesh<dim>& mesh) {
  const std::vector<int> roots = roots_of(mesh);
  std::vector<int> part_of(mesh.vertex_count(), -1);
  std::vector<Vertices> parts;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (roots[v] < 0) continue;
    int& part = part_of[roots[v]];
    if (part < 0) {
      part = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    parts[part].push_back(v);
  }
  return parts;
}

template <int dim>
constexpr int motion_count = dim*(dim + 1) / 2;

/// The rotations about the axes at r, one column each: e_z x r in the plane.
Vector2d rotations(const Vector2d& r) { return {-r.y(), r.x()}; }
Matrix3d rotations(const Vector3d& r) {
  Matrix3d result;
  for (int k = 0; k < 3; ++k) result.col(k) = Vector3d::Unit(k).cross(r);
  return result;
}

template <int dim>
struct Frame {
  using Point = Matrix<double, dim, 1>;
  Point centre;
  double radius;

  /// The rigid motions at a point: along the axes, and around them through the centre.
  Matrix<double, dim, motion_count<dim>> motions_at(const Point& x) const {
    const Point r = (x - centre) / radius;
    Matrix<double, dim, motion_count<dim>> motions;
    motions << Matrix<double, dim, dim>::Identity(), rotations(r);
    return motions;
  }
};

template <int dim>
Frame<dim> frame_of(const SimplexMesh<dim>& mesh, const Vertices& part) {
  Matrix<double, dim, 1> centre = Matrix<double, dim, 1>::Zero();
  for (int v : part)
    centre += mesh.vertices.col(v) / static_cast<double>(part.size());
  double radius = 0;
  for (int v : part)
    radius = std::max(radius, (mesh.vertices.col(v) - centre).norm());
  return {centre, radius};
}

/// Sum of the squares of what the motions do to the prescribed dofs of a part.
template <int dim>
Matrix<double, motion_count<dim>, motion_count<dim>> stopped(
    const SimplexMesh<dim>& mesh, const Vertices& part, const Frame<dim>& frame,
    const std::vector<char>& prescribed) {
  Matrix<double, motion_count<dim>, motion_count<dim>> sum;
  sum.setZero();
  for (int v : part)
    for (int c = 0; c < dim; ++c) {
      if (!prescribed[dof_of<dim>(v, c)]) continue;
      const auto row = frame.motions_at(mesh.vertices.col(v)).row(c).eval();
      sum += row.transpose() * row;
    }
  return sum;
}

/// Coefficients of the combinations of the motions that vanish on the prescribed dofs.
template <int dim>
MatrixXd unstopped(const SimplexMesh<dim>& mesh, const Vertices& part,
                   const Frame<dim>& frame,
                   const std::vector<char>& prescribed) {
  const auto squares = stopped(mesh, part, frame, prescribed);
  // eigenvalues ascending
  const Eigen::SelfAdjointEigenSolver<std::decay_t<decltype(squares)>> eigen(
      squares);
  const auto& values = eigen.eigenvalues();
  // A motion is free when it is 1e-5 of the largest on all prescribed dofs; the
  // eigenvalues are sums of squares.
  const double threshold = 1e-10 * std::max(values[motion_count<dim> - 1], 1.0);
  int free = 0;
  while (free < motion_count<dim> && values[free] <= threshold) ++free;
  return eigen.eigenvectors().leftCols(free);
}

/// A rigid motion in space, or in the plane z = 0: u(x) = shift + turn x (x - centre).
struct Motion {
  Vector3d centre = Vector3d::Zero(), shift = Vector3d::Zero(),
           turn = Vector3d::Zero();
  double radius = 0;  ///< of the body

  bool turns() const { return turn.norm() * radius > 1e-6 * shift.norm(); }
  Vector3d axis_point() const {
    return centre + turn.cross(shift) / turn.squaredNorm();
  }
  /// Along the axis, by a full turn.
  double pitch() const {
    return 2 * M_PI * turn.dot(shift) / turn.squaredNorm();
  }
};

template <class Vector>
Vector3d in_space(const Vector& v) {
  Vector3d result = Vector3d::Zero();
  result.head(v.size()) = v;
  return result;
}

template <int dim>
bool moves(const Vertices& part, const Ref<const VectorXd>& motion) {
  return std::any_of(part.begin(), part.end(), [&](int v) {
    return !vector_at<dim>(motion, v).isZero(0);
  });
}

/// By least squares, which for a rigid motion leave nothing: J turn = sum r x (u - shift)
/// with J = sum |r|^2 I - r r', r = x - centre.
template <int dim>
Motion motion_of(const SimplexMesh<dim>& mesh, const Vertices& part,
                 const Ref<const VectorXd>& field) {
  Motion motion;
  const Frame<dim> frame = frame_of(mesh, part);
  motion.centre = in_space(frame.centre);
  motion.radius = frame.radius;
  for (int v : part)
    motion.shift +=
        in_space(vector_at<dim>(field, v)) / static_cast<double>(part.size());

  Matrix3d J = Matrix3d::Zero();
  Vector3d moment = Vector3d::Zero();
  for (int v : part) {
    const Vector3d r = in_space(mesh.vertices.col(v)) - motion.centre;
    const Vector3d u = in_space(vector_at<dim>(field, v)) - motion.shift;
    J += r.squaredNorm() * Matrix3d::Identity() - r * r.transpose();
    moment += r.cross(u);
  }
  motion.turn = J.inverse() * moment;
  return motion;
}

/// "(0, 1)": without the noise of rounding.
template <int dim>
std::string in_words(const Vector3d& v) {
  std::ostringstream words;
  words.precision(4);
  for (int c = 0; c < dim; ++c)
    words << (c == 0 ? "(" : ", ") << (std::abs(v[c]) < 1e-9 ? 0.0 : v[c]);
  return words.str() + ")";
}

/// ", 3 mm a turn", or nothing where the axis stays where it is.
std::string pitch_in_words(const Motion& motion) {
  if (std::abs(motion.pitch()) < 1e-6 * motion.radius) return "";
  std::ostringstream words;
  words.precision(4);
  words << ", " << motion.pitch() << " mm a turn";
  return words.str();
}

}  // namespace

template <int dim>
MatrixXd free_rigid_motions(const SimplexMesh<dim>& mesh,
                            const std::vector<char>& prescribed) {
  MatrixXd basis(dim * mesh.vertices.cols(), 0);
  for (const Vertices& part : connected_parts(mesh)) {
    const Frame<dim> frame = frame_of(mesh, part);
    const MatrixXd combinations = unstopped(mesh, part, frame, prescribed);
    const Index first = basis.cols(), more = combinations.cols();
    if (more == 0) continue;
    basis.conservativeResize(Eigen::NoChange, first + more);
    basis.rightCols(more).setZero();
    for (int v : part)
      basis.block(dof_of<dim>(v, 0), first, dim, more) =
          frame.motions_at(mesh.vertices.col(v)) * combinations;
  }
  return basis;
}

template <int dim>
std::string motion_in_words(const SimplexMesh<dim>& mesh,
                            const Ref<const VectorXd>& motion) {
  const std::vector<Vertices> parts = connected_parts(mesh);
  const auto part = std::find_if(
      parts.begin(), parts.end(),
      [&](const Vertices& each) { return moves<dim>(each, motion); });
  const Motion rigid = motion_of(mesh, *part, motion);
  if (!rigid.turns())
    return "translation along " + in_words<dim>(rigid.shift.normalized());
  const std::string point =
      in_words<dim>(in_space(mesh.origin) + rigid.axis_point());
  if (dim == 2) return "rotation about " + point;
  return "rotation about " + in_words<dim>(rigid.turn.normalized()) +
         " through " + point + pitch_in_words(rigid);
}

template MatrixXd free_rigid_motions(const Mesh&, const std::vector<char>&);
template MatrixXd free_rigid_motions(const SolidMesh&,
                                     const std::vector<char>&);
template std::string motion_in_words(const Mesh&, const Ref<const VectorXd>&);
template std::string motion_in_words(const SolidMesh&,
                                     const Ref<const VectorXd>&);

}  // namespace ffcontact
