// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Loads that contact forces cannot balance.
struct NoEquilibrium : Refusal {
  /// @param who  as the sentence calls the body that is pushed
  NoEquilibrium(const std::string& sentence, std::string who, int vertex)
      : Refusal(sentence), who(std::move(who)), vertex(vertex) {}
  std::string who;
  int vertex;  ///< of that body
};

/// Work of the extreme contact forces on motions [motions x forces].
using ContactForcesOn = std::function<MatrixXd(const MatrixXd& motions)>;
/// Components along n of a vertex field at the nodes.
using AlongNormals = std::function<VectorXd(const VectorXd& field)>;

/// What acts on rigid motions that nothing but contact holds.
struct Pushed {
  MatrixXd motions;  ///< [dofs x k]
  VectorXd load;     ///< on all dofs
  ContactForcesOn forces;
  AlongNormals normal_components;
};

/// A motion that says why there is no equilibrium.
struct UnbalancedMotion {
  VectorXd field;  ///< [dofs]
  /// forces of the loads along a translation, and the largest that contact has against it
  /// while it balances all other motions [N/mm, in space N]
  double push = 0, hold = 0;
};

/// The first of these that does, part by part:
/// 1. a translation along the contact line, or along its normal, that the loads push and
///    no contact force opposes, not any or none that leaves the other motions balanced;
/// 2. in the plane a rotation about an end of the line that no contact force opposes;
/// 3. such a translation that alone is left over when contact balances all other motions:
///    friction that is not enough;
/// 4. `otherwise`, what is left over in the sense of least squares.
template <int dim>
UnbalancedMotion unbalanced_motion(const SimplexMesh<dim>& mesh,
                                   const Pushed& pushed, VectorXd otherwise);

/// @throws NoEquilibrium  saying so
template <int dim>
[[noreturn]] void refuse_unbalanced(const SimplexMesh<dim>& mesh,
                                    const UnbalancedMotion& motion);

}  // namespace ffcontact
