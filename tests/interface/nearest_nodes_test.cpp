// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/nearest_nodes.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

PlacedNodes random_nodes(int dim, int count, Random& random) {
  PlacedNodes nodes;
  nodes.place = random_vector(dim * count, random).reshaped(dim, count);
  nodes.normal = random_vector(dim * count, random).reshaped(dim, count);
  nodes.normal.colwise().normalize();
  nodes.size = 0.3 * random_vector(count, random).cwiseAbs();
  return nodes;
}

int nearest_of_all(const PlacedNodes& nodes, int i, const PlacedNodes& old) {
  Index nearest;
  ((old.place.colwise() - nodes.place.col(i)).colwise().squaredNorm() +
   nodes.size[i] * nodes.size[i] *
       (old.normal.colwise() - nodes.normal.col(i)).colwise().squaredNorm())
      .minCoeff(&nearest);
  return static_cast<int>(nearest);
}

TEST(NearestNodes, are_nearest_of_all) {
  Random random(1);
  for (int dim : {2, 3})
    for (int count : {1, 2, 30, 200}) {
      const PlacedNodes nodes = random_nodes(dim, 50, random),
                        old = random_nodes(dim, count, random);
      const std::vector<int> found = nearest_nodes(nodes, old);
      ASSERT_EQ(found.size(), 50u);
      for (int i = 0; i < 50; ++i)
        EXPECT_EQ(found[i], nearest_of_all(nodes, i, old)) << dim << " " << i;
    }
}

/// Two sheets meet at an edge: each node there has the direction of its own.
TEST(NearestNodes, are_of_the_same_sheet) {
  PlacedNodes corner;
  corner.place = Matrix2Xd::Zero(2, 2);
  corner.normal = Matrix2d::Identity();
  corner.size = VectorXd::Ones(2);
  EXPECT_EQ(nearest_nodes(corner, corner), (std::vector<int>{0, 1}));
}

}  // namespace
}  // namespace ffcontact
