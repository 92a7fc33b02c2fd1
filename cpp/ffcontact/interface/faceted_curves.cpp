// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/faceted_curves.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/interface/boundary_chains.hpp"
#include "ffcontact/mesh/straight_runs.hpp"

namespace ffcontact {

namespace {

constexpr int least_count = 5;
constexpr double sharpest_turn = 29 * M_PI / 180;

/// The normals of a line on its mesh edges.
std::map<int, Vector2d> normals_on_edges(const ContactLine& line) {
  std::map<int, Vector2d> normals;
  for (int e = 0; e < line.edge_count(); ++e)
    normals[line.edge[e]] = line.edge_normal(e);
  return normals;
}

Matrix2Xd points_of(const Mesh& mesh, const Edges& edges,
                    const std::vector<int>& chain) {
  std::vector<int> vertices{edges.vertices(0, chain.front())};
  for (int edge : chain) vertices.push_back(edges.vertices(1, edge));
  return mesh.vertices(Eigen::all, vertices);
}

/// What a line makes of a part of a chain that is a smooth curve.
std::optional<FacetedCurve> polygon_on(const std::vector<int>& chain,
                                       const LinePart& part,
                                       const Matrix2Xd& points,
                                       const std::map<int, Vector2d>& normals) {
  const auto normal = [&](int k) {
    return entry_of(normals, chain[k], "normal on a contact edge");
  };
  FacetedCurve curve{chain[(part.first + part.last) / 2], part.edges(), 0};
  int corners = 0;
  for (int k = part.first + 1; k < part.last; ++k) {
    if (normal(k - 1) != normal(k)) ++corners;
    curve.largest_turn =
        std::max(curve.largest_turn, turn_at(points, k - 1, k, k + 1));
  }
  if (2 * corners < part.edges() - 1) return std::nullopt;
  return curve;
}

}  // namespace

std::vector<FacetedCurve> faceted_curves(const Mesh& mesh, const Edges& edges,
                                         const ContactLine& line) {
  const std::map<int, Vector2d> normals = normals_on_edges(line);
  const std::vector<int> boundary(line.edge.begin(), line.edge.end());
  const double tolerance =
      straight_tolerance(line.precision, extent(mesh.vertices));
  std::vector<FacetedCurve> curves;
  for (const std::vector<int>& chain : boundary_chains(mesh, edges, boundary)) {
    const Matrix2Xd points = points_of(mesh, edges, chain);
    for (const LinePart& part :
         line_parts(points, tolerance, sharpest_turn, least_count)) {
      if (part.straight) continue;
      if (auto curve = polygon_on(chain, part, points, normals))
        curves.push_back(*curve);
    }
  }
  return curves;
}

}  // namespace ffcontact
