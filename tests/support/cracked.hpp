// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <vector>

#include "ffcontact/mesh/facets.hpp"

/// Bodies with a crack.
namespace ffcontact::test {

/// Labels of the faces of a crack: of the part above it and of that below it.
constexpr int crack_above = 7, crack_below = 8;

/// Vertices that a crack doubles, with the number of the upper one; those at its ends,
/// which lie on facets of its plane that are whole, are not.
/// @param in_plane  facets of the crack's plane
/// @param crack     those that it opens
template <int dim>
std::map<int, int> doubled_vertices(const Facets<dim>& facets,
                                    const std::vector<int>& in_plane,
                                    const std::set<int>& crack, int first) {
  std::set<int> whole;
  for (int f : in_plane)
    if (!crack.count(f))
      for (int v : facets.vertices.col(f)) whole.insert(v);
  std::map<int, int> upper;
  for (int f : crack)
    for (int v : facets.vertices.col(f))
      if (!whole.count(v) && upper.emplace(v, first).second) ++first;
  return upper;
}

/// The mesh with a crack along those of its inner facets across the last axis at a height
/// whose middle meets a condition. Both faces share the vertices at which the crack ends.
template <int dim, class InCrack>
SimplexMesh<dim> cracked(const SimplexMesh<dim>& whole, double height,
                         const InCrack& in_crack) {
  const Facets<dim> facets = facets_of(whole);
  std::vector<int> in_plane;
  std::set<int> crack;
  for (int f = 0; f < facets.count(); ++f) {
    const auto x = facet_points<dim>(whole, facets.vertices.col(f));
    if (!(x.row(dim - 1).array() - height).isZero(1e-12)) continue;
    in_plane.push_back(f);
    if (in_crack(x.rowwise().mean())) crack.insert(f);
  }
  const std::map<int, int> upper =
      doubled_vertices(facets, in_plane, crack, whole.vertex_count());
  const auto raised = [&](int v) { return upper.count(v) ? upper.at(v) : v; };
  const auto raise = [&](auto vertices) {  // of what is above the crack
    double sum = 0;
    for (int v : vertices) sum += whole.vertices(dim - 1, v) - height;
    if (sum > 0)
      for (int& v : vertices) v = raised(v);
  };
  SimplexMesh<dim> mesh = whole;
  mesh.vertices.conservativeResize(
      dim, whole.vertices.cols() + static_cast<Index>(upper.size()));
  for (const auto& [v, twin] : upper)
    mesh.vertices.col(twin) = whole.vertices.col(v);
  for (auto cell : mesh.cells.colwise()) raise(cell);
  for (auto facet : mesh.boundary.colwise()) raise(facet);
  Index next = mesh.boundary.cols();
  const Index count = next + 2 * static_cast<Index>(crack.size());
  mesh.boundary.conservativeResize(dim, count);
  mesh.boundary_label.conservativeResize(count);
  for (int f : crack) {
    mesh.boundary.col(next) = facets.vertices.col(f);
    mesh.boundary_label[next++] = crack_below;
    mesh.boundary.col(next) = facets.vertices.col(f).unaryExpr(raised);
    mesh.boundary_label[next++] = crack_above;
  }
  return mesh;
}

}  // namespace ffcontact::test
