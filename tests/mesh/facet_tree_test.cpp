// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/facet_tree.hpp"

#include <gtest/gtest.h>

#include "ffcontact/base/over.hpp"
#include "ffcontact/mesh/separate_bodies.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Those whose boxes meet a ball's box.
template <int dim>
std::vector<int> met_one_by_one(const SimplexMesh<dim>& mesh,
                                const Facets<dim>& facets,
                                const Matrix<double, dim, 1>& middle,
                                double half) {
  return numbers_where(facets.count(), [&](int f) {
    const auto x = facet_points<dim>(mesh, facets.vertices.col(f));
    return facets.on_boundary(f) &&
           (x.rowwise().maxCoeff() - middle).minCoeff() >= -half &&
           (x.rowwise().minCoeff() - middle).maxCoeff() <= half;
  });
}

template <int dim>
void finds_what_a_region_meets(const SimplexMesh<dim>& mesh, Random& random) {
  const Facets<dim> facets = facets_of(mesh);
  const FacetTree<dim> tree(mesh, facets,
                            numbers_where(facets.count(), [&](int f) {
                              return facets.on_boundary(f);
                            }));
  for (double half : {0.0, 0.1, 0.7}) {
    const Matrix<double, dim, 1> middle =
        random_matrix(dim, 1, random).array() + 1;
    const auto may_meet = [&](const Box<dim>& box) {
      return ((box.middle - middle).cwiseAbs() - box.half).maxCoeff() <= half;
    };
    RC_ASSERT(tree.met_by(may_meet) ==
              met_one_by_one(mesh, facets, middle, half));
  }
}

RC_GTEST_PROP(FacetTree, finds_what_a_region_meets, (Random random)) {
  finds_what_a_region_meets<2>(irregular(5, 4, 2, 2, random), random);
  finds_what_a_region_meets<3>(shuffled(brick({3, 2, 2}, {2, 2, 2}), random),
                               random);
}

TEST(FacetTree, of_no_facets_finds_none) {
  const Mesh mesh = rectangle(1, 1, 1, 1);
  const Facets<2> edges = facets_of(mesh);
  const FacetTree<2> tree(mesh, edges, {});
  EXPECT_TRUE(tree.met_by([](const Box<2>&) { return true; }).empty());
}

TEST(SeparateBodies, are_told_by_the_vertices_that_their_cells_share) {
  const Mesh two = joined(rectangle(2, 1, 1, 1), rectangle(1, 1, 1, 1));
  const std::vector<int> body = body_of_each_vertex(two);
  ASSERT_EQ(body.size(), 10u);
  for (int v = 0; v < 10; ++v) EXPECT_EQ(body[v], v < 6 ? 0 : 1);
}

}  // namespace
}  // namespace ffcontact
