// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/ridges.hpp"

#include <array>
#include <string>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/sorted_parts.hpp"

namespace ffcontact {

namespace {

/// One ridge of one facet.
template <int dim>
struct RidgeSide {
  std::array<int, dim - 1> vertices;  ///< ascending
  int facet;
  int local;  ///< the vertex of the facet opposite to it

  bool operator<(const RidgeSide& other) const {
    if (vertices != other.vertices) return vertices < other.vertices;
    return facet < other.facet;
  }
};

/// The vertices of a facet but the local vertex k, ascending.
template <int dim>
std::array<int, dim - 1> opposite_ridge(const Facets<dim>& facets, int f,
                                        int k) {
  std::array<int, dim - 1> vertices;
  for (int i = 1; i < dim; ++i)
    vertices[i - 1] = facets.vertices((k + i) % dim, f);
  return ascending(vertices);
}

template <int dim>
std::vector<RidgeSide<dim>> sides_of(const Facets<dim>& facets) {
  std::vector<RidgeSide<dim>> sides;
  sides.reserve(dim * facets.vertices.cols());
  for (int f = 0; f < facets.count(); ++f)
    for (int k = 0; k < dim; ++k)
      sides.push_back({opposite_ridge(facets, f, k), f, k});
  return sides;
}

/// The ridge that each of the sorted sides belongs to.
template <int dim>
std::vector<int> numbers_of(const std::vector<RidgeSide<dim>>& sides) {
  std::vector<int> numbers(sides.size(), 0);
  for (std::size_t s = 1; s < sides.size(); ++s)
    numbers[s] = numbers[s - 1] + (sides[s].vertices != sides[s - 1].vertices);
  return numbers;
}

template <std::size_t count>
std::string ridge_in_words(const std::array<int, count>& vertices) {
  const std::string first = std::to_string(vertices[0]);
  return count == 1 ? "vertex " + first
                    : "edge between vertices " + first + " and " +
                          std::to_string(vertices[count - 1]);
}

/// A body has two boundary facets at a ridge, or none.
template <int dim>
void require_one_fan(const std::vector<RidgeSide<dim>>& sides,
                     const std::vector<int>& numbers,
                     const Facets<dim>& facets) {
  int on_boundary = 0;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    if (s > 0 && numbers[s] != numbers[s - 1]) on_boundary = 0;
    on_boundary += facets.on_boundary(sides[s].facet);
    if (on_boundary > 2)
      refuse("the body touches itself in the single ",
             ridge_in_words(sides[s].vertices));
  }
}

template <int dim>
Ridges<dim> room_for(int ridges, int facets) {
  Ridges<dim> result;
  result.vertices.resize(dim - 1, ridges);
  result.of_facet.resize(dim, facets);
  result.facet_start.assign(ridges + 1, 0);
  result.on_boundary.assign(ridges, 0);
  return result;
}

/// Appends a facet to its ridge, of which all before are there.
template <int dim>
void append(const RidgeSide<dim>& side, int ridge, Ridges<dim>& ridges) {
  for (int i = 0; i < dim - 1; ++i)
    ridges.vertices(i, ridge) = side.vertices[i];
  ridges.of_facet(side.local, side.facet) = ridge;
  ridges.facet.push_back(side.facet);
  ridges.facet_start[ridge + 1] = count_of(ridges.facet);
}

}  // namespace

template <int dim>
Ridges<dim> ridges_of(const SimplexMesh<dim>& mesh, const Facets<dim>& facets) {
  const auto sides = sorted_parts(sides_of(facets), mesh.vertex_count());
  const std::vector<int> numbers = numbers_of(sides);
  require_one_fan(sides, numbers, facets);
  const int count = numbers.empty() ? 0 : numbers.back() + 1;
  Ridges<dim> ridges = room_for<dim>(count, facets.count());
  for (std::size_t s = 0; s < sides.size(); ++s) {
    append(sides[s], numbers[s], ridges);
    if (facets.on_boundary(sides[s].facet)) ridges.on_boundary[numbers[s]] = 1;
  }
  return ridges;
}

template Ridges<FFCONTACT_DIMENSION> ridges_of(
    const SimplexMesh<FFCONTACT_DIMENSION>&,
    const Facets<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
