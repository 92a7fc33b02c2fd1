// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/ridge_group.hpp"

#include <set>

#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "support/cut_solids.hpp"
#include "support/ridge_groups.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(RidgeGroup, has_each_ridge_of_contact_once, (Random random)) {
  const JointSolid solid = any_joint_solid(random);
  const Topology<3>& topology = solid.topology;
  std::set<int> edges;
  for (const RidgeGroup& group : ridge_groups<3>(topology, solid.contact)) {
    RC_ASSERT(group.ridge.size() >= 2u);
    RC_ASSERT(group.first.size() == group.ridge.size() + 1);
    for (int edge : group.ridge) RC_ASSERT(edges.insert(edge).second);
  }
  for (const ContactFacet<3>& face : solid.contact)
    for (int k = 0; k < 3; ++k) {
      RC_ASSERT(edges.count(topology.ridges.of_facet(k, face.facet)) == 1u);
      RC_ASSERT(edges.count(topology.ridges.of_facet(k, face.opposite)) == 1u);
    }
}

RC_GTEST_PROP(RidgeGroup, form_and_restriction_are_those_of_all_facets,
              (Random random)) {
  const JointSolid solid = any_joint_solid(random);
  const Topology<3>& topology = solid.topology;
  const FacetForms<3> forms(
      topology,
      HookeTensors<3>(topology.mesh.cell_count(), isotropic<3>(0.5, 0.4)));
  for (const RidgeGroup& group : ridge_groups<3>(topology, solid.contact)) {
    const VectorXd x = random_vector(group.unknowns(), random);
    const Matrix9Xd unknowns = spread(topology, group, x);
    double energy = 0;
    for (int t = 0; t < topology.mesh.cell_count(); ++t) {
      const CellVector<3> of_cell =
          unknowns_at<3>(topology.facets, unknowns, t);
      energy += of_cell.dot(forms.times(t, of_cell));
    }
    const MatrixXd A = group_form<3>(topology, group, forms);
    RC_ASSERT(std::abs(x.dot(A * x) - energy) < 1e-4 * energy);
    const Matrix9Xd g = random_matrix(9, topology.facets.count(), random);
    RC_ASSERT(std::abs(group_restricted<3>(topology, group, g).dot(x) -
                       g.cwiseProduct(unknowns).sum()) < 1e-11);
  }
}

RC_GTEST_PROP(RidgeGroup, spokes_are_the_moments_of_boundary_facets,
              (Random random)) {
  const JointSolid solid = any_joint_solid(random);
  const Topology<3>& topology = solid.topology;
  for (const RidgeGroup& group : ridge_groups<3>(topology, solid.contact)) {
    const std::vector<int> outside = unknowns_on_boundary<3>(topology, group);
    const std::set<int> on_boundary(outside.begin(), outside.end());
    const VectorXd x = random_vector(group.unknowns(), random);
    const FaceMoments moments =
        moments_of_unknowns(topology, spread(topology, group, x));
    std::set<int> spokes;
    for (const BoundarySpoke<3>& spoke : boundary_spokes<3>(topology, group)) {
      RC_ASSERT(topology.facets.on_boundary(spoke.facet));
      spokes.insert(spoke.facet);
      RC_ASSERT((spoke.moments * x - moments.col(spoke.facet)).norm() < 1e-12);
      for (int i = 0; i < group.unknowns(); ++i)
        RC_ASSERT(on_boundary.count(i) == 1u || spoke.moments.col(i).isZero(0));
    }
    for (int edge : group.ridge)
      for (int face : facets_around<3>(topology.ridges, edge))
        RC_ASSERT(spokes.count(face) ==
                  (topology.facets.on_boundary(face) ? 1u : 0u));
  }
}

}  // namespace
}  // namespace ffcontact
