// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/rigid_motions.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/linear/dense/symmetric_eigen.hpp"

namespace ffcontact {

namespace {

using Vertices = std::vector<int>;

int root(std::vector<int>& parent, int v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

void join(std::vector<int>& parent, int v, int w) {
  parent[root(parent, v)] = root(parent, w);
}

/// For each vertex one of its part, the same for all of them; -1 where it has no cell.
template <int dim>
std::vector<int> roots_of(const SimplexMesh<dim>& mesh) {
  std::vector<int> parent(mesh.vertex_count()), roots(mesh.vertex_count(), -1);
  std::iota(parent.begin(), parent.end(), 0);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < dim; ++k)
      join(parent, mesh.cells(k, t), mesh.cells(k + 1, t));
  for (const int v : mesh.cells.reshaped()) roots[v] = root(parent, v);
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
struct Frame {
  using Point = VectorOf<dim>;
  Point centre;
  double radius;

  /// The rigid motions at a point: along the axes, and around them through the centre.
  Matrix<double, dim, motion_count<dim>> motions_at(const Point& x) const {
    const Point r = (x - centre) / radius;
    Matrix<double, dim, motion_count<dim>> motions;
    motions << MatrixOf<dim>::Identity(), rotations<dim>(r);
    return motions;
  }
};

template <int dim>
Frame<dim> frame_of(const SimplexMesh<dim>& mesh, const Vertices& part) {
  Frame<dim> frame{Frame<dim>::Point::Zero(), 0};
  auto& [centre, radius] = frame;
  for (int v : part)
    centre += mesh.vertices.col(v) / static_cast<double>(part.size());
  for (int v : part)
    radius = std::max(radius, (mesh.vertices.col(v) - centre).norm());
  return frame;
}

template <int dim>
using MotionMatrix = Matrix<double, motion_count<dim>, motion_count<dim>>;

/// Sum of the squares of what the motions do to the prescribed dofs of a part.
template <int dim>
MotionMatrix<dim> stopped(const SimplexMesh<dim>& mesh, const Vertices& part,
                          const Frame<dim>& frame, const Flags& prescribed) {
  MotionMatrix<dim> sum = MotionMatrix<dim>::Zero();
  for (int v : part)
    for (int c = 0; c < dim; ++c) {
      if (!prescribed[dof_of<dim>(v, c)]) continue;
      const auto motions = frame.motions_at(mesh.vertices.col(v));
      for (int i = 0; i < motion_count<dim>; ++i)
        for (int j = 0; j < motion_count<dim>; ++j)
          sum(i, j) += motions(c, i) * motions(c, j);
    }
  return sum;
}

/// How many of the ascending eigenvalues of `stopped` belong to free motions: these are
/// 1e-5 of the largest on all prescribed dofs, and the eigenvalues are sums of squares.
Index vanishing(const VectorXd& values) {
  const double threshold = 1e-10 * std::max(values[values.size() - 1], 1.0);
  return std::upper_bound(values.begin(), values.end(), threshold) -
         values.begin();
}

/// Coefficients of the combinations of the motions that vanish on the prescribed dofs.
/// @param squares  stopped
template <int dim>
MatrixXd unstopped(const MotionMatrix<dim>& squares) {
  const SymmetricEigen eigen = symmetric_eigen(squares);
  return eigen.vectors.leftCols(vanishing(eigen.values));
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

/// The turn of a motion whose centre and shift are known, by least squares, which for a
/// rigid motion leave nothing: J turn = sum r x (u - shift) with
/// J = sum |r|^2 I - r r', r = x - centre.
template <int dim>
Vector3d turn_of(const SimplexMesh<dim>& mesh, const Vertices& part,
                 const Ref<const VectorXd>& field, const Motion& motion) {
  Matrix3d J = Matrix3d::Zero();
  Vector3d moment = Vector3d::Zero();
  for (int v : part) {
    const Vector3d r = in_space(mesh.vertices.col(v)) - motion.centre;
    const Vector3d u = in_space(vector_at<dim>(field, v)) - motion.shift;
    J += r.squaredNorm() * Matrix3d::Identity() - r * r.transpose();
    moment += r.cross(u);
  }
  return J.inverse() * moment;
}

template <int dim>
Motion motion_of(const SimplexMesh<dim>& mesh, const Vertices& part,
                 const Ref<const VectorXd>& field) {
  const Frame<dim> frame = frame_of(mesh, part);
  Motion motion;
  motion.centre = in_space(frame.centre);
  motion.radius = frame.radius;
  for (int v : part)
    motion.shift +=
        in_space(vector_at<dim>(field, v)) / static_cast<double>(part.size());
  motion.turn = turn_of(mesh, part, field, motion);
  return motion;
}

double without_rounding(double x) { return std::abs(x) < 1e-9 ? 0 : x; }

template <int dim>
std::string components_in_words(const Vector3d& v) {
  return in_words(v.head<dim>().unaryExpr(&without_rounding),
                  digits_of_figures);
}

/// ", 3 mm a turn", or nothing where the axis stays where it is.
std::string pitch_in_words(const Motion& motion) {
  if (std::abs(motion.pitch()) < 1e-6 * motion.radius) return "";
  return ", " + in_digits(motion.pitch()) + " mm a turn";
}

template <int dim>
std::string rotation_in_words(const Motion& motion, const Vector3d& origin) {
  const std::string point =
      components_in_words<dim>(origin + motion.axis_point());
  if (dim == 2) return "rotation about " + point;
  const std::string axis = components_in_words<dim>(motion.turn.normalized());
  return "rotation about " + axis + " through " + point +
         pitch_in_words(motion);
}

/// The first part that a motion moves.
template <int dim>
Vertices moving_part(const SimplexMesh<dim>& mesh,
                     const Ref<const VectorXd>& motion) {
  for (const Vertices& part : connected_parts(mesh))
    if (moves<dim>(part, motion)) return part;
  return {};
}

}  // namespace

template <int dim>
MatrixXd free_rigid_motions(const SimplexMesh<dim>& mesh,
                            const Flags& prescribed) {
  MatrixXd basis(dim * mesh.vertices.cols(), 0);
  for (const Vertices& part : connected_parts(mesh)) {
    const Frame<dim> frame = frame_of(mesh, part);
    const MatrixXd combinations =
        unstopped<dim>(stopped(mesh, part, frame, prescribed));
    const Index first = basis.cols(), more = combinations.cols();
    if (more == 0) continue;
    basis.conservativeResize(Eigen::NoChange, first + more);
    basis.rightCols(more).setZero();
    for (int v : part)
      basis.block(dof_of<dim>(v, 0), first, dim, more) =
          frame.motions_at(mesh.vertices.col(v)).lazyProduct(combinations);
  }
  return basis;
}

template <int dim>
std::string motion_in_words(const SimplexMesh<dim>& mesh,
                            const Ref<const VectorXd>& motion) {
  const Vertices part = moving_part(mesh, motion);
  const Motion rigid = motion_of(mesh, part, motion);
  if (rigid.turns())
    return rotation_in_words<dim>(rigid, in_space(mesh.origin));
  return "translation along " +
         components_in_words<dim>(rigid.shift.normalized());
}

template MatrixXd free_rigid_motions(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                     const Flags&);
template std::string motion_in_words(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                     const Ref<const VectorXd>&);

}  // namespace ffcontact
