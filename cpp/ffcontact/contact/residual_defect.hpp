// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// b + contact forces - K u on the free dofs, 0 on the others.
VectorXd force_residual(const ElasticSystem& system,
                        const VectorXd& displacement,
                        const VectorXd& contact_load);

/// |K u - b - contact forces| on the free dofs, with d (apart) the largest gap or previous
/// displacement, by two measures.
struct ResidualDefect {
  /// Relative to the largest load or force, or, dof by dof, to 1e-4 of the terms that its
  /// row adds up, sum_j |K_ij| (|u_j| + d). The latter is what rounding asks for: 1e-10 of it
  /// are some fifty units in the last place of the terms. It counts where a stiff body moves
  /// much more than it strains, and where nothing but gaps and prescribed motions load the
  /// body.
  double of_forces;
  /// Relative to what its own row may have, sum_j |K_ij| (max |u| + d) + |b_i| + |contact
  /// force|, but not to less than 2.2e-7 of the largest of these, a last place of which is
  /// 1e-9 of that. Rounding of a stiff body is large beside the forces of a soft one, which
  /// of_forces does not see; refinement takes it away.
  double of_rows;

  double largest() const { return std::max(of_forces, of_rows); }
};
ResidualDefect residual_defect(const ElasticSystem& system,
                               const VectorXd& displacement,
                               const VectorXd& contact_load, double apart);

}  // namespace ffcontact
