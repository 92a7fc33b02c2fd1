// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/balance.hpp"

namespace ffcontact {

/// Bodies that a motion is left to, even where they are glued to each other.
struct UnheldBodies : Failure {
  using Failure::Failure;
};

/// @param traces  [z] at the nodes of the unheld rigid motions z, one column each
/// @throws Failure  naming one of them that does not part the bodies, [z] = 0
template <int dim>
[[noreturn]] void refuse_unheld(const SimplexMesh<dim>& mesh,
                                const MatrixXd& motions,
                                const MatrixXd& traces);

/// What a function returns that condenses contact, or the sentence that names the motion.
template <int dim, class Nodes, class Condense>
auto held_or_refused(const SimplexMesh<dim>& mesh, const Nodes& nodes,
                     const ElasticSystem& system, Condense&& condense)
    -> decltype(condense()) {
  try {
    return condense();
  } catch (const UnheldBodies&) {
    const MatrixXd motions = unheld_motions(mesh, system);
    refuse_unheld(mesh, motions, traces_of(nodes, motions));
  }
}

}  // namespace ffcontact
