// SPDX-License-Identifier: GPL-3.0-or-later
// What the contact of a cube of n x n x n bricks that stands on one side takes: counted, not
// measured, but for the rate of the factorisation. The last rows go on as the counts
// before them do.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/elastic/factor/partial_cholesky.hpp"
#include "ffcontact/equilibrium/relaxation/facet_descent.hpp"
#include "ffcontact/parallel/topology_part.hpp"
#include "support/solids.hpp"

namespace ffcontact::bench {

/// Of vertices, those that stand on something last.
struct OrderedGraph {
  SparseMatrix lower;
  int kept;
};

OrderedGraph ordered_graph(const Topology<3>& topology) {
  const auto& [mesh, faces, edges, stars] = topology;
  const int count = mesh.vertex_count();
  std::vector<int> inside, order, kept;
  std::vector<int> place(count, -1);
  for (int v = 0; v < count; ++v)
    if (mesh.vertices(2, v) > 0) {
      place[v] = count_of(inside);
      inside.push_back(v);
    } else {
      kept.push_back(v);
    }
  std::vector<std::vector<int>> beside(inside.size());
  for (const auto& ends : edges.vertices.colwise())
    if (place[ends[0]] >= 0 && place[ends[1]] >= 0) {
      beside[place[ends[0]]].push_back(place[ends[1]]);
      beside[place[ends[1]]].push_back(place[ends[0]]);
    }
  Graph graph;
  for (int v = 0; v < count_of(beside); ++v) {
    for (int other : beside[v])
      if (other > v) graph.neighbours.push_back(other);
    graph.start.push_back(count_of(graph.neighbours));
  }
  for (int v : dissection_order(graph)) order.push_back(inside[v]);
  order.insert(order.end(), kept.begin(), kept.end());
  for (int k = 0; k < count; ++k) place[order[k]] = k;
  Triplets entries;
  for (int v = 0; v < count; ++v) entries.emplace_back(v, v, 30);
  for (const auto& ends : edges.vertices.colwise()) {
    const auto [low, high] = std::minmax(place[ends[0]], place[ends[1]]);
    entries.emplace_back(high, low, -1);
  }
  return {packed(count, count, entries), count_of(kept)};
}

/// By three dofs a vertex.
struct Counts {
  double dofs, entries, operations, kept, cells, estimate, halo;
};

void count_factor(const OrderedGraph& graph, Counts& counts) {
  const int eliminated = static_cast<int>(graph.lower.cols()) - graph.kept;
  const Supernodes nodes = supernodes(graph.lower, eliminated);
  for (int s = 0; s < nodes.count(); ++s) {
    const double columns = nodes.column_count(s), rows = nodes.row_count(s);
    counts.entries += 9 * columns * rows;
    for (double k = rows; k > rows - columns; --k)
      counts.operations += 27 * k * k;
  }
}

/// The halos of eight octants, a part of their tetrahedra.
double halo_of_octants(const Topology<3>& topology) {
  const SolidMesh& mesh = topology.mesh;
  double with_halo = 0;
  for (int octant = 0; octant < 8; ++octant) {
    std::vector<char> own(mesh.cell_count());
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const Vector3d middle = (mesh.corner(t, 0) + mesh.corner(t, 1) +
                               mesh.corner(t, 2) + mesh.corner(t, 3)) /
                              4;
      own[t] = (middle.x() > 0.5) + 2 * (middle.y() > 0.5) +
                   4 * (middle.z() > 0.5) ==
               octant;
    }
    with_halo += count_of(cells_at(topology, edges_of_cells(topology, own)));
  }
  return with_halo / mesh.cell_count() - 1;
}

Counts counts_of(int n) {
  const Topology<3> topology = topology_of(test::brick({n, n, n}, {1, 1, 1}));
  Counts counts{};
  counts.dofs = 3.0 * topology.mesh.vertex_count();
  counts.cells = topology.mesh.cell_count();
  counts.estimate = FacetDescent<3>::bytes(topology);
  counts.halo = halo_of_octants(topology);
  const OrderedGraph graph = ordered_graph(topology);
  counts.kept = 3.0 * graph.kept;
  count_factor(graph, counts);
  return counts;
}

/// What the counts become when the dofs do, along the last two.
Counts continued(const Counts& before, const Counts& last, double dofs) {
  const auto grown = [&](double Counts::*count) {
    const double exponent = std::log(last.*count / before.*count) /
                            std::log(last.dofs / before.dofs);
    return last.*count * std::pow(dofs / last.dofs, exponent);
  };
  return {dofs,
          grown(&Counts::entries),
          grown(&Counts::operations),
          grown(&Counts::kept),
          grown(&Counts::cells),
          grown(&Counts::estimate),
          grown(&Counts::halo)};
}

void print(const Counts& counts) {
  constexpr double giga = 1e9;
  std::printf("| %.3g | %.3g | %.3g | %.3g | %.3g | %.3g | %.3g | %.0f %% |\n",
              counts.dofs, 4 * counts.entries / giga, counts.operations / 1e12,
              counts.kept, 8 * counts.kept * counts.kept / giga, counts.cells,
              counts.estimate / giga, 100 * counts.halo);
}

/// Three dofs a vertex.
SparseMatrix with_dofs(const SparseMatrix& lower) {
  Triplets entries;
  for (int column = 0; column < lower.cols(); ++column)
    for (SparseMatrix::InnerIterator e(lower, column); e; ++e)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          const Index row = 3 * e.row() + a, of_column = 3 * column + b;
          if (row >= of_column)
            entries.emplace_back(row, of_column, row == of_column ? 100 : -1);
        }
  return packed(3 * lower.rows(), 3 * lower.cols(), entries);
}

/// Operations a second of the factorisation in single precision on all threads.
double rate(int n) {
  const OrderedGraph graph =
      ordered_graph(topology_of(test::brick({n, n, n}, {1, 1, 1})));
  Counts counts{};
  count_factor(graph, counts);
  const SparseMatrix matrix = with_dofs(graph.lower);
  const auto start = std::chrono::steady_clock::now();
  const PartialCholesky<float> factor(matrix, 3 * graph.kept);
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;
  return counts.operations / seconds.count();
}

}  // namespace ffcontact::bench

int main() {
  using namespace ffcontact::bench;
  std::puts(
      "| dofs | factor [GB] | [10^12 operations] | contact dofs | Schur [GB] | "
      "tetrahedra | relaxation [GB] | halo of 8 |\n"
      "|---:|---:|---:|---:|---:|---:|---:|---:|");
  std::array<Counts, 2> last{};
  for (int n : {20, 40, 69, 99}) {
    last = {last[1], counts_of(n)};
    print(last[1]);
    std::fflush(stdout);
  }
  for (double dofs : {1e7, 1e8}) print(continued(last[0], last[1], dofs));
  std::printf("%.0f 10^9 operations a second of the factor of 206763 dofs\n",
              rate(40) / 1e9);
}
