// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/moved_onto_surfaces.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/remeshing/smooth_surface.hpp"
#include "ffcontact/mesh/smooth_curve.hpp"
#include "ffcontact/mesh/turns.hpp"

namespace ffcontact {

namespace {

/// A smooth surface of the old mesh, whatever labels it has.
class OldSurface {
 public:
  /// @param members  numbers of its dividing faces
  OldSurface(const SolidMesh& mesh, const Facets<3>& faces,
             const DividingFaces& dividing, const std::vector<int>& members) {
    const Vector2i parts = dividing.parts.col(members[0]);
    for (const int k : members) {
      Vector3i v = faces.vertices.col(dividing.face[k]);
      if (dividing.parts.col(k) != parts) std::swap(v[0], v[1]);
      vertices_.push_back(v);
      corners_.push_back(mesh.vertices(Eigen::all, v));
      centre_.push_back(corners_.back().rowwise().mean());
      radius_.push_back((corners_.back().colwise() - centre_.back())
                            .colwise()
                            .norm()
                            .maxCoeff());
      add_normals(v, corners_.back());
    }
    for (auto& [v, normal] : normal_) normal.normalize();
    correct_rim();
  }

  /// The point of the surface over the point of its facets that is nearest to x.
  Vector3d over(const Vector3d& x) const {
    double least = infinity;
    int face = 0;
    Vector3d place = Vector3d::Zero();
    for (int k = 0; k < count_of(corners_); ++k) {
      if ((x - centre_[k]).norm() - radius_[k] >= least) continue;
      const Vector3d own = nearest_place(corners_[k], x);
      const double distance = (corners_[k] * own - x).norm();
      if (distance >= least) continue;
      least = distance;
      face = k;
      place = own;
    }
    Matrix3d normals;
    for (int i = 0; i < 3; ++i) normals.col(i) = normal_at(vertices_[face][i]);
    return point_on_cubic_triangle(corners_[face], normals, place);
  }

 private:
  const Vector3d& normal_at(int vertex) const {
    return entry_of(normal_, vertex, "normal at a vertex");
  }

  /// Weights of N. Max, J. Graphics Tools 4(2), 1999: exact on spheres.
  void add_normals(const Vector3i& v, const Matrix3d& corners) {
    for (int i = 0; i < 3; ++i) {
      const Vector3d a = corners.col((i + 1) % 3) - corners.col(i),
                     b = corners.col((i + 2) % 3) - corners.col(i);
      normal_.emplace(v[i], Vector3d::Zero()).first->second +=
          a.cross(b) / (a.squaredNorm() * b.squaredNorm());
    }
  }

  /// Edges with one face of the surface.
  std::vector<std::array<int, 2>> rim_edges() const {
    std::map<std::array<int, 2>, int> uses;
    for (const Vector3i& v : vertices_)
      for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(v[i], v[(i + 1) % 3]);
        ++uses[{low, high}];
      }
    std::vector<std::array<int, 2>> rim;
    for (const auto& [edge, count] : uses)
      if (count == 1) rim.push_back(edge);
    return rim;
  }

