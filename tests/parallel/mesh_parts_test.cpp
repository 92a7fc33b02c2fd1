// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/mesh_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "support/cut_meshes.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Labels of the boundary facets by their vertices.
template <int dim>
std::map<std::array<int, dim>, int> labels_of(const SimplexMesh<dim>& mesh) {
  std::map<std::array<int, dim>, int> labels;
  for (int e = 0; e < mesh.boundary.cols(); ++e) {
    std::array<int, dim> key;
    std::copy_n(mesh.boundary.col(e).begin(), dim, key.begin());
    std::sort(key.begin(), key.end());
    labels[key] = mesh.boundary_label[e];
  }
  return labels;
}

template <int dim>
void expect_the_mesh_that_was_cut(const SimplexMesh<dim>& mesh,
                                  Random& random) {
  const auto parts = cut(mesh, 1 + static_cast<int>(random() % 4), random);
  const MeshParts<dim> numbered = joined(parts, true);
  EXPECT_EQ(numbered.whole.vertices, mesh.vertices);
  EXPECT_EQ(numbered.whole.cells, mesh.cells);
  EXPECT_EQ(labels_of(numbered.whole), labels_of(mesh));
  const MeshParts<dim> by_place = joined(parts, false);
  require_valid(by_place.whole);
  EXPECT_EQ(by_place.whole.vertex_count(), mesh.vertex_count());
  EXPECT_EQ(by_place.whole.boundary.cols(), mesh.boundary.cols());
  for (std::size_t r = 0; r < parts.size(); ++r)
    for (int t = 0; t < parts[r].mesh.cell_count(); ++t)
      for (int k = 0; k <= dim; ++k)
        EXPECT_EQ(by_place.whole.corner(by_place.cell[r][t], k),
                  parts[r].mesh.corner(t, k));
}

RC_GTEST_PROP(MeshParts, are_the_mesh_that_was_cut, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  expect_the_mesh_that_was_cut(renumbered(rectangle(4, 3, 4, 3), random).mesh,
                               random);
  expect_the_mesh_that_was_cut(shuffled(brick({2, 2, 3}, {2, 2, 3}), random),
                               random);
}

TEST(MeshParts, values_of_the_first_part_that_has_them_count) {
  MatrixXd first(2, 2), second(2, 3);
  first << 1, 2, 3, 4;
  second << 5, 6, 7, 8, 9, 10;
  MatrixXd whole(2, 4);
  whole << 2, 1, 0, 6, 4, 3, 0, 9;
  EXPECT_EQ(of_whole({first, second}, {{1, 0}, {0, 3, -1}}), whole);
}

TEST(MeshParts, of_different_meshes_are_refused) {
  Random random(1);
  const Mesh mesh = rectangle(2, 2, 1, 1);
  auto parts = cut(mesh, 2, random);
  auto refused = [&] {
    EXPECT_THROW(joined(parts, true), std::invalid_argument);
    parts = cut(mesh, 2, random);
  };
  parts[1].numbers = {};
  refused();
  parts[1].numbers.cell.pop_back();
  refused();
  parts[1].numbers.cell[0] = parts[0].numbers.cell[0];
  refused();
  parts[1].numbers.vertex[0] = 100;
  refused();
  parts[1].numbers.vertex[0] = -1;
  refused();
  parts[1].mesh.vertices.array() += 0.1;
  refused();
}

TEST(MeshParts, two_vertices_at_one_place_need_numbers) {
  const Mesh body = rectangle(1, 1, 1, 1);
  Mesh twice = body;
  twice.vertices.resize(2, 8);
  twice.vertices << body.vertices, body.vertices;
  EXPECT_THROW(joined_parts<2>({twice}, {PartNumbers{}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace ffcontact
