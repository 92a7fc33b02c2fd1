// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/surface_cuts.hpp"

#include <array>
#include <map>
#include <set>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/unions.hpp"

namespace ffcontact {

namespace {

/// A patch of one rim whose normals sum up to less than this part of its area is nearly
/// closed, a ball with a small hole.
constexpr double nearly_closed = 0.3;

/// Cuts surfaces until every piece is a patch.
class PatchCutter {
 public:
  PatchCutter(const SolidMesh& mesh, const Facets<3>& faces,
              const DividingFaces& dividing,
              const std::vector<DividingEdge>& edges)
      : mesh_(mesh), faces_(faces), dividing_(dividing), edges_(edges) {
    edges_of_face_.resize(dividing.count());
    for (int e = 0; e < count_of(edges); ++e)
      for (const int k : edges[e].faces) edges_of_face_[k].push_back(e);
  }

  /// The patches of a surface.
  std::vector<std::vector<int>> patches(const std::vector<int>& surface) const {
    std::vector<std::vector<int>> left = {surface}, done;
    while (!left.empty()) {
      const std::vector<int> piece = left.back();
      left.pop_back();
      if (is_patch(piece))
        done.push_back(piece);
      else
        for (const std::vector<int>& half : halves(piece))
          for (std::vector<int>& part : connected(half))
            left.push_back(std::move(part));
    }
    return done;
  }

 private:
  using Piece = FaceNumbers;

  Vector3i vertices(int k) const {
    return faces_.vertices.col(dividing_.face[k]);
  }
  Vector3d centroid(int k) const {
    const Vector3i v = vertices(k);
    return mesh_.vertices(Eigen::all, v).rowwise().mean();
  }

  /// How many faces of the piece each of its edges has.
  std::map<int, int> uses_of_edges(const Piece& piece) const {
    std::map<int, int> uses;
    for (const int k : piece)
      for (const int e : edges_of_face_[k]) ++uses[e];
    return uses;
  }

  bool is_patch(const Piece& piece) const {
    const std::map<int, int> uses = uses_of_edges(piece);
    std::set<int> all_vertices;
    for (const int k : piece)
      for (const int v : vertices(k)) all_vertices.insert(v);
    std::map<int, int> rim_edges;  // of each vertex of the rim
    std::map<int, int> number;
    std::vector<std::array<int, 2>> rim;
    for (const auto& [e, count] : uses)
      if (count == 1) rim.push_back(edges_[e].vertices);
    for (const auto& edge : rim)
      for (const int v : edge) {
        ++rim_edges[v];
        number.emplace(v, count_of(number));
      }
    for (const auto& [v, count] : rim_edges)
      if (count != 2) return false;
    Unions loops(count_of(number));
    for (const auto& edge : rim) loops.join(number[edge[0]], number[edge[1]]);
    std::set<int> roots;
    for (int i = 0; i < count_of(number); ++i) roots.insert(loops.root(i));
    const int rims = count_of(roots),
              euler = count_of(all_vertices) - count_of(uses) + count_of(piece);
    if (euler != 2 - rims) return false;
    return rims > 1 || !is_nearly_closed(piece);
  }

  bool is_nearly_closed(const Piece& piece) const {
    Vector3d sum = Vector3d::Zero();
    double area = 0;
    const Vector2i parts = dividing_.parts.col(piece[0]);
    for (const int k : piece) {
      const Matrix3d corners = mesh_.vertices(Eigen::all, vertices(k));
      const Vector3d vector = facet_vector(corners);
      sum += dividing_.parts.col(k) == parts ? vector : Vector3d(-vector);
      area += vector.norm();
    }
    return sum.norm() < nearly_closed * area;
  }

  /// On both sides of the middle of the longest extent.
  std::array<Piece, 2> halves(const Piece& piece) const {
    Matrix3Xd places(3, count_of(piece));
    for (int i = 0; i < count_of(piece); ++i)
      places.col(i) = centroid(piece[i]);
    const Vector3d low = places.rowwise().minCoeff(),
                   high = places.rowwise().maxCoeff();
    Index axis;
    (high - low).maxCoeff(&axis);
    const double middle = (low[axis] + high[axis]) / 2;
    std::array<Piece, 2> result;
    for (int i = 0; i < count_of(piece); ++i)
      result[places(axis, i) > middle].push_back(piece[i]);
    return result;
  }

  std::vector<Piece> connected(const Piece& piece) const {
    std::map<int, int> first_at;  // face of each edge
    Unions sets(count_of(piece));
    for (int i = 0; i < count_of(piece); ++i)
      for (const int e : edges_of_face_[piece[i]]) {
        const auto [found, is_new] = first_at.emplace(e, i);
        if (!is_new) sets.join(found->second, i);
      }
    const std::vector<int> number = sets.numbers();
    std::vector<Piece> result;
    for (int i = 0; i < count_of(piece); ++i) {
      if (number[i] == count_of(result)) result.emplace_back();
      result[number[i]].push_back(piece[i]);
    }
    return result;
  }

  const SolidMesh& mesh_;
  const Facets<3>& faces_;
  const DividingFaces& dividing_;
  const std::vector<DividingEdge>& edges_;
  std::vector<std::vector<int>> edges_of_face_;
};

}  // namespace

std::vector<std::vector<FaceNumbers>> patches_of(
    const SolidMesh& mesh, const Facets<3>& faces,
    const DividingFaces& dividing, const std::vector<DividingEdge>& edges,
    const std::vector<FaceNumbers>& surfaces) {
  const PatchCutter cutter(mesh, faces, dividing, edges);
  std::vector<std::vector<FaceNumbers>> patches;
  for (const FaceNumbers& surface : surfaces)
    patches.push_back(cutter.patches(surface));
  return patches;
}

}  // namespace ffcontact