  /// On a rim faces are on one side. Along an edge of a sphere or of a cylinder the
  /// normals at both ends are the mirror image of each other, n_v . e = -n_w . e, in
  /// which normals at rims are brought nearest to it over all their edges.
  void correct_rim() {
    constexpr int passes = 8;
    constexpr double own_weight = 1e-3;
    std::map<int, std::map<int, Vector3d>> edges_at;
    for (const auto& edge : rim_edges())
      for (const int v : edge) edges_at[v];
    for (int k = 0; k < count_of(vertices_); ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          if (const auto at = edges_at.find(vertices_[k][i]);
              at != edges_at.end() && i != j)
            at->second[vertices_[k][j]] =
                (corners_[k].col(j) - corners_[k].col(i)).normalized();
    const std::map<int, Vector3d> first = normal_;
    for (int pass = 0; pass < passes; ++pass)
      for (const auto& [v, edges] : edges_at) {
        Matrix3d matrix = own_weight * Matrix3d::Identity();
        Vector3d wanted = own_weight * entry_of(first, v, "normal at a vertex");
        for (const auto& [w, e] : edges) {
          if (pass == 0 && edges_at.count(w) > 0) continue;
          matrix += e * e.transpose();
          wanted -= e.dot(normal_at(w)) * e;
        }
        normal_[v] = matrix.ldlt().solve(wanted).normalized();
      }
  }

  std::vector<Vector3i> vertices_;
  std::vector<Matrix3d> corners_;
  std::vector<Vector3d> centre_;
  std::vector<double> radius_;
  std::map<int, Vector3d> normal_;
};

/// The smooth curve through a chain of vertices; none where two are too few for one.
std::optional<SmoothCurve<3>> curve_through(const SolidMesh& mesh,
                                            const std::vector<int>& chain) {
  if (chain.size() < 3) return std::nullopt;
  const Matrix3Xd points = mesh.vertices(Eigen::all, chain);
  const bool closed = chain.front() == chain.back() && chain.size() > 3;
  return smooth_curve<3>(points, closed && Turns<3>(points).is_smooth(0));
}

/// Where vertices go, and none where they stay.
using Goals = std::map<int, Vector3d>;

/// The smooth surfaces of a mesh by their sheets.
using OldSurfaces = std::map<int, OldSurface>;

OldSurfaces old_surfaces(const SolidMesh& mesh, const Facets<3>& faces,
                         const SurfaceModel& model) {
  const SurfacePatches& patches = model.patches;
  std::map<int, std::vector<int>> members;
  for (int k = 0; k < model.dividing.count(); ++k)
    if (!patches.flat[patches.surface[k]])
      members[patches.sheet_of_face(k)].push_back(k);
  OldSurfaces surfaces;
  for (const auto& [sheet, faces_of] : members)
    surfaces.emplace(sheet, OldSurface(mesh, faces, model.dividing, faces_of));
  return surfaces;
}

void add_surface_goals(const ModelMesh& fine, const OldSurfaces& surfaces,
                       const SurfacePatches& patches, Goals& goals) {
  std::map<int, std::set<int>> vertices;  // of each sheet
  for (Index e = 0; e < fine.mesh.boundary.cols(); ++e) {
    const int surface = patches.surface_of_patch[fine.patch[e]];
    if (patches.flat[surface]) continue;
    for (const int v : fine.mesh.boundary.col(e))
      vertices[patches.sheet[surface]].insert(v);
  }
  for (const auto& [sheet, of_sheet] : vertices) {
    const OldSurface& surface = entry_of(surfaces, sheet, "surface of a sheet");
    for (const int v : of_sheet)
      goals[v] = surface.over(fine.mesh.vertices.col(v));
  }
}

/// The point of a surface over x, slid along the normal there into the plane through x.
Vector3d within_plane(const Vector3d& normal, const Vector3d& x,
                      const Vector3d& over_x) {
  constexpr double least_part = 0.1;  // of it that is in the plane
  const Vector3d off = over_x - x, in_plane = off - normal.dot(off) * normal;
  if (in_plane.squaredNorm() <= least_part * off.squaredNorm()) return x;
  return x + off.squaredNorm() / in_plane.squaredNorm() * in_plane;
}

/// A curve of the old mesh, and what it is the rim of.
class OldCurve {
 public:
  OldCurve(const SolidMesh& mesh, const Facets<3>& faces,
           const OldSurfaces& surfaces, const SurfaceModel& model,
           const PatchCurve& curve)
      : curve_(curve_through(mesh, curve.vertices)),
        is_label_line_(curve.is_label_line) {
    const SurfacePatches& patches = model.patches;
    if (curve.patches.size() != 2) return;
    for (const int patch : curve.patches) {
      const int surface = patches.surface_of_patch[patch];
      if (!patches.flat[surface])
        surface_ =
            &entry_of(surfaces, patches.sheet[surface], "surface of a sheet");
      else if (!curve_)
        plane_ = facet_normal(mesh, faces, face_of(model, patch));
    }
  }

