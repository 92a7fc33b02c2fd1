// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/condensed/surface_trace.hpp"
#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// A vertex that has more rows than ways to move: of several nodes, on an edge or in a
/// corner of the surface, or held by supports where it faces what moves. With y of the
/// vertex, as many as it has ways to move, and u_j of those that it faces, its rows have
///     v = E y + sum_j E_j u_j + v_prescribed + gamma P,
/// and their forces P are E'P on y and E_j'P on u_j. Its own rows come first, where v is y:
///     E = 1, E_j = 0.
/// These are normal ones as far as they are independent: bodies that meet at an edge are
/// apart or closed along the axes of y then, whatever their friction does. Other rows with
/// E_j couple what the vertex faces, as friction does on both sides of an edge.
struct SharedVertex {
  using Rows3 = Matrix<double, Dynamic, 3>;
  struct Link {
    int vertex;
    Rows3 E;
  };

  int vertex = 0;
  int own = 0;            ///< rows
  int coupling = 0;       ///< rows with E_j, the last ones
  std::vector<int> rows;  ///< 3 i + c of its nodes that are not held [r]
  Rows3 E;                ///< 0 in columns beyond those of the own rows
  std::vector<Link> faced;
  VectorXd layer;      ///< gamma, 0 without a layer [r]
  VectorXd stiffness;  ///< of the bodies against v, about [r]
  /// The displacement of the vertex is T (y + sum_j B_j u_j).
  Matrix3d T;
  std::vector<Matrix3d> B;  ///< of each that it faces

  int row_count() const { return static_cast<int>(rows.size()); }
  int first_coupling() const { return row_count() - coupling; }
  /// Calls visit(k, row, place of y) for its own rows.
  template <class Visit>
  void for_own(const Visit& visit) const {
    for (int k = 0; k < own; ++k) visit(k, rows[k], 3 * vertex + k);
  }
  /// Three values of a vertex.
  template <class Vector>
  static Vector3d at(int v, const Vector& values) {
    return values.template segment<3>(3 * v).template cast<double>();
  }
  /// E y + sum_j E_j u_j
  /// @param y  of all vertices
  template <class Vector>
  VectorXd motion(const Vector& y) const {
    VectorXd v = E * at(vertex, y);
    for (const Link& link : faced) v += link.E * at(link.vertex, y);
    return v;
  }
  /// What P are to y, added to the forces on y of all vertices.
  template <class Vector>
  void add_forces(const VectorXd& P, Vector& forces) const {
    add(vertex, E.transpose() * P, forces);
    for (const Link& link : faced)
      add(link.vertex, link.E.transpose() * P, forces);
  }

 private:
  template <class Vector>
  static void add(int v, const Vector3d& force, Vector& forces) {
    forces.template segment<3>(3 * v) += force.cast<typename Vector::Scalar>();
  }
};

/// @param compliance  gamma of all rows
std::vector<SharedVertex> shared_vertices(const ContactSurface& surface,
                                          const SurfaceTrace& trace,
                                          const VectorXd& compliance,
                                          const ElasticSystem& system);

}  // namespace ffcontact
