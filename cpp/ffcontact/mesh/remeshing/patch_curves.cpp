// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/patch_curves.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// Turns below which edges are on one straight line, and above which a straight line
/// ends [rad].
constexpr double straight = 0.1 * M_PI / 180, bent = M_PI / 180;

/// An edge of a curve.
struct Link {
  std::array<int, 2> vertices;
  std::vector<int> patches;
  bool is_rim, is_label_line;
  bool done = false;

  int beyond(int v) const { return vertices[vertices[0] == v ? 1 : 0]; }
};

std::vector<Link> links_of(const std::vector<DividingEdge>& edges,
                           const SurfacePatches& patches) {
  std::vector<Link> links;
  for (int e = 0; e < count_of(edges); ++e) {
    const DividingEdge& edge = edges[e];
    std::vector<int> around, surfaces;
    for (const int k : edge.faces) {
      around.push_back(patches.patch[k]);
      surfaces.push_back(patches.surface[k]);
    }
    std::sort(around.begin(), around.end());
    if (around.size() == 2 && around[0] == around[1]) continue;
    const bool is_rim = surfaces.size() != 2 || surfaces[0] != surfaces[1];
    links.push_back(
        {edge.vertices, around, is_rim, patches.is_label_line[e] != 0});
  }
  return links;
}

class CurveFinder {
 public:
  CurveFinder(const SolidMesh& mesh, std::vector<Link> links, double corner)
      : mesh_(mesh), links_(std::move(links)) {
    for (int k = 0; k < count_of(links_); ++k)
      for (const int v : links_[k].vertices) at_[v].push_back(k);
    for (const auto& [v, links] : at_)
      is_corner_[v] = ends_at(v) || turns_at(v, corner);
  }

  PatchCurves curves() {
    PatchCurves result;
    for (const auto& [v, links] : at_)
      if (is_corner_[v])
        for (const int k : links)
          if (!links_[k].done) result.curves.push_back(curve_from(v, k));
    for (int k = 0; k < count_of(links_); ++k)
      if (!links_[k].done) {
        is_corner_[links_[k].vertices[0]] = true;
        result.curves.push_back(curve_from(links_[k].vertices[0], k));
      }
    for (const auto& [v, is] : is_corner_)
      if (is) result.corners.push_back(v);
    return result;
  }

 private:
  const std::vector<int>& links_at(int v) const {
    return entry_of(at_, v, "link at a vertex");
  }

  bool ends_at(int v) const {
    const std::vector<int>& links = links_at(v);
    return links.size() != 2 ||
           links_[links[0]].patches != links_[links[1]].patches;
  }

  Vector3d direction(int from, int to) const {
    return (mesh_.vertices.col(to) - mesh_.vertices.col(from)).normalized();
  }

  /// Angle by which links turn at v, where two of them meet [rad].
  double turn(int v) const {
    const std::vector<int>& links = links_at(v);
    const Vector3d in = direction(links_[links[0]].beyond(v), v),
                   out = direction(v, links_[links[1]].beyond(v));
    return 2 * std::atan2((in - out).norm(), (in + out).norm());
  }

  /// Does a straight line of several links end at v?
  bool is_beside_straight(int v) const {
    for (const int k : links_at(v)) {
      const int w = links_[k].beyond(v);
      if (!ends_at(w) && turn(w) < straight) return true;
    }
    return false;
  }

  /// The cuts of a surface are rugged, and have no corners.
  bool turns_at(int v, double corner) const {
    if (ends_at(v) || !links_[links_at(v)[0]].is_rim) return false;
    const double angle = turn(v);
    return angle > corner || (angle > bent && is_beside_straight(v));
  }

  PatchCurve curve_from(int v, int k) {
    PatchCurve curve{{v}, links_[k].patches, links_[k].is_rim, true};
    const int first = v;
    while (true) {
      links_[k].done = true;
      curve.is_label_line = curve.is_label_line && links_[k].is_label_line;
      v = links_[k].beyond(v);
      curve.vertices.push_back(v);
      if (is_corner_[v] || v == first) return curve;
      const std::vector<int>& links = at_[v];
      k = links[links[0] == k ? 1 : 0];
    }
  }

  const SolidMesh& mesh_;
  std::vector<Link> links_;
  std::map<int, std::vector<int>> at_;  ///< links of each vertex
  std::map<int, bool> is_corner_;
};

}  // namespace

PatchCurves patch_curves(const SolidMesh& mesh,
                         const std::vector<DividingEdge>& edges,
                         const SurfacePatches& patches, double corner) {
  return CurveFinder(mesh, links_of(edges, patches), corner).curves();
}

}  // namespace ffcontact
