// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/face_moments.hpp"

#include <algorithm>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

namespace {

/// A face at a vertex, between two tetrahedra of the star.
struct StarArc {
  int face;
  int from;  ///< place in the star of cells(0), whose outward normal is the face's
  int to;   ///< of cells(1), or -1 on the boundary
  int row;  ///< of the vertex in FaceMoments
  double area;
};

/// The balance of a star as a graph.
class StarGraph {
 public:
  StarGraph(const SolidTopology& topology, int vertex)
      : size_(topology.stars.count(vertex)), part_(size_) {
    for (int k = 0; k < size_; ++k) add_arcs(topology, vertex, k);
    find_parts();
  }

  const std::vector<StarArc>& arcs() const { return arcs_; }
  int size() const { return size_; }

  /// N W N' for one component, regular: parts of the star that no free boundary face ends
  /// have the constants in their kernel, which their mean takes.
  Cholesky laplacian(const FaceTractions& boundary, int component) const {
    MatrixXd matrix = MatrixXd::Zero(size_, size_);
    Flags ended(size_, 0);
    for (const StarArc& arc : arcs_) {
      if (boundary.known(component, arc.face)) continue;
      matrix(arc.from, arc.from) += arc.area;
      if (arc.to < 0) {
        ended[part_[arc.from]] = 1;
        continue;
      }
      matrix(arc.to, arc.to) += arc.area;
      matrix(arc.from, arc.to) -= arc.area;
      matrix(arc.to, arc.from) -= arc.area;
    }
    double scale = matrix.diagonal().mean() / size_;
    if (scale == 0) scale = 1;
    for (int i = 0; i < size_; ++i)
      for (int j = 0; j < size_; ++j)
        if (part_[i] == part_[j] && !ended[part_[i]]) matrix(i, j) += scale;
    return Cholesky(matrix);
  }

 private:
  void add_arcs(const SolidTopology& topology, int vertex, int k) {
    const auto& [mesh, faces, edges, stars] = topology;
    const int first = stars.start[vertex], t = stars.cell[first + k];
    for (int j = 1; j < 4; ++j) {
      const int face = faces.of_cell((stars.local[first + k] + j) % 4, t);
      if (faces.cells(0, face) != t) continue;
      const auto cells = stars.cell.begin() + first;
      const auto other = std::find(cells, cells + size_, faces.cells(1, face));
      arcs_.push_back(
          {face, k,
           faces.on_boundary(face) ? -1 : static_cast<int>(other - cells),
           3 * faces.place_of(vertex, face), facet_measure(mesh, faces, face)});
    }
  }

  /// The lowest tetrahedron that each of them hangs together with.
  void find_parts() {
    for (int k = 0; k < size_; ++k) part_[k] = k;
    for (bool changed = true; changed;) {
      changed = false;
      for (const StarArc& arc : arcs_) {
        if (arc.to < 0 || part_[arc.from] == part_[arc.to]) continue;
        part_[arc.from] = part_[arc.to] =
            std::min(part_[arc.from], part_[arc.to]);
        changed = true;
      }
    }
  }

  int size_;
  std::vector<StarArc> arcs_;
  std::vector<int> part_;
};

/// A/3 (mean of both stresses) n.
Vector3d mean_moment(const SolidTopology& topology, const StarArc& arc,
                     const Ref<const Matrix6Xd>& stress) {
  const Vector2i sides = topology.faces.cells.col(arc.face);
  VoigtVector<3> mean = stress.col(sides[0]);
  if (sides[1] >= 0) mean = 0.5 * (mean + stress.col(sides[1]));
  return arc.area / 3 *
         traction(mean, facet_normal(topology.mesh, topology.faces, arc.face));
}

bool same_known(const std::vector<StarArc>& arcs, const FaceTractions& boundary,
                int component, int other) {
  return std::all_of(arcs.begin(), arcs.end(), [&](const StarArc& arc) {
    return boundary.known(component, arc.face) ==
           boundary.known(other, arc.face);
  });
}

/// The moments of the faces at one vertex.
void put_star(const SolidTopology& topology, int vertex,
              const Ref<const Matrix6Xd>& stress,
              const SolidBodyLoadsOfAll& body_loads,
              const FaceTractions& boundary, FaceMoments& moments) {
  const StarGraph graph(topology, vertex);
  const auto z = [&](const StarArc& arc) {
    return moments.col(arc.face).segment<3>(arc.row);
  };
  // q - N z0, with what is known in place of z0
  Matrix3Xd left = star_loads(topology, vertex, stress, body_loads);
  for (const StarArc& arc : graph.arcs()) {
    const Vector3d mean = mean_moment(topology, arc, stress);
    for (int c = 0; c < 3; ++c)
      if (!boundary.known(c, arc.face)) z(arc)[c] = mean[c];
    left.col(arc.from) -= z(arc);
    if (arc.to >= 0) left.col(arc.to) += z(arc);
  }

  Cholesky laplacian;
  for (int c = 0; c < 3; ++c) {
    if (c == 0 || !same_known(graph.arcs(), boundary, c, c - 1))
      laplacian = graph.laplacian(boundary, c);
    const VectorXd y = laplacian.solve(left.row(c).transpose());
    for (const StarArc& arc : graph.arcs())
      if (!boundary.known(c, arc.face))
        z(arc)[c] += arc.area * (y[arc.from] - (arc.to < 0 ? 0 : y[arc.to]));
  }
}

}  // namespace

FaceMoments equilibrated_moments(const SolidTopology& topology,
                                 const Ref<const Matrix6Xd>& stress,
                                 const SolidBodyLoadsOfAll& body_loads,
                                 const FaceTractions& boundary) {
  FaceMoments moments = boundary.moments;
#pragma omp parallel for
  for (int v = 0; v < topology.mesh.vertex_count(); ++v)
    if (topology.stars.count(v) > 0)
      put_star(topology, v, stress, body_loads, boundary, moments);
  return moments;
}

}  // namespace ffcontact
