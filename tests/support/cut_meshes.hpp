// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <random>
#include <set>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/mesh/facets.hpp"
#include "ffcontact/parallel/mesh_parts.hpp"
#include "support/uniform.hpp"

namespace ffcontact::test {

/// A part of a mesh as FreeFEM's trunc leaves it, with its numbers in the whole.
template <int dim>
struct CutPart {
  SimplexMesh<dim> mesh;
  PartNumbers numbers;
};

/// The cells of one owner; facets where the mesh was cut have the label -1.
template <int dim>
CutPart<dim> part_of(const SimplexMesh<dim>& whole, const Facets<dim>& facets,
                     const std::vector<int>& owner, int own) {
  CutPart<dim> part;
  std::set<int> vertices;
  for (int t = 0; t < whole.cell_count(); ++t)
    if (owner[t] == own) {
      part.numbers.cell.push_back(t);
      for (int v : whole.cells.col(t)) vertices.insert(v);
    }
  std::map<int, int> place;
  for (int v : vertices) {
    place[v] = static_cast<int>(place.size());
    part.numbers.vertex.push_back(v);
  }
  SimplexMesh<dim>& mesh = part.mesh;
  mesh.vertices = whole.vertices(Eigen::all, part.numbers.vertex);
  mesh.cells = whole.cells(Eigen::all, part.numbers.cell);
  for (int& v : mesh.cells.reshaped()) v = place.at(v);
  std::vector<Matrix<int, dim, 1>> boundary;
  std::vector<int> labels;
  for (int f = 0; f < facets.count(); ++f) {
    const int first = facets.cells(0, f), second = facets.cells(1, f);
    const bool in_first = owner[first] == own,
               in_second = second >= 0 && owner[second] == own;
    if (in_first == in_second) continue;
    Matrix<int, dim, 1> facet = facets.vertices.col(f);
    for (int& v : facet) v = place.at(v);
    boundary.push_back(facet);
    labels.push_back(facets.on_boundary(f)
                         ? whole.boundary_label[facets.boundary_index[f]]
                         : -1);
  }
  mesh.boundary = packed(boundary);
  mesh.boundary_label = packed(labels);
  return part;
}

/// Each cell to a random owner; each owner has one.
inline std::vector<int> random_owners(int cells, int owners,
                                      std::mt19937& random) {
  std::vector<int> owner(cells);
  for (int t = 0; t < cells; ++t)
    owner[t] = t < owners ? t : static_cast<int>(random() % owners);
  shuffle(owner, random);
  return owner;
}

template <int dim>
std::vector<CutPart<dim>> cut(const SimplexMesh<dim>& whole, int owners,
                              std::mt19937& random) {
  const Facets<dim> facets = facets_of(whole);
  const std::vector<int> owner =
      random_owners(whole.cell_count(), owners, random);
  std::vector<CutPart<dim>> parts;
  for (int own = 0; own < owners; ++own)
    parts.push_back(part_of(whole, facets, owner, own));
  return parts;
}

template <int dim>
MeshParts<dim> joined(const std::vector<CutPart<dim>>& parts, bool numbered) {
  std::vector<SimplexMesh<dim>> meshes;
  std::vector<PartNumbers> numbers;
  for (const CutPart<dim>& part : parts) {
    meshes.push_back(part.mesh);
    numbers.push_back(numbered ? part.numbers : PartNumbers{});
  }
  return joined_parts(meshes, numbers);
}

}  // namespace ffcontact::test
