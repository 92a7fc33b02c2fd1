// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/free_contact.hpp"

#include <set>

#include "support/cells.hpp"
#include "support/ridge_groups.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Solids that match, with friction where `frictionless` is not, and what is known of their
/// other sides.
struct FreeSolid {
  JointSolid solid;
  HookeTensors<3> hooke;
  FaceTractions boundary;
  BodyLoadsOfCells<3> loads;
  LinearStresses<3> stress;
  FacetSetting<3> setting;

  FreeSolid(Random& random, bool some_known, bool frictionless)
      : solid(any_joint_solid(random)),
        hooke(solid.topology.mesh.cell_count(), isotropic<3>(0.5, 0.4)),
        setting{{solid.topology, hooke, boundary, loads, stress},
                solid.contact} {
    const Facets<3>& faces = solid.topology.facets;
    boundary.known.setConstant(3, faces.count(), false);
    for (int f = 0; f < faces.count(); ++f)
      for (int c = 0; c < 3 && faces.on_boundary(f); ++c)
        boundary.known(c, f) = some_known && random() % 3 == 0;
    for (ContactFacet<3>& face : setting.contact)
      for (FrictionCone& cone : face.cone)
        cone.friction = frictionless && random() % 2 ? 0 : 0.5;
  }

  /// Of what boundary facets have a part in, for a group.
  MatrixXd corrections(const RidgeGroup& group) const {
    const FreeContact<3> contact(setting);
    const std::vector<int> outside =
        unknowns_on_boundary<3>(solid.topology, group);
    std::vector<BoundarySpoke<3>> spokes =
        boundary_spokes<3>(solid.topology, group);
    for (BoundarySpoke<3>& spoke : spokes)
      spoke.moments = spoke.moments(Eigen::all, outside).eval();
    return contact.admissible_corrections(spokes);
  }
  /// Any of them, with any modes inside.
  FaceMoments any_moments(const RidgeGroup& group, Random& random) const {
    const MatrixXd basis = corrections(group);
    VectorXd x = random_vector(group.unknowns(), random);
    x(unknowns_on_boundary<3>(solid.topology, group)) =
        basis * random_vector(basis.cols(), random);
    return moments_of_unknowns(solid.topology,
                               spread(solid.topology, group, x));
  }
};

/// The largest force or moment left on a tetrahedron.
double largest_imbalance(const Topology<3>& topology,
                         const FaceMoments& moments) {
  double largest = 0;
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    largest = std::max(
        largest,
        out_of_balance<3>(corners_of(topology.mesh, t),
                          loads_of(topology.mesh, topology.facets, moments, t),
                          CellBodyLoads<3>::Zero())
            .cwiseAbs()
            .maxCoeff());
  return largest;
}

/// On both sides of the faces that match: how far from opposite.
double largest_difference(const JointSolid& solid, const FaceMoments& moments) {
  double largest = 0;
  for (const ContactFacet<3>& face : solid.contact)
    for (int k = 0; k < 3; ++k) {
      const Vector3d own = moments.col(face.facet).segment<3>(3 * k),
                     opposite = moments.col(face.opposite)
                                    .segment<3>(3 * face.opposite_corner[k]);
      largest = std::max(largest, (own + opposite).norm());
    }
  return largest;
}

RC_GTEST_PROP(FreeContact, corrections_are_balanced_and_opposite,
              (Random random)) {
  const FreeSolid free(random, true, true);
  const Topology<3>& topology = free.solid.topology;
  const KnownComponents known =
      without_contact<3>(free.boundary.known, free.setting.contact);
  for (const RidgeGroup& group :
       ridge_groups<3>(topology, free.setting.contact)) {
    const FaceMoments moments = free.any_moments(group, random);
    const double rounding = 1e-11 * (1 + moments.cwiseAbs().maxCoeff());
    RC_ASSERT(largest_imbalance(topology, moments) < rounding);
    RC_ASSERT(largest_difference(free.solid, moments) < rounding);
    // known tractions of either body stay, and r_t where there is no friction
    for (int f = 0; f < moments.cols(); ++f)
      for (int row = 0; row < 9; ++row)
        RC_ASSERT(!known(row % 3, f) || std::abs(moments(row, f)) < rounding);
    for (const ContactFacet<3>& face : free.setting.contact) {
      const Matrix3d traction = traction_on<3>(face, moments);
      for (int i = 0; i < 3; ++i)
        RC_ASSERT(!face.cone[i].frictionless() ||
                  traction.col(i).tail<2>().norm() * face.measure <
                      12 * rounding);
    }
  }
}

/// Every correction that is balanced and opposite where faces match: 6 + 3 M of them
/// around M faces, those that match counted once.
RC_GTEST_PROP(FreeContact, has_all_corrections, (Random random)) {
  const FreeSolid free(random, false, false);
  const Topology<3>& topology = free.solid.topology;
  std::set<int> opposite;
  for (const ContactFacet<3>& face : free.setting.contact)
    opposite.insert(face.opposite);
  for (const RidgeGroup& group :
       ridge_groups<3>(topology, free.setting.contact)) {
    int faces = 0;
    for (int edge : group.ridge)
      for (int face : facets_around<3>(topology.ridges, edge))
        faces += opposite.count(face) == 0;
    const std::size_t inside =
        group.unknowns() - unknowns_on_boundary<3>(topology, group).size();
    RC_ASSERT(free.corrections(group).cols() + inside == 6u + 3 * faces);
  }
}

RC_GTEST_PROP(FreeContact, keeps_work, (Random random)) {
  FreeSolid free(random, false, false);
  const Topology<3>& topology = free.solid.topology;
  const MatrixXd z = random_matrix(3 * topology.mesh.vertex_count(), 2, random);
  free.setting.kept_work = z;
  for (const RidgeGroup& group :
       ridge_groups<3>(topology, free.setting.contact)) {
    const FaceMoments moments = free.any_moments(group, random);
    Vector2d work = Vector2d::Zero();
    for (const ContactFacet<3>& face : free.setting.contact)
      for (int k = 0; k < 3; ++k)
        work += z.middleRows<3>(3 * topology.facets.vertices(k, face.facet))
                    .transpose() *
                moments.col(face.facet).segment<3>(3 * k);
    RC_ASSERT(work.norm() < 1e-11 * (1 + moments.cwiseAbs().maxCoeff()));
  }
}

}  // namespace
}  // namespace ffcontact
