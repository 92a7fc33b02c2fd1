// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/mesh.hpp"
//
#include "gmsh/msh_file.hpp"
#include "gmsh/msh_groups.hpp"

namespace ffcontact::plugin {

/// Makes a mesh of the simplices of a file.
template <int dim>
class MeshOfMsh {
 public:
  /// @param file  with cells, and without anything but simplices
  MeshOfMsh(const MshFile& file, const std::string& shown)
      : file_(file),
        cells_(file.elements[dim]),
        shown_(shown),
        used_(used_nodes(file, cells_)) {}

  const UsedNodes& used() const { return used_; }

  SimplexMesh<dim> mesh() {
    SimplexMesh<dim> mesh;
    mesh.vertices.resize(dim, count_of(used_.node));
    for (int v = 0; v < count_of(used_.node); ++v)
      mesh.vertices.col(v) = file_.nodes[used_.node[v]].template head<dim>();
    set_cells(mesh);
    set_boundary(mesh);
    require_valid(mesh);
    return mesh;
  }

  VectorXi regions() const {
    const int tag = tag_to_use(cells_);
    return VectorXi::NullaryExpr(count_of(cells_),
                                 [&](Index t) { return cells_[t].tags[tag]; });
  }

 private:
  using Key = std::array<int, dim>;
  struct Facet {
    Key key;                       ///< vertices, ascending
    Matrix<int, dim, 1> vertices;  ///< as in the first of its cells
    bool is_inside, is_labelled;
    int label;
  };

  void set_cells(SimplexMesh<dim>& mesh) const {
    mesh.cells.resize(dim + 1, count_of(cells_));
    for (int t = 0; t < count_of(cells_); ++t) {
      for (int k = 0; k <= dim; ++k)
        mesh.cells(k, t) = used_.vertex[cells_[t].nodes[k]];
      if (signed_volume(mesh, t) < 0)
        std::swap(mesh.cells(dim - 1, t), mesh.cells(dim, t));
    }
  }

  /// Labelled elements that are facets of cells, then the facets of the boundary that
  /// nothing labels.
  void set_boundary(SimplexMesh<dim>& mesh) const {
    std::vector<Facet> facets = facets_of_cells(mesh);
    std::vector<Matrix<int, dim, 1>> boundary;
    std::vector<int> labels;
    const auto add = [&](const Facet& facet) {
      boundary.push_back(facet.vertices);
      labels.push_back(facet.label);
    };
    for (const Facet* facet : labelled(facets)) add(*facet);
    for (const Facet& facet : facets)
      if (!facet.is_inside && !facet.is_labelled) add(facet);
    mesh.boundary = packed(boundary);
    mesh.boundary_label = packed(labels);
  }

  static Facet facet_of(const SimplexMesh<dim>& mesh, int cell, int side) {
    Facet facet{{}, {}, false, false, 0};
    for (int k = 0; k < dim; ++k)
      facet.vertices[k] = mesh.cells(facet_corners<dim>[side][k], cell);
    std::copy_n(facet.vertices.data(), dim, facet.key.begin());
    std::sort(facet.key.begin(), facet.key.end());
    return facet;
  }

  static bool is_before(const Facet& facet, const Key& key) {
    return facet.key < key;
  }

  /// Each once, in the order of their keys.
  static std::vector<Facet> facets_of_cells(const SimplexMesh<dim>& mesh) {
    std::vector<Facet> facets;
    for (int t = 0; t < mesh.cell_count(); ++t)
      for (int k = 0; k <= dim; ++k) facets.push_back(facet_of(mesh, t, k));
    std::stable_sort(
        facets.begin(), facets.end(),
        [](const Facet& a, const Facet& b) { return is_before(a, b.key); });
    for (std::size_t i = 1; i < facets.size(); ++i)
      if (facets[i].key == facets[i - 1].key) facets[i - 1].is_inside = true;
    const auto is_same = [](const Facet& a, const Facet& b) {
      return a.key == b.key;
    };
    facets.erase(std::unique(facets.begin(), facets.end(), is_same),
                 facets.end());
    return facets;
  }

  /// The facet that an element is, if it is one.
  Facet* facet_at(const MshElement& element, std::vector<Facet>& facets) const {
    Key key;
    for (int k = 0; k < dim; ++k) key[k] = used_.vertex[element.nodes[k]];
    std::sort(key.begin(), key.end());
    const auto place =
        std::lower_bound(facets.begin(), facets.end(), key, is_before);
    return place != facets.end() && place->key == key ? &*place : nullptr;
  }

  /// The labelled facets, each once, in the order of the file.
  std::vector<const Facet*> labelled(std::vector<Facet>& facets) const {
    std::vector<const Facet*> result;
    const std::vector<MshElement>& elements = file_.elements[dim - 1];
    const int tag = tag_to_use(elements);
    for (const MshElement& element : elements) {
      Facet* facet = facet_at(element, facets);
      if (!facet) continue;
      const int label = element.tags[tag];
      if (facet->is_labelled && facet->label != label)
        refuse_groups(element, file_, shown_, facet->label, label);
      if (!facet->is_labelled) result.push_back(facet);
      facet->is_labelled = true;
      facet->label = label;
    }
    return result;
  }

  const MshFile& file_;
  const std::vector<MshElement>& cells_;
  const std::string& shown_;  ///< what the user calls the file
  UsedNodes used_;            ///< by cells
};

}  // namespace ffcontact::plugin
