// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/cut_mesh.hpp"

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

std::vector<int> vertices_along(const CutEdge& places) {
  std::vector<int> vertices;
  for (const auto& [place, vertex] : places) vertices.push_back(vertex);
  return vertices;
}

/// x = (1 - place) x_first + place x_second at the new vertices.
void put_vertices(const Mesh& old, const Edges& edges, const EdgeCuts& cuts,
                  CutMesh& result) {
  std::vector<Vector2d> vertices;
  Triplets weights;
  for (int v = 0; v < old.vertex_count(); ++v) {
    vertices.push_back(old.vertices.col(v));
    weights.emplace_back(v, v, 1.0);
  }
  for (const auto& [edge, places] : cuts.of_edge)
    for (const auto& [place, vertex] : places) {
      if (vertex < old.vertex_count()) continue;
      const int first = edges.vertices(0, edge),
                second = edges.vertices(1, edge);
      vertices.push_back((1 - place) * old.vertices.col(first) +
                         place * old.vertices.col(second));
      weights.emplace_back(vertex, first, 1 - place);
      weights.emplace_back(vertex, second, place);
    }
  result.mesh.vertices = packed(vertices);
  result.vertex_weights = packed<WeightsByNode>(result.mesh.vertices.cols(),
                                                old.vertices.cols(), weights);
}

/// Triangles while their edges are cut one after the other.
class Fans {
 public:
  explicit Fans(const Mesh& old) {
    for (int t = 0; t < old.cell_count(); ++t) add(old.cells.col(t), t);
  }

  /// Replaces the part of an old triangle that lies on an edge by a fan. The edge has its
  /// triangle on the left.
  void cut(int old_triangle, const std::vector<int>& along) {
    std::vector<int>& parts =
        parts_.try_emplace(old_triangle, 1, old_triangle).first->second;
    for (int part : parts)
      for (int k = 0; k < 3; ++k) {
        const Vector3i triangle = triangles_[part];
        if (triangle[k] != along.front() ||
            triangle[(k + 1) % 3] != along.back())
          continue;
        const int apex = triangle[(k + 2) % 3];
        triangles_[part] = Vector3i(along[0], along[1], apex);
        add_others(old_triangle, along, apex, parts);
        return;
      }
  }

  void put(CutMesh& result) const {
    result.mesh.cells = packed(triangles_);
    result.parent = packed(parent_);
  }

 private:
  int add(const Vector3i& triangle, int parent) {
    triangles_.push_back(triangle);
    parent_.push_back(parent);
    return count_of(triangles_) - 1;
  }

  /// All triangles of a fan but the first.
  void add_others(int parent, const std::vector<int>& along, int apex,
                  std::vector<int>& parts) {
    for (std::size_t k = 1; k + 1 < along.size(); ++k)
      parts.push_back(add(Vector3i(along[k], along[k + 1], apex), parent));
  }

  std::vector<Vector3i> triangles_;
  std::vector<int> parent_;
  /// triangles that an old triangle was cut into
  std::map<int, std::vector<int>> parts_;
};

void put_triangles(const Mesh& old, const Edges& edges, const EdgeCuts& cuts,
                   CutMesh& result) {
  Fans fans(old);
  for (const auto& [edge, places] : cuts.of_edge)
    if (places.size() > 2)
      fans.cut(edges.cells(0, edge), vertices_along(places));
  fans.put(result);
}

/// The vertices along each column of the old boundary.
std::vector<std::vector<int>> along_columns(const Mesh& old, const Edges& edges,
                                            const EdgeCuts& cuts) {
  std::vector<std::vector<int>> along;
  for (int b = 0; b < old.boundary.cols(); ++b)
    along.push_back({old.boundary(0, b), old.boundary(1, b)});
  for (const auto& [edge, places] : cuts.of_edge)
    along[edges.boundary_index[edge]] = vertices_along(places);
  return along;
}

void put_boundary(const Mesh& old, const Edges& edges, const EdgeCuts& cuts,
                  CutMesh& result) {
  const auto along = along_columns(old, edges, cuts);
  std::vector<Vector2i> boundary;
  std::vector<int> parent;
  for (std::size_t b = 0; b < along.size(); ++b)
    for (std::size_t k = 0; k + 1 < along[b].size(); ++k) {
      boundary.emplace_back(along[b][k], along[b][k + 1]);
      parent.push_back(static_cast<int>(b));
    }
  result.mesh.boundary = packed(boundary);
  result.parent_boundary = packed(parent);
  result.mesh.boundary_label = old.boundary_label(parent);
}

}  // namespace

CutMesh cut_mesh(const Mesh& mesh, const Edges& edges, const EdgeCuts& cuts) {
  CutMesh result;
  result.mesh.origin = mesh.origin;
  put_vertices(mesh, edges, cuts, result);
  put_triangles(mesh, edges, cuts, result);
  put_boundary(mesh, edges, cuts, result);
  return result;
}

}  // namespace ffcontact
