// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/cone/ridge_group.hpp"
#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "support/cut_solids.hpp"

/// Corrections around edges of solids that lie on each other.
namespace ffcontact::test {

/// Two or three bodies that lie on each other, or apart.
inline JointSolid any_joint_solid(Random& random) {
  const Vector3i half_cells(1 + random() % 2, 1 + random() % 2,
                            1 + random() % 2);
  const CutSolid cut(half_cells, random() % 2, 0.15, random);
  const Matrix3Xd shift =
      (random() % 2) * random_matrix(3, cut.piece_count(), random);
  return {cut.pieces(random), shift};
}

/// The unknowns of all faces that those of a group are.
inline Matrix9Xd spread(const Topology<3>& topology, const RidgeGroup& group,
                        const VectorXd& x) {
  Matrix9Xd all = Matrix9Xd::Zero(9, topology.facets.count());
  for (int k = 0; k < count_of(group.ridge); ++k) {
    const std::vector<int> faces =
        facets_around<3>(topology.ridges, group.ridge[k]);
    for (int i = 0; i < count_of(faces); ++i)
      all.col(faces[i]) +=
          at_place<3>(topology, group.ridge[k], i, x(group.of_ridge(k)));
  }
  return all;
}

inline FaceMoments moments_of_unknowns(const Topology<3>& topology,
                                       const Matrix9Xd& unknowns) {
  FaceMoments moments(9, unknowns.cols());
  for (int f = 0; f < unknowns.cols(); ++f)
    moments.col(f) =
        wrench_basis<3>(facet_points(topology.mesh, topology.facets, f)) *
        unknowns.col(f);
  return moments;
}

}  // namespace ffcontact::test
