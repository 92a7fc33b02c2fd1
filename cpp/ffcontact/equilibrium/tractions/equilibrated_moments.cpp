// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/equilibrated_moments.hpp"

#include <algorithm>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

namespace {

/// A facet at a vertex, between two cells of the star.
struct StarArc {
  int facet;
  int from;  ///< place in the star of cells(0), whose outward normal is the facet's
  int to;   ///< of cells(1), or -1 on the boundary
  int row;  ///< of the vertex among the moments of the facet
  double weight;
};

/// The balance of a star as a graph.
template <int d>
class StarGraph {
 public:
  StarGraph(const Topology<d>& topology, int vertex)
      : size_(topology.stars.count(vertex)), part_(size_) {
    for (int k = 0; k < size_; ++k) add_arcs(topology, vertex, k);
    find_parts();
  }

  const std::vector<StarArc>& arcs() const { return arcs_; }
  int size() const { return size_; }

  /// N W N' for one component, regular: parts of the star that no free boundary facet ends
  /// have the constants in their kernel, which their mean takes.
  Cholesky laplacian(const FacetTractions<d>& boundary, int component) const {
    MatrixXd matrix = MatrixXd::Zero(size_, size_);
    Flags ended(size_, 0);
    for (const StarArc& arc : arcs_) {
      if (boundary.known(component, arc.facet)) continue;
      matrix(arc.from, arc.from) += arc.weight;
      if (arc.to < 0) {
        ended[part_[arc.from]] = 1;
        continue;
      }
      matrix(arc.to, arc.to) += arc.weight;
      matrix(arc.from, arc.to) -= arc.weight;
      matrix(arc.to, arc.from) -= arc.weight;
    }
    double scale = matrix.diagonal().mean() / size_;
    if (scale == 0) scale = 1;
    for (int i = 0; i < size_; ++i)
      for (int j = 0; j < size_; ++j)
        if (part_[i] == part_[j] && !ended[part_[i]]) matrix(i, j) += scale;
    return Cholesky(matrix);
  }

 private:
  void add_arcs(const Topology<d>& topology, int vertex, int k) {
    const auto& [mesh, facets, ridges, stars] = topology;
    const int first = stars.start[vertex], t = stars.cell[first + k];
    for (int j = 1; j <= d; ++j) {
      const int facet =
          facets.of_cell((stars.local[first + k] + j) % (d + 1), t);
      if (facets.cells(0, facet) != t) continue;
      const auto cells = stars.cell.begin() + first;
      const auto other =
          std::find(cells, cells + size_, facets.cells(1, facet));
      arcs_.push_back(
          {facet, k,
           facets.on_boundary(facet) ? -1 : static_cast<int>(other - cells),
           d * facets.place_of(vertex, facet), weight(mesh, facets, facet)});
    }
  }
  static double weight(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                       int facet) {
    const double area = facet_measure(mesh, facets, facet);
    if constexpr (d == 3) {
      return area;
    } else {
      double beside = 0;
      for (int t : facets.cells.col(facet))
        if (t >= 0) beside += signed_area(mesh, t);
      return area * area / beside;
    }
  }

  /// The lowest cell that each of them hangs together with.
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

/// A/d (mean of both stresses) n.
template <int d>
VectorOf<d> mean_moment(const Topology<d>& topology, int facet,
                        const CellStresses<d>& stress) {
  const Vector2i sides = topology.facets.cells.col(facet);
  VoigtVector<d> mean = stress.col(sides[0]);
  if (sides[1] >= 0) mean = 0.5 * (mean + stress.col(sides[1]));
  const auto& [mesh, facets, ridges, stars] = topology;
  return traction(mean, facet_vector(facet_points(mesh, facets, facet)) / d);
}

template <int d>
bool same_known(const std::vector<StarArc>& arcs,
                const FacetTractions<d>& boundary, int component, int other) {
  return std::all_of(arcs.begin(), arcs.end(), [&](const StarArc& arc) {
    return boundary.known(component, arc.facet) ==
           boundary.known(other, arc.facet);
  });
}

/// The moments of the facets at one vertex.
template <int d>
void put_star(const Topology<d>& topology, int vertex,
              const CellStresses<d>& stress,
              const BodyLoadsOfCells<d>& body_loads,
              const FacetTractions<d>& boundary, FacetColumns<d>& moments) {
  const StarGraph<d> graph(topology, vertex);
  const auto z = [&](const StarArc& arc) {
    return moments.col(arc.facet).template segment<d>(arc.row);
  };
  // q - N z0, with what is known in place of z0
  Matrix<double, d, Dynamic> left =
      star_loads(topology, vertex, stress, body_loads);
  for (const StarArc& arc : graph.arcs()) {
    const VectorOf<d> mean = mean_moment(topology, arc.facet, stress);
    for (int c = 0; c < d; ++c)
      if (!boundary.known(c, arc.facet)) z(arc)[c] = mean[c];
    left.col(arc.from) -= z(arc);
    if (arc.to >= 0) left.col(arc.to) += z(arc);
  }

  Cholesky laplacian;
  for (int c = 0; c < d; ++c) {
    if (c == 0 || !same_known<d>(graph.arcs(), boundary, c, c - 1))
      laplacian = graph.laplacian(boundary, c);
    const VectorXd y = laplacian.solve(left.row(c).transpose());
    for (const StarArc& arc : graph.arcs())
      if (!boundary.known(c, arc.facet))
        z(arc)[c] += arc.weight * (y[arc.from] - (arc.to < 0 ? 0 : y[arc.to]));
  }
}

}  // namespace

template <int d>
FacetColumns<d> equilibrated_moments(const Topology<d>& topology,
                                     const CellStresses<d>& stress,
                                     const BodyLoadsOfCells<d>& body_loads,
                                     const FacetTractions<d>& boundary) {
  FacetColumns<d> moments = boundary.moments;
#pragma omp parallel for
  for (int v = 0; v < topology.mesh.vertex_count(); ++v)
    if (topology.stars.count(v) > 0)
      put_star(topology, v, stress, body_loads, boundary, moments);
  return moments;
}

template FacetColumns<FFCONTACT_DIMENSION> equilibrated_moments(
    const Topology<FFCONTACT_DIMENSION>&,
    const CellStresses<FFCONTACT_DIMENSION>&,
    const BodyLoadsOfCells<FFCONTACT_DIMENSION>&,
    const FacetTractions<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
