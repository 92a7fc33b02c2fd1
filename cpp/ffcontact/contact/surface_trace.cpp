// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/surface_trace.hpp"

#include <Eigen/LU>
#include <map>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

/// Rows that free axes move by less than this are moved by others.
constexpr double moved_by_axes = 1e-3;

using Directions = Matrix<double, 3, Dynamic>;

/// How a vertex moves: displacement = directions w, its components w, which are v of the
/// primary rows, numbered from `column` on.
struct Motion {
  int column;
  Directions directions;
};

Directions free_directions(int vertex, const std::vector<char>& prescribed) {
  std::vector<Vector3d> axes;
  for (int c = 0; c < 3; ++c)
    if (!prescribed[dof_of<3>(vertex, c)]) axes.push_back(Vector3d::Unit(c));
  return packed(axes);
}

/// The components of a frame that free axes move, as many as these are, the normal one
/// first: what is left of a component without those before must move.
std::vector<int> moved_components(const Matrix3d& frame,
                                  const Directions& axes) {
  Matrix3d left = axes * (axes.transpose() * frame);
  std::vector<int> found;
  const auto take = [&](int c) {
    const Vector3d unit = left.col(c).normalized();
    left -= unit * (unit.transpose() * left);
    found.push_back(c);
  };
  if (axes.cols() > 0 && left.col(0).norm() > moved_by_axes) take(0);
  while (static_cast<Index>(found.size()) < axes.cols()) {
    const bool first = left.col(1).norm() >= left.col(2).norm();
    take(first ? 1 : 2);
  }
  return found;
}

/// Vertices, components and rows as they are met.
class TraceBuilder {
 public:
  TraceBuilder(const ContactSurface& surface,
               const std::vector<char>& prescribed)
      : surface_(surface), prescribed_(prescribed) {
    held_.assign(3 * surface.node_count(), 1);
    for (int i = 0; i < surface.node_count(); ++i) add_node(i);
  }

  SurfaceTrace trace(const std::vector<int>& kept) && {
    SurfaceTrace result;
    result.trace.dimension = 3;
    result.trace.kept_dofs = kept;
    result.trace.A = packed(3 * surface_.node_count(), components_, entries_);
    result.trace.to_kept = to_kept(kept);
    result.primary = std::move(primary_);
    result.held = std::move(held_);
    return result;
  }

 private:
  void add_node(int node) {
    const int vertex = surface_.vertex[node];
    const Matrix3d frame = surface_.frame(node);
    const Directions axes = free_directions(vertex, prescribed_);
    const std::vector<int> rows = moved_components(frame, axes);
    const Directions moving = frame(Eigen::all, rows);
    const auto [found, is_first] =
        motions_.emplace(vertex, Motion{components_, with_unit(moving, axes)});
    if (is_first) {
      components_ += static_cast<int>(axes.cols());
      for (int c : rows) primary_.push_back(3 * node + c);
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      held_[3 * node + rows[k]] = 0;
      if (is_first)
        entries_.emplace_back(3 * node + rows[k], found->second.column + k, 1);
      else
        add_row(3 * node + rows[k], moving.col(k), found->second);
    }
  }

  /// The displacements along free axes that have the components 1, one after the other,
  /// along as many directions.
  static Directions with_unit(const Directions& moving,
                              const Directions& axes) {
    if (axes.cols() == 3) return moving;  // orthonormal
    return axes * (moving.transpose() * axes).inverse();
  }

  void add_row(int row, const Vector3d& direction, const Motion& motion) {
    const Directions& axes = motion.directions;
    for (Index k = 0; k < axes.cols(); ++k)
      entries_.emplace_back(row, motion.column + k, direction.dot(axes.col(k)));
  }

  SparseMatrix to_kept(const std::vector<int>& kept) const {
    Triplets entries;
    for (int k = 0; k < count_of(kept); ++k) {
      const Motion& motion = motions_.at(kept[k] / 3);
      for (Index j = 0; j < motion.directions.cols(); ++j)
        entries.emplace_back(k, motion.column + j,
                             motion.directions(kept[k] % 3, j));
    }
    return packed(count_of(kept), components_, entries);
  }

  const ContactSurface& surface_;
  const std::vector<char>& prescribed_;
  std::map<int, Motion> motions_;
  std::vector<int> primary_;
  std::vector<char> held_;
  Triplets entries_;
  int components_ = 0;
};

}  // namespace

SurfaceTrace surface_trace(const ContactSurface& surface, const SurfaceLaw& law,
                           const ElasticSystem& system) {
  const std::vector<int> vertices(surface.vertex.begin(), surface.vertex.end());
  SurfaceTrace result = TraceBuilder(surface, system.prescribed)
                            .trace(free_dofs_at(vertices, system));
  if (result.primary.empty())
    refuse("every dof of the contact surface is prescribed");
  result.trace.v_prescribed =
      displacement_against_foundation(surface, law, system.prescribed_value)
          .reshaped();
  for (std::size_t row = 0; row < result.held.size(); ++row)
    if (result.held[row]) result.trace.v_prescribed[row] = 0;
  return result;
}

}  // namespace ffcontact
