// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed/surface_trace.hpp"

#include <Eigen/LU>
#include <map>
#include <utility>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/condensed/layer_springs.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

/// Rows that free axes move by less than this are moved by others.
constexpr double moved_by_axes = 1e-3;
/// Opposite vertices that weigh less, or move less along a row, do not move it, nor do
/// those beside fixed ones that weigh more than this.
constexpr double least_weight = 1e-3, least_motion = 1e-6, most_fixed = 0.5;

using Directions = Matrix<double, 3, Dynamic>;

/// How a vertex moves: displacement = directions w, its components w, which are v of the
/// primary rows, numbered from `column` on.
struct Motion {
  int column;
  Directions directions;
};

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
  TraceBuilder(const ContactSurface& surface, const Flags& prescribed)
      : surface_(surface), prescribed_(prescribed) {
    held_.assign(3 * surface.node_count(), 1);
    for (int i = 0; i < surface.node_count(); ++i) add_vertex(i);
    for (int v : opposite_vertices(surface)) {
      const Directions axes = free_axes<3>(v, prescribed);
      if (motions_.emplace(v, Motion{components_, axes}).second)
        components_ += static_cast<int>(axes.cols());
    }
    for (int i = 0; i < surface.node_count(); ++i)
      for (int c = 0; c < 3; ++c) add_row(i, c);
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
  void add_vertex(int node) {
    const int vertex = surface_.vertex[node];
    const Matrix3d frame = surface_.frame(node);
    const Directions axes = free_axes<3>(vertex, prescribed_);
    const std::vector<int> rows = moved_components(frame, axes);
    for (int c : rows) held_[3 * node + c] = 0;
    const Directions moving = frame(Eigen::all, rows);
    if (!motions_.emplace(vertex, Motion{components_, with_unit(moving, axes)})
             .second)
      return;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const int row = 3 * node + rows[k];
      primary_.push_back(row);
      place_.emplace(row, components_ + static_cast<int>(k));
    }
    components_ += static_cast<int>(axes.cols());
  }

  void add_row(int node, int c) {
    const int row = 3 * node + c;
    const Vector3d direction = surface_.frame(node).col(c);
    if (held_[row] && !opposite_moves(node, direction)) return;
    if (held_[row] && c > 0 && is_beside_moving(node, direction)) return;
    held_[row] = 0;
    if (const auto own = place_.find(row); own != place_.end())
      entries_.emplace_back(row, own->second, 1);
    else
      add_motion(row, direction, motion_of(surface_.vertex[node]));
    visit_opposite(surface_, node, [&](int vertex, double weight) {
      add_motion(row, -weight * direction, motion_of(vertex));
    });
  }

  const Motion& motion_of(int vertex) const {
    return entry_of(motions_, vertex, "motion of a vertex");
  }

  static bool moves(const Motion& motion, const Vector3d& direction) {
    return (motion.directions.transpose() * direction).norm() > least_motion;
  }

  /// Does one node of a face with this one move along a direction, while this one
  /// follows several opposite vertices? A multiplier that no own dof belongs to would
  /// hold the opposite body between its vertices.
  bool is_beside_moving(int node, const Vector3d& direction) const {
    int followed = 0;
    visit_opposite(surface_, node, [&](int, double) { ++followed; });
    if (followed < 2) return false;
    for (const auto nodes : surface_.face_node.colwise()) {
      if ((nodes.array() != node).all()) continue;
      for (int other : nodes)
        if (other >= 0 && moves(motion_of(surface_.vertex[other]), direction))
          return true;
    }
    return false;
  }

  /// Where a plane of symmetry cuts both surfaces the opposite vertices beside it say
  /// nothing of what happens on it.
  bool opposite_moves(int node, const Vector3d& direction) const {
    double fixed = 0;
    bool any = false;
    visit_opposite(surface_, node, [&](int vertex, double weight) {
      if (!moves(motion_of(vertex), direction))
        fixed += weight;
      else if (std::abs(weight) >= least_weight)
        any = true;
    });
    return any && fixed < most_fixed;
  }

  /// The displacements along free axes that have the components 1, one after the other,
  /// along as many directions.
  static Directions with_unit(const Directions& moving,
                              const Directions& axes) {
    if (axes.cols() == 3) return moving;  // orthonormal
    return axes * (moving.transpose() * axes).inverse();
  }

  void add_motion(int row, const Vector3d& direction, const Motion& motion) {
    for (Index k = 0; k < motion.directions.cols(); ++k)
      entries_.emplace_back(row, motion.column + k,
                            direction.dot(motion.directions.col(k)));
  }

  SparseMatrix to_kept(const std::vector<int>& kept) const {
    Triplets entries;
    for (int k = 0; k < count_of(kept); ++k) {
      const Motion& motion = motion_of(kept[k] / 3);
      for (Index j = 0; j < motion.directions.cols(); ++j)
        entries.emplace_back(k, motion.column + j,
                             motion.directions(kept[k] % 3, j));
    }
    return packed(count_of(kept), components_, entries);
  }

  const ContactSurface& surface_;
  const Flags& prescribed_;
  std::map<int, Motion> motions_;  ///< of own vertices, then of opposite ones
  std::map<int, int> place_;       ///< component of each primary row
  std::vector<int> primary_;
  Flags held_;
  Triplets entries_;
  int components_ = 0;
};

}  // namespace

SurfaceTrace surface_trace(const ContactSurface& surface,
                           const ContactLaw<3>& law,
                           const ElasticSystem& system) {
  const std::vector<int> kept = free_dofs_at(contact_vertices(surface), system);
  SurfaceTrace result = TraceBuilder(surface, system.prescribed).trace(kept);
  if (result.primary.empty())
    refuse("every dof of the contact surface is prescribed");
  result.trace.v_prescribed =
      without(result.held, displacement_against_foundation(
                               surface, law, system.prescribed_value))
          .reshaped();
  add_layer(nodal_compliance(law.layer, surface.area, 3, result.held),
            result.trace);
  return result;
}

}  // namespace ffcontact
