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

/// A smooth surface of the old mesh.
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

void add_surface_goals(const ModelMesh& fine, const SolidMesh& mesh,
                       const Facets<3>& faces, const SurfaceModel& model,
                       Goals& goals) {
  const SurfacePatches& patches = model.patches;
  std::vector<std::vector<int>> members(patches.surface_count());
  for (int k = 0; k < model.dividing.count(); ++k)
    members[patches.surface[k]].push_back(k);
  std::vector<std::set<int>> vertices(patches.surface_count());
  for (Index e = 0; e < fine.mesh.boundary.cols(); ++e)
    for (const int v : fine.mesh.boundary.col(e))
      vertices[patches.surface_of_patch[fine.patch[e]]].insert(v);
  for (int s = 0; s < patches.surface_count(); ++s) {
    if (patches.flat[s]) continue;
    const OldSurface surface(mesh, faces, model.dividing, members[s]);
    for (const int v : vertices[s])
      goals[v] = surface.over(fine.mesh.vertices.col(v));
  }
}

/// Curves rule over surfaces, and corners over curves.
void add_curve_goals(const ModelMesh& fine, const SolidMesh& mesh,
                     const SurfaceModel& model, Goals& goals) {
  const std::vector<PatchCurve>& curves = model.curves.curves;
  std::vector<std::set<int>> vertices(curves.size());
  std::map<int, std::set<int>> curves_of;
  for (Index e = 0; e < fine.lines.cols(); ++e)
    for (const int v : fine.lines.col(e)) {
      vertices[fine.curve[e]].insert(v);
      curves_of[v].insert(fine.curve[e]);
    }
  for (int c = 0; c < count_of(curves); ++c) {
    if (!curves[c].is_rim) continue;
    const auto curve = curve_through(mesh, curves[c].vertices);
    for (const int v : vertices[c]) {
      const Vector3d x = fine.mesh.vertices.col(v);
      goals[v] = curve ? curve->beside(x) : x;
    }
  }
  for (const int corner : model.curves.corners)
    for (auto& [v, of] : curves_of) {
      const Vector3d x = fine.mesh.vertices.col(v);
      if (of.size() > 1 && (x - mesh.vertices.col(corner)).norm() == 0)
        goals[v] = x;
    }
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
  Goals goals;
  add_surface_goals(fine, mesh, faces, model, goals);
  add_curve_goals(fine, mesh, model, goals);
  return moved(fine.mesh, goals);
}

}  // namespace ffcontact
