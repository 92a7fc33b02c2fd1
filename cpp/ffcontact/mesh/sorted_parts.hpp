// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace ffcontact {

template <std::size_t size>
std::array<int, size> ascending(std::array<int, size> vertices) {
  for (std::size_t i = 1; i < size; ++i)
    for (std::size_t k = i; k > 0 && vertices[k] < vertices[k - 1]; --k)
      std::swap(vertices[k], vertices[k - 1]);
  return vertices;
}

/// Parts of a mesh in ascending order, of which part.vertices[0] comes first: by that it
/// is counting, and few parts have the same.
template <class Part>
std::vector<Part> sorted_parts(const std::vector<Part>& parts,
                               int vertex_count) {
  std::vector<std::size_t> start(vertex_count + 1, 0);
  for (const Part& part : parts) ++start[part.vertices[0] + 1];
  for (int v = 0; v < vertex_count; ++v) start[v + 1] += start[v];
  std::vector<Part> result(parts.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (const Part& part : parts) result[next[part.vertices[0]]++] = part;
  for (int v = 0; v < vertex_count; ++v)
    std::sort(result.begin() + start[v], result.begin() + start[v + 1]);
  return result;
}

}  // namespace ffcontact