  /// Where a vertex on its chords goes. Surfaces go on beyond a label line; a single chord
  /// between a surface and a plane is none of a curve by itself.
  Vector3d goal(const Vector3d& x) const {
    const Vector3d on_curve = curve_ ? curve_->beside(x) : x;
    if (is_label_line_) return surface_->over(on_curve);
    if (curve_ || !plane_ || !surface_) return on_curve;
    return within_plane(*plane_, x, surface_->over(x));
  }

 private:
  static int face_of(const SurfaceModel& model, int patch) {
    const std::vector<int>& of_faces = model.patches.patch;
    const auto first = std::find(of_faces.begin(), of_faces.end(), patch);
    return model.dividing.face[first - of_faces.begin()];
  }

  std::optional<SmoothCurve<3>> curve_;
  bool is_label_line_;
  const OldSurface* surface_ = nullptr;
  std::optional<Vector3d> plane_;  ///< its normal, of a single chord
};

std::vector<std::set<int>> vertices_of_curves(const ModelMesh& fine,
                                              std::size_t curves) {
  std::vector<std::set<int>> vertices(curves);
  for (Index e = 0; e < fine.lines.cols(); ++e)
    for (const int v : fine.lines.col(e)) vertices[fine.curve[e]].insert(v);
  return vertices;
}

/// Vertices of several curves that are at a corner.
void add_corner_goals(const ModelMesh& fine, const SolidMesh& mesh,
                      const std::vector<int>& corners, Goals& goals) {
  std::map<int, std::set<int>> curves_of;
  for (Index e = 0; e < fine.lines.cols(); ++e)
    for (const int v : fine.lines.col(e)) curves_of[v].insert(fine.curve[e]);
  for (const int corner : corners)
    for (const auto& [v, of] : curves_of) {
      const Vector3d x = fine.mesh.vertices.col(v);
      if (of.size() > 1 && (x - mesh.vertices.col(corner)).norm() == 0)
        goals[v] = x;
    }
}

/// Curves rule over surfaces, and corners over curves.
void add_curve_goals(const ModelMesh& fine, const SolidMesh& mesh,
                     const Facets<3>& faces, const OldSurfaces& surfaces,
                     const SurfaceModel& model, Goals& goals) {
  const std::vector<PatchCurve>& curves = model.curves.curves;
  const auto vertices = vertices_of_curves(fine, curves.size());
  for (int c = 0; c < count_of(curves); ++c) {
    if (!curves[c].is_rim) continue;
    const OldCurve curve(mesh, faces, surfaces, model, curves[c]);
    for (const int v : vertices[c])
      goals[v] = curve.goal(fine.mesh.vertices.col(v));
  }
  add_corner_goals(fine, mesh, model.curves.corners, goals);
}

/// Moves all goals' vertices at once, and those of spoilt tetrahedra half as far until
/// none is spoilt.
SolidMesh moved(const SolidMesh& mesh, const Goals& goals) {
  constexpr int halvings = 6;
  constexpr double least_part = 0.5;
  VectorXd part = VectorXd::Zero(mesh.vertex_count());
  for (const auto& [v, goal] : goals) part[v] = 1;
  SolidMesh result = mesh;
  for (int pass = 0; pass <= halvings; ++pass) {
    for (const auto& [v, goal] : goals)
      result.vertices.col(v) =
          (1 - part[v]) * mesh.vertices.col(v) + part[v] * goal;
    std::set<int> spoilt;
    for (int t = 0; t < mesh.cell_count(); ++t)
      if (signed_volume(result, t) < least_part * signed_volume(mesh, t))
        for (const int v : mesh.cells.col(t))
          if (part[v] > 0) spoilt.insert(v);
    if (spoilt.empty()) break;
    for (const int v : spoilt) part[v] = pass + 1 < halvings ? part[v] / 2 : 0;
  }
  return result;
}

}  // namespace

SolidMesh moved_onto_surfaces(const ModelMesh& fine, const SolidMesh& mesh,
                              const Facets<3>& faces,
                              const SurfaceModel& model) {
  const OldSurfaces surfaces = old_surfaces(mesh, faces, model);
  Goals goals;
  add_surface_goals(fine, surfaces, model.patches, goals);
  add_curve_goals(fine, mesh, faces, surfaces, model, goals);
  return moved(fine.mesh, goals);
}

}  // namespace ffcontact
