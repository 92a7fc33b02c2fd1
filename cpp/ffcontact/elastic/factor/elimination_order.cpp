// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/elimination_order.hpp"

#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/factor/supernodes.hpp"

namespace ffcontact {

namespace {

/// The free dofs of a system that are not kept, and the vertices that have any.
class Interior {
 public:
  Interior(const ElasticSystem& system, const std::vector<int>& kept)
      : system_(system), is_kept_(system.prescribed.size(), 0) {
    for (int dof : kept) is_kept_[dof] = 1;
    number_.assign(system.prescribed.size() / system.dimension, -1);
    for (int v = 0; v < static_cast<int>(number_.size()); ++v)
      if (!dofs_of(v).empty()) {
        number_[v] = static_cast<int>(vertices_.size());
        vertices_.push_back(v);
      }
  }

  const std::vector<int>& vertices() const { return vertices_; }

  std::vector<int> dofs_of(int vertex) const {
    std::vector<int> dofs;
    const int first = system_.dimension * vertex;
    for (int dof = first; dof < first + system_.dimension; ++dof)
      if (has(dof)) dofs.push_back(dof);
    return dofs;
  }

  /// A vertex sees another one when any of its rows does; the first row holds all of them
  /// unless it is prescribed.
  Graph graph() const {
    Graph graph;
    for (int v : vertices_) {
      add_neighbours(v, graph.neighbours);
      graph.start.push_back(static_cast<int>(graph.neighbours.size()));
    }
    return graph;
  }

 private:
  bool has(int dof) const { return !system_.prescribed[dof] && !is_kept_[dof]; }

  int first_free_dof(int vertex) const {
    int dof = system_.dimension * vertex;
    while (system_.prescribed[dof]) ++dof;
    return dof;
  }

  /// Those with a higher number.
  void add_neighbours(int vertex, std::vector<int>& neighbours) const {
    const RowMatrix& K = system_.stiffness;
    int last = -1;
    for (RowMatrix::InnerIterator e(K, first_free_dof(vertex)); e; ++e) {
      const int w = number_[e.col() / system_.dimension];
      if (w > number_[vertex] && w != last) neighbours.push_back(last = w);
    }
  }

  const ElasticSystem& system_;
  Flags is_kept_;
  std::vector<int> vertices_;
  std::vector<int>
      number_;  ///< of each vertex among those of the interior, or -1
};

/// Vertex by vertex.
std::vector<int> interior_order(const Interior& interior) {
  std::vector<int> order;
  for (int k : dissection_order(interior.graph()))
    for (int dof : interior.dofs_of(interior.vertices()[k]))
      order.push_back(dof);
  return order;
}

}  // namespace

std::vector<int> elimination_order(const ElasticSystem& system,
                                   const std::vector<int>& kept) {
  std::vector<int> order = interior_order(Interior(system, kept));
  order.insert(order.end(), kept.begin(), kept.end());
  return order;
}

}  // namespace ffcontact
