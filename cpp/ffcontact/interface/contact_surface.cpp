// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/contact_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/base/unions.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/interface/fitted_normals.hpp"
#include "ffcontact/interface/labelled_facets.hpp"

namespace ffcontact {

namespace {

/// cos of the turn at an edge below which the faces beside it are of two sheets.
const double sharp = std::cos(M_PI / 6);
/// 1 - cos of the turn below which faces lie in one plane.
constexpr double coplanar = 1e-12;
/// Components of n above this make the x axis a bad tangent.
constexpr double steep = 0.9;

Matrix3Xd without_rounding(Matrix3Xd normals) {
  for (double& component : normals.reshaped())
    if (std::abs(component) < coplanar) component = 0;
  return normals;
}

std::vector<int> stated_faces(const SolidMesh& mesh, const Facets<3>& faces,
                              const std::vector<int>& labels) {
  if (labels.empty()) refuse("no label is given");
  return labelled_facets(mesh, faces, labels);
}

/// Finds the sheets; corner 3 m + k is vertex k of contact face m.
class SheetFinder {
 public:
  SheetFinder(const SolidMesh& mesh, const Facets<3>& faces,
              std::vector<int> contact_faces, bool one_node_a_vertex)
      : mesh_(mesh),
        faces_(faces),
        face_(std::move(contact_faces)),
        sheets_(count_of(face_)),
        nodes_(3 * count_of(face_)) {
    vector_.resize(3, count_of(face_));
    for (int m = 0; m < count_of(face_); ++m)
      vector_.col(m) = facet_measure(mesh, faces, face_[m]) *
                       facet_normal(mesh, faces, face_[m]);
    join_across_edges();
    join_at_vertices(one_node_a_vertex);
  }

  ContactSurface surface() {
    ContactSurface result;
    result.face = packed(face_);
    result.face_node.resize(3, count_of(face_));
    const Flags plane = planes();
    std::map<int, int> number;  // node of each root
    std::vector<Vector3d> sums;
    std::vector<int> vertices;
    std::vector<double> areas;
    for (int corner = 0; corner < 3 * count_of(face_); ++corner) {
      const int m = corner / 3, sheet = sheets_.root(m);
      const auto [found, is_new] =
          number.emplace(nodes_.root(corner), count_of(sums));
      result.face_node(corner % 3, m) = found->second;
      if (is_new) {
        sums.emplace_back(Vector3d::Zero());
        vertices.push_back(vertex(corner));
        areas.push_back(0);
      }
      sums[found->second] +=
          plane[sheet] ? sheet_vector_.col(sheet) : vector_.col(m);
      areas[found->second] += vector_.col(m).norm() / 3;
    }
    result.vertex = packed(vertices);
    result.area = packed(areas);
    result.mass = mass(result);
    result.normal = without_rounding(packed(sums).colwise().normalized());
    return result;
  }

 private:
  SparseMatrix mass(const ContactSurface& surface) const {
    Triplets entries;
    for (int m = 0; m < surface.face_count(); ++m)
      for (int a : surface.face_node.col(m))
        for (int b : surface.face_node.col(m))
          entries.emplace_back(a, b, vector_.col(m).norm() / (a == b ? 6 : 12));
    return packed(surface.node_count(), surface.node_count(), entries);
  }

  int vertex(int corner) const {
    return faces_.vertices(corner % 3, face_[corner / 3]);
  }
  int label(int m) const {
    return mesh_.boundary_label[faces_.boundary_index[face_[m]]];
  }
  double cosine(const Vector3d& a, const Vector3d& b) const {
    return a.dot(b) / (a.norm() * b.norm());
  }

  bool go_on(int m, int other) const {
    const double turn = cosine(vector_.col(m), vector_.col(other));
    return turn > 1 - coplanar || (turn > sharp && label(m) == label(other));
  }

  /// Corners of both faces at the vertices that they share.
  /// Those of a face among all.
  static std::array<int, 3> corners(int m) {
    return {3 * m, 3 * m + 1, 3 * m + 2};
  }
  void join_corners(int m, int other) {
    for (int a : corners(m))
      for (int b : corners(other))
        if (vertex(a) == vertex(b)) nodes_.join(a, b);
  }

  void join_across_edges() {
    std::map<std::pair<int, int>, int> beside;
    for (int m = 0; m < count_of(face_); ++m)
      for (int k = 0; k < 3; ++k) {
        const std::pair<int, int> ends =
            std::minmax(vertex(3 * m + k), vertex(3 * m + (k + 1) % 3));
        const auto [found, is_first] = beside.emplace(ends, m);
        if (is_first || !go_on(m, found->second)) continue;
        sheets_.join(m, found->second);
        join_corners(m, found->second);
      }
  }

