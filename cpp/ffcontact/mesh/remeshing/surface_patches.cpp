// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/surface_patches.hpp"

#include <array>
#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/unions.hpp"
#include "ffcontact/mesh/remeshing/surface_cuts.hpp"

namespace ffcontact {

namespace {

/// cos of the turn below which faces are coplanar: 0.1 degrees
const double coplanar_cosine = std::cos(0.1 * M_PI / 180);

class SurfaceFinder {
 public:
  SurfaceFinder(const SolidMesh& mesh, const Facets<3>& faces,
                const DividingFaces& dividing,
                const std::vector<DividingEdge>& edges)
      : mesh_(mesh),
        faces_(faces),
        dividing_(dividing),
        edges_(edges),
        normal_(3, dividing.count()) {
    for (int k = 0; k < dividing.count(); ++k)
      normal_.col(k) = facet_normal(mesh, faces, dividing.face[k]);
  }

  /// The surface of each face.
  std::vector<int> surfaces(double corner) const {
    const std::vector<int> plane = planes();
    Unions surfaces(dividing_.count());
    for (const DividingEdge& edge : edges_)
      if (goes_on(edge, std::cos(corner)) &&
          plane[edge.faces[0]] == plane[edge.faces[1]])
        surfaces.join(edge.faces[0], edge.faces[1]);
    return surfaces.numbers();
  }

  /// Whether all faces of each surface are coplanar with its first.
  Flags flat(const std::vector<int>& surface) const {
    Flags result;
    std::vector<int> first;
    for (int k = 0; k < dividing_.count(); ++k) {
      if (surface[k] == count_of(result)) {
        result.push_back(1);
        first.push_back(k);
      }
      if (cosine(first[surface[k]], k) < coplanar_cosine)
        result[surface[k]] = 0;
    }
    return result;
  }

  /// The sheet of each surface: smooth ones that were one if they had one label.
  std::vector<int> sheets(const SurfacePatches& patches, double corner) const {
    const Flags plane = certain_planes(patches);
    Unions sheets(patches.surface_count());
    for (const DividingEdge& edge : edges_) {
      if (!turns_less(edge, std::cos(corner))) continue;
      const auto [s, t] = surfaces_at(edge, patches);
      if (!plane[s] && !plane[t]) sheets.join(s, t);
    }
    return sheets.numbers();
  }

  /// The edges at which a sheet that is no plane changes its label.
  Flags label_lines(const SurfacePatches& patches) const {
    Flags result;
    for (const DividingEdge& edge : edges_)
      result.push_back(edge.faces.size() == 2 && parts_sheet(edge, patches));
    return result;
  }

 private:
  /// Whatever labels there are on both sides.
  bool turns_less(const DividingEdge& edge, double least_cosine) const {
    if (edge.faces.size() != 2) return false;
    const int a = edge.faces[0], b = edge.faces[1];
    return same_parts(a, b) && cosine(a, b) > least_cosine;
  }

  static std::array<int, 2> surfaces_at(const DividingEdge& edge,
                                        const SurfacePatches& patches) {
    return {patches.surface[edge.faces[0]], patches.surface[edge.faces[1]]};
  }

  static bool parts_sheet(const DividingEdge& edge,
                          const SurfacePatches& patches) {
    const auto [s, t] = surfaces_at(edge, patches);
    return s != t && !patches.flat[s] && patches.sheet[s] == patches.sheet[t];
  }

  /// A single face says nothing of what it is a part of.
  static Flags certain_planes(const SurfacePatches& patches) {
    Flags result = patches.flat;
    std::vector<int> faces(patches.surface_count(), 0);
    for (const int s : patches.surface) ++faces[s];
    for (int s = 0; s < patches.surface_count(); ++s)
      if (faces[s] == 1) result[s] = 0;
    return result;
  }

  bool same_parts(int a, int b) const {
    const auto p = dividing_.parts.col(a), q = dividing_.parts.col(b);
    return p == q || p == q.reverse();
  }

  int label(int k) const { return mesh_.boundary_label[dividing_.boundary[k]]; }

  /// Up to the side that normals point to.
  double cosine(int a, int b) const {
    const double product = normal_.col(a).dot(normal_.col(b));
    return dividing_.parts.col(a) == dividing_.parts.col(b) ? product
                                                            : -product;
  }

  bool same_kind(int a, int b) const {
    if (!same_parts(a, b)) return false;
    if (dividing_.boundary[a] < 0 || dividing_.boundary[b] < 0)
      return dividing_.boundary[a] < 0 && dividing_.boundary[b] < 0;
    return label(a) == label(b);
  }

  bool goes_on(const DividingEdge& edge, double least_cosine) const {
    return edge.faces.size() == 2 && same_kind(edge.faces[0], edge.faces[1]) &&
           cosine(edge.faces[0], edge.faces[1]) > least_cosine;
  }

  /// The plane of each face, -1 for those of none.
  std::vector<int> planes() const {
    Unions sets(dividing_.count());
    for (const DividingEdge& edge : edges_)
      if (goes_on(edge, coplanar_cosine))
        sets.join(edge.faces[0], edge.faces[1]);
    // the set of all faces at a vertex, or -2
    std::vector<int> around(mesh_.vertex_count(), -1);
    for (int k = 0; k < dividing_.count(); ++k)
      for (const int v : faces_.vertices.col(dividing_.face[k]))
        around[v] =
            around[v] == -1 || around[v] == sets.root(k) ? sets.root(k) : -2;
    Flags is_plane(dividing_.count(), 0);
    for (const int set : around)
      if (set >= 0) is_plane[set] = 1;
    std::vector<int> plane(dividing_.count(), -1);
    for (int k = 0; k < dividing_.count(); ++k)
      if (is_plane[sets.root(k)]) plane[k] = sets.root(k);
    return plane;
  }

  const SolidMesh& mesh_;
  const Facets<3>& faces_;
  const DividingFaces& dividing_;
  const std::vector<DividingEdge>& edges_;
  Matrix3Xd normal_;
};

/// A surface is flat where all of its sheet is.
Flags flat_with_sheet(const SurfacePatches& patches) {
  Flags sheet(patches.surface_count(), 1), result;
  for (int s = 0; s < patches.surface_count(); ++s)
    if (!patches.flat[s]) sheet[patches.sheet[s]] = 0;
  for (const int of : patches.sheet) result.push_back(sheet[of]);
  return result;
}

}  // namespace

SurfacePatches surface_patches(const SolidMesh& mesh, const Facets<3>& faces,
                               const DividingFaces& dividing,
                               const std::vector<DividingEdge>& edges,
                               double corner) {
  const SurfaceFinder finder(mesh, faces, dividing, edges);
  SurfacePatches result;
  result.surface = finder.surfaces(corner);
  result.flat = finder.flat(result.surface);
  result.sheet = finder.sheets(result, corner);
  result.flat = flat_with_sheet(result);
  result.is_label_line = finder.label_lines(result);
  std::vector<std::vector<int>> members(result.surface_count());
  for (int k = 0; k < dividing.count(); ++k)
    members[result.surface[k]].push_back(k);
  const auto patches = patches_of(mesh, faces, dividing, edges, members);
  result.patch.resize(dividing.count());
  for (int s = 0; s < result.surface_count(); ++s)
    for (const std::vector<int>& patch : patches[s]) {
      for (const int k : patch) result.patch[k] = result.patch_count();
      result.surface_of_patch.push_back(s);
    }
  return result;
}

}  // namespace ffcontact
