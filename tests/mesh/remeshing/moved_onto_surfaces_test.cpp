// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/moved_onto_surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ffcontact/base/packed.hpp"
#include "support/nested_solids.hpp"
#include "support/pi.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Another label for half of the upper side along y of a brick of n^3 cells, which begins at a
/// staircase from edge to edge.
constexpr int behind_stairs = 99;
void put_stairs(int n, const Vector3d& sides, SolidMesh& mesh) {
  for (Index e = 0; e < mesh.boundary.cols(); ++e) {
    if (mesh.boundary_label[e] != high_y) continue;
    const Vector3d middle =
        mesh.vertices(Eigen::all, mesh.boundary.col(e)).rowwise().mean();
    const Vector3d cell = n * middle.cwiseQuotient(sides);
    if (std::floor(cell.x()) + std::floor(cell.z()) >= n)
      mesh.boundary_label[e] = behind_stairs;
  }
}

/// The mesh whose vertices are on the faces of a bent brick of n^3 cells, twice as fine.
ModelMesh finer_mesh(int n, const SolidMesh& coarse, const SurfaceModel& model,
                     bool stairs = false) {
  ModelMesh fine;
  fine.mesh = brick({2 * n, 2 * n, 2 * n}, {2, 2, 2});
  if (stairs) put_stairs(n, {2, 2, 2}, fine.mesh);
  fine.mesh.vertices = on_finer_brick(coarse.vertices.reshaped(), {n, n, n}, 2)
                           .reshaped(3, fine.mesh.vertex_count());
  std::map<int, int> patch;  // of each label
  for (int k = 0; k < model.dividing.count(); ++k)
    patch[coarse.boundary_label[model.dividing.boundary[k]]] =
        model.patches.patch[k];
  for (const int label : fine.mesh.boundary_label)
    fine.patch.push_back(patch[label]);
  fine.lines.resize(2, 0);
  return fine;
}

TEST(MovedOntoSurfaces, has_a_dome_on_its_sphere_and_the_rest_in_place) {
  constexpr int n = 4;
  constexpr double radius = 4;
  SolidMesh coarse = brick({n, n, n}, {2, 2, 2});
  for (auto x : coarse.vertices.colwise())
    x.z() *= std::sqrt(radius * radius - std::pow(x.x() - 1, 2) -
                       std::pow(x.y() - 1, 2)) /
             2;
  const Facets<3> faces = facets_of(coarse);
  const SurfaceModel model =
      surface_model(coarse, faces, VectorXi::Zero(coarse.cell_count()), pi / 6);
  const ModelMesh fine = finer_mesh(n, coarse, model);
  const SolidMesh moved = moved_onto_surfaces(fine, coarse, faces, model);
  std::set<int> dome;
  for (Index e = 0; e < moved.boundary.cols(); ++e)
    if (moved.boundary_label[e] == high_z)
      for (const int v : moved.boundary.col(e)) dome.insert(v);
  const auto off = [&](const SolidMesh& mesh, int v) {
    return std::abs((mesh.vertices.col(v) - Vector3d(1, 1, 0)).norm() - radius);
  };
  double before = 0, after = 0;
  for (int v = 0; v < moved.vertex_count(); ++v) {
    if (dome.count(v) > 0) {
      before = std::max(before, off(fine.mesh, v));
      after = std::max(after, off(moved, v));
    } else {
      EXPECT_EQ(moved.vertices.col(v), fine.mesh.vertices.col(v));
    }
  }
  EXPECT_GT(before, 0.01);
  EXPECT_LT(after, 0.05 * before);
  for (int t = 0; t < moved.cell_count(); ++t)
    EXPECT_GT(signed_volume(moved, t), 0);
}

TEST(MovedOntoSurfaces, goes_part_of_the_way_where_tetrahedra_are_flat) {
  // a bowl whose bottom is thinner than it is hollow between its vertices
  constexpr int n = 4;
  constexpr double radius = 4, thinnest = 0.04;
  SolidMesh coarse = brick({n, n, n}, {2, 2, 2});
  const auto height = [](const Vector3d& x) {
    return radius + thinnest -
           std::sqrt(radius * radius - std::pow(x.x() - 1, 2) -
                     std::pow(x.y() - 1, 2));
  };
  for (auto x : coarse.vertices.colwise()) x.z() *= height(x) / 2;
  const Facets<3> faces = facets_of(coarse);
  const SurfaceModel model =
      surface_model(coarse, faces, VectorXi::Zero(coarse.cell_count()), pi / 6);
  const ModelMesh fine = finer_mesh(n, coarse, model);
  const SolidMesh moved = moved_onto_surfaces(fine, coarse, faces, model);
  for (int t = 0; t < moved.cell_count(); ++t)
    EXPECT_GE(signed_volume(moved, t), 0.5 * signed_volume(fine.mesh, t));
  int whole = 0, part = 0;
  for (int v = 0; v < moved.vertex_count(); ++v) {
    const Vector3d from = fine.mesh.vertices.col(v);
    const double hollow = from.z() - height(from),
                 left = moved.vertices(2, v) - height(moved.vertices.col(v));
    if (from.z() < height(from) || hollow < 1e-3) continue;
    whole += left < 0.1 * hollow;
    part += left > 0.1 * hollow && left < 0.9 * hollow;
  }
  EXPECT_GT(whole, 0);
  EXPECT_GT(part, 0);
}