  /// Corners at a vertex with one normal, or all of them.
  void join_at_vertices(bool all) {
    std::map<int, std::vector<int>> corners;
    for (int corner = 0; corner < 3 * count_of(face_); ++corner)
      corners[vertex(corner)].push_back(corner);
    for (const auto& [v, at_vertex] : corners)
      for (int corner : at_vertex)
        for (int other : at_vertex)
          if (all || cosine(vector_.col(corner / 3), vector_.col(other / 3)) >
                         1 - coplanar)
            nodes_.join(corner, other);
  }

  /// 1 for the sheets that are planes [m, at their roots].
  Flags planes() {
    sheet_vector_ = Matrix3Xd::Zero(3, vector_.cols());
    for (int m = 0; m < count_of(face_); ++m)
      sheet_vector_.col(sheets_.root(m)) += vector_.col(m);
    Flags plane(face_.size(), 1);
    for (int m = 0; m < count_of(face_); ++m) {
      const int sheet = sheets_.root(m);
      if (cosine(vector_.col(m), sheet_vector_.col(sheet)) < 1 - coplanar)
        plane[sheet] = 0;
    }
    return plane;
  }

  const SolidMesh& mesh_;
  const Facets<3>& faces_;
  const std::vector<int> face_;
  Matrix3Xd vector_;        ///< A n of each contact face
  Matrix3Xd sheet_vector_;  ///< their sums, at the roots of the sheets
  Unions sheets_, nodes_;
};

SheetOfNodes nodes_of_sheets(const SolidMesh& mesh, const Facets<3>& faces,
                             const ContactSurface& surface) {
  SheetOfNodes sheet{mesh.vertices(Eigen::all, surface.vertex), surface.normal,
                     surface.face_node, Matrix3Xd(3, surface.face_count())};
  for (int m = 0; m < surface.face_count(); ++m)
    sheet.face_normal.col(m) = facet_normal(mesh, faces, surface.face[m]);
  return sheet;
}

/// @throws std::invalid_argument  unless the direction points out of the faces at a node
void require_outward(const SolidMesh& mesh, const Facets<3>& faces,
                     const ContactSurface& surface) {
  for (int m = 0; m < surface.face_count(); ++m)
    for (int node : surface.face_node.col(m)) {
      const Vector3d n = surface.normal.col(node);
      const double outward = n.dot(facet_normal(mesh, faces, surface.face[m]));
      if (outward > 0) continue;
      const int v = surface.vertex[node];
      refuse("the contact direction at vertex ", v, " ",
             in_words(mesh.place(v)),
             " is zero, not finite, or does not point out of the body");
    }
}

}  // namespace

Matrix3d ContactSurface::frame(int node) const {
  const Vector3d n = normal.col(node);
  const Vector3d axis =
      std::abs(n.x()) > steep ? Vector3d::UnitY() : Vector3d(Vector3d::UnitX());
  Matrix3d columns;
  columns.col(0) = n;
  columns.col(1) = (axis - n.dot(axis) * n).normalized();
  columns.col(2) = columns.col(1).cross(n);
  return columns;
}

ContactSurface contact_surface(const SolidMesh& mesh, const Facets<3>& faces,
                               const std::vector<int>& labels) {
  ContactSurface surface =
      SheetFinder(mesh, faces, stated_faces(mesh, faces, labels), false)
          .surface();
  surface.normal =
      without_rounding(fitted_normals(nodes_of_sheets(mesh, faces, surface)));
  return surface;
}

ContactSurface surface_along(const SolidMesh& mesh, const Facets<3>& faces,
                             const std::vector<int>& labels,
                             const Ref<const Matrix3Xd>& direction) {
  ContactSurface surface =
      SheetFinder(mesh, faces, stated_faces(mesh, faces, labels), true)
          .surface();
  for (int i = 0; i < surface.node_count(); ++i)
    surface.normal.col(i) = direction.col(surface.vertex[i]).normalized();
  require_outward(mesh, faces, surface);
  return surface;
}

Matrix3Xd contact_components(const ContactSurface& surface,
                             const Ref<const VectorXd>& field) {
  Matrix3Xd components(3, surface.node_count());
  for (int i = 0; i < surface.node_count(); ++i) {
    Vector3d jump = vector_at<3>(field, surface.vertex[i]);
    visit_opposite(surface, i, [&](int vertex, double weight) {
      jump -= weight * vector_at<3>(field, vertex);
    });
    components.col(i) = surface.frame(i).transpose() * jump;
  }
  return components;
}

VectorXd nodal_load(const ContactSurface& surface,
                    const Ref<const Matrix3Xd>& force, Index dofs) {
  VectorXd load = VectorXd::Zero(dofs);
  for (int i = 0; i < surface.node_count(); ++i) {
    const Vector3d F = surface.frame(i) * force.col(i);
    vector_at<3>(load, surface.vertex[i]) += F;
    visit_opposite(surface, i, [&](int vertex, double weight) {
      vector_at<3>(load, vertex) -= weight * F;
    });
  }
  return load;
}

}  // namespace ffcontact
