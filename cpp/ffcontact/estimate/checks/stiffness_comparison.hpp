// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/elastic/inner_forces.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// A row of A that is off by more of its terms is not that of the law.
constexpr double stiffness_tolerance = 1e-6;

/// K u of what the script says of a body: its law, and springs if there are any.
using StatedForces = std::function<VectorXd(const VectorXd&)>;

/// int C eps(u) : eps(phi).
template <int dim>
VectorXd forces_of_law(const SimplexMesh<dim>& mesh,
                       const HookeTensors<dim>& hooke, const VectorXd& u) {
  return inner_forces<dim>(mesh, stresses<dim>(mesh, hooke, u));
}

/// A z beside K z on all dofs, 0 on prescribed ones.
struct Comparison {
  VectorXd z, of_law, of_matrix, terms;
  VectorXd off;  ///< |A z - K z| in parts of the terms

  /// @param prescribed  dofs that are left out
  Comparison(const RowMatrix& A, const StatedForces& forces,
             const Flags& prescribed);

  /// By what A z is a multiple of K z where they differ.
  double factor() const;
  bool is_multiple() const;
};

/// The row of A - K of a dof, as the symmetric K gives its column, 0 on prescribed dofs.
VectorXd row_beyond_law(const ElasticSystem& system, const StatedForces& forces,
                        Index dof);

}  // namespace ffcontact
