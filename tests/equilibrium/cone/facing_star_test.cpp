// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/facing_star.hpp"

#include <algorithm>
#include <set>

#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "support/cells.hpp"
#include "support/facing_contact.hpp"
#include "support/ridge_groups.hpp"

namespace ffcontact {
namespace {

using namespace test;

FaceMoments moments_of(const Topology<3>& topology,
                       const StarColumns<3>& columns, const VectorXd& t) {
  Matrix9Xd unknowns = Matrix9Xd::Zero(9, topology.facets.count());
  for (std::size_t k = 0; k < columns.facet.size(); ++k)
    unknowns.col(columns.facet[k]) = columns.of_facet(static_cast<int>(k)) * t;
  return moments_of_unknowns(topology, unknowns);
}

/// What all boundary faces carry of the tractions of a star, opposite ones included.
FaceMoments carried(const FacingContact& facing, const FacingStar<3>& star,
                    const VectorXd& t) {
  FaceMoments moments = FaceMoments::Zero(9, facing.topology.facets.count());
  for (std::size_t k = 0; k < star.contact.size(); ++k) {
    const ContactFacet<3>& face = facing.contact[star.contact[k]];
    const VectorXd R = star.tractions[k] * t;
    moments.col(face.facet) =
        ffcontact::moments_of<3>(face, R.reshaped(3, 3)).reshaped();
    for (const FacingPart<3>& part : face.facing)
      moments.col(part.facet) += part.moments * R;
  }
  return moments;
}

void require_balanced_and_opposite(const FacingContact& facing,
                                   const FacingStar<3>& star, Random& random) {
  const auto& [mesh, faces, ridges, stars] = facing.topology;
  const VectorXd t = random_vector(star.columns.Z.cols(), random);
  const FaceMoments moments = moments_of(facing.topology, star.columns, t),
                    wanted = carried(facing, star, t);
  const double rounding = 1e-10 * (1 + moments.cwiseAbs().maxCoeff());
  for (int f = 0; f < faces.count(); ++f)
    if (faces.on_boundary(f))
      RC_ASSERT((moments.col(f) - wanted.col(f)).norm() < rounding);
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    RC_ASSERT(out_of_balance<3>(corners_of(mesh, cell),
                                loads_of(mesh, faces, moments, cell),
                                CellBodyLoads<3>::Zero())
                  .norm() < rounding);
}

/// All twelve corrections around an edge between two faces, and three around others.
RC_GTEST_PROP(FacingStar, has_all_corrections_balanced_in_both_bodies,
              (Random random)) {
  const FacingContact facing({0, 0, -1}, 0.5, random);
  std::set<int> edges;
  for (const ContactFacet<3>& face : facing.contact)
    for (int edge : facing.topology.ridges.of_facet.col(face.facet))
      edges.insert(edge);
  const auto stars = facing_stars<3>(facing.topology, facing.contact);
  RC_ASSERT(stars.size() == edges.size());
  for (const FacingStar<3>& star : stars) {
    RC_ASSERT(star.columns.Z.cols() == (star.contact.size() == 2 ? 12 : 3));
    require_balanced_and_opposite(facing, star, random);
  }
}

RC_GTEST_PROP(FacingStar, keeps_shear_where_there_is_no_friction,
              (Random random)) {
  const FacingContact facing({0, 0, -1}, 0, random);
  for (const FacingStar<3>& star :
       facing_stars<3>(facing.topology, facing.contact)) {
    require_balanced_and_opposite(facing, star, random);
    for (const MatrixXd& R : star.tractions)
      for (int i = 0; i < 3; ++i)
        RC_ASSERT(R.middleRows<2>(3 * i + 1).norm() < 1e-9 * (1 + R.norm()));
  }
}

/// Over a gap that is not the same everywhere shear would turn the other body.
RC_GTEST_PROP(FacingStar, turns_no_body_over_a_tilted_gap, (Random random)) {
  FacingContact facing({0, 0, -1}, 0.5, random);
  // the other body feels more of the forces where x is larger
  const auto& [mesh, faces, ridges, stars_of] = facing.topology;
  for (ContactFacet<3>& face : facing.contact)
    for (FacingPart<3>& part : face.facing)
      for (int k = 0; k < 3; ++k) {
        const double x = mesh.vertices(0, faces.vertices(k, part.facet));
        part.moments.middleRows<3>(3 * k) *= 1 + 0.1 * x;
      }
  for (const FacingStar<3>& star :
       facing_stars<3>(facing.topology, facing.contact)) {
    RC_ASSERT(star.columns.Z.cols() < 12);
    require_balanced_and_opposite(facing, star, random);
  }
}

}  // namespace
}  // namespace ffcontact
