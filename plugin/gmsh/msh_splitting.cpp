// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/msh_splitting.hpp"

#include <array>
#include <map>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/splitting/quadrangle_triangles.hpp"

namespace ffcontact::plugin {

namespace {

std::string counted(int count, const MshType& type) {
  return std::to_string(count) + " " + (count == 1 ? type.name : type.names);
}

std::array<Vector3i, 2> triangles_of(const MshElement& quadrangle,
                                     const MshFile& file,
                                     const std::string& shown) {
  Matrix<double, 3, 4> corners;
  for (int k = 0; k < 4; ++k) corners.col(k) = file.nodes[quadrangle.nodes[k]];
  const auto triangles = quadrangle_triangles(
      corners, Map<const Vector4i>(quadrangle.nodes.data()));
  if (!triangles)
    refuse("the quadrangle at ", place_of(quadrangle, file), " of ", shown,
           " is flat or crosses itself");
  return *triangles;
}

}  // namespace

void split_quadrangles(MshFile& file, const std::string& shown) {
  std::vector<MshElement> result;
  for (const MshElement& element : file.elements[2]) {
    if (element.type->corners == 3) {
      result.push_back(element);
      continue;
    }
    for (const Vector3i& corners : triangles_of(element, file, shown)) {
      MshElement triangle{&simplex_type(2), element.tags, {}};
      triangle.nodes.fill(-1);
      for (int k = 0; k < 3; ++k) triangle.nodes[k] = element.nodes[corners[k]];
      result.push_back(triangle);
    }
  }
  file.elements[2] = std::move(result);
}

std::string splitting_in_words(const std::vector<MshElement>& before,
                               const std::vector<MshElement>& after) {
  std::map<int, int> count;
  std::map<int, const MshType*> type;
  for (const MshElement& element : before) {
    ++count[element.type->number];
    type[element.type->number] = element.type;
  }
  std::vector<std::string> split;
  int split_count = 0;
  for (const auto& [number, found] : type) {
    if (found->corners == found->dimension + 1) continue;
    split.push_back(counted(count[number], *found));
    split_count += count[number];
  }
  if (split.empty()) return {};
  const int simplices = count_of(after) - (count_of(before) - split_count);
  return listed(split, " and ") + (split_count == 1 ? " was" : " were") +
         " split into " + counted(simplices, *after.front().type);
}

}  // namespace ffcontact::plugin