/// The vertices in the middle of chords, as lines of their curves.
void put_lines(const SolidMesh& coarse, const SurfaceModel& model,
               ModelMesh& fine) {
  std::vector<Vector2i> lines;
  for (int c = 0; c < static_cast<int>(model.curves.curves.size()); ++c)
    for (int v = 0; v < fine.mesh.vertex_count(); ++v) {
      const auto& chain = model.curves.curves[c].vertices;
      for (std::size_t k = 1; k < chain.size(); ++k) {
        const Vector3d a = coarse.vertices.col(chain[k - 1]),
                       b = coarse.vertices.col(chain[k]),
                       x = fine.mesh.vertices.col(v);
        if ((x - (a + b) / 2).norm() > 1e-12) continue;
        lines.emplace_back(v, v);
        fine.curve.push_back(c);
      }
    }
  fine.lines = packed(lines);
}

TEST(MovedOntoSurfaces, puts_lines_on_curves_and_leaves_planes) {
  // an eighth of a tube: its rims are circles between planes and cylinders
  constexpr int n = 4;
  SolidMesh coarse = brick({n, n, n}, {pi / 4, 1, 2});
  const auto bent = [](const Vector3d& x) {
    return Vector3d((3 + x.y()) * std::cos(x.x()),
                    (3 + x.y()) * std::sin(x.x()), -x.z());
  };
  for (auto x : coarse.vertices.colwise()) x = bent(x);
  const Facets<3> faces = facets_of(coarse);
  const SurfaceModel model =
      surface_model(coarse, faces, VectorXi::Zero(coarse.cell_count()), pi / 6);
  ModelMesh fine = finer_mesh(n, coarse, model);
  put_lines(coarse, model, fine);
  const SolidMesh moved = moved_onto_surfaces(fine, coarse, faces, model);
  for (Index e = 0; e < moved.boundary.cols(); ++e)
    for (const int v : moved.boundary.col(e)) {
      const Vector3d x = moved.vertices.col(v);
      const int label = moved.boundary_label[e];
      if (label == low_y || label == high_y) {
        EXPECT_NEAR(x.head<2>().norm(), label == low_y ? 3 : 4, 2e-3);
      } else if (label == low_z || label == high_z) {
        EXPECT_NEAR(x.z(), label == low_z ? 0 : -2, 1e-14);
      } else if (label == low_x) {
        EXPECT_NEAR(x.y(), 0, 1e-14);
      }
    }
}

TEST(MovedOntoSurfaces, goes_on_beyond_labels_however_their_lines_turn) {
  // the tube once more: chords of the staircase, and its last faces at the rims
  constexpr int n = 4;
  const Vector3d sides(pi / 4, 1, 2);
  SolidMesh coarse = brick({n, n, n}, sides);
  put_stairs(n, sides, coarse);
  for (auto x : coarse.vertices.colwise())
    x = Vector3d((3 + x.y()) * std::cos(x.x()), (3 + x.y()) * std::sin(x.x()),
                 -x.z());
  const Facets<3> faces = facets_of(coarse);
  const SurfaceModel model =
      surface_model(coarse, faces, VectorXi::Zero(coarse.cell_count()), pi / 6);
  ModelMesh fine = finer_mesh(n, coarse, model, true);
  put_lines(coarse, model, fine);
  const SolidMesh moved = moved_onto_surfaces(fine, coarse, faces, model);
  for (Index e = 0; e < moved.boundary.cols(); ++e)
    for (const int v : moved.boundary.col(e)) {
      const int label = moved.boundary_label[e];
      if (label == high_y || label == behind_stairs) {
        EXPECT_NEAR(moved.vertices.col(v).head<2>().norm(), 4, 2e-3);
      } else if (label == low_z || label == high_z) {
        EXPECT_NEAR(moved.vertices(2, v), label == low_z ? 0 : -2, 1e-14);
      }
    }
}

}  // namespace
}  // namespace ffcontact
