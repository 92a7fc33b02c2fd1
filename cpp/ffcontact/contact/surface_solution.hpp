// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/contact/law/surface_law.hpp"

namespace ffcontact {

/// Did multigrid solve it, or a factor after it?
enum class Multigrid { unused, used, in_vain };

/// A solution of frictional contact on a surface.
struct SurfaceSolution {
  /// anything but converged: the rest is the best iterate
  ContactStatus status = ContactStatus::not_converged;
  VectorXd displacement;  ///< u_h on all dofs [mm]
  Matrix3Xd force;        ///< (F_n, F_t1, F_t2) at the nodes [N, 3 x p]
  /// open, stick, or slip_forward for slip in any direction [p]
  ContactStates state;
  int iterations = 0;           ///< dense systems solved
  std::vector<double> history;  ///< of surface_fixed_point, empty without
  double complementarity = 0;  ///< surface_violation of displacement and forces
  double residual = 0;         ///< ResidualDefect::of_forces
  /// for further loads; null where multigrid was enough
  std::shared_ptr<const CondensedStiffness> stiffness;
  Multigrid multigrid = Multigrid::unused;

  bool accepted(const ContactSettings& settings) const {
    return status == ContactStatus::converged &&
           complementarity <= settings.tolerance &&
           residual <= settings.tolerance;
  }
};

/// Solves K u = b + contact forces under the law of the surface for solids on a rigid
/// foundation or against each other, as one mesh (joined_mesh): one factorisation, the condensed relation between F and v, surface_newton
/// (again from sticking nodes where the given states lead nowhere), and where that does
/// not converge surface_fixed_point, one back-substitution.
/// @throws std::invalid_argument  for input that does not fit, prescribed displacements
///                                that penetrate, or loads that contact cannot balance
///                                (with the motion named)
/// @throws std::runtime_error     if a part of the body is held by nothing
SurfaceSolution solve_contact(const SolidMesh& mesh,
                              const ContactSurface& surface,
                              const SurfaceLaw& law,
                              const ElasticSystem& system,
                              const ContactSettings& settings = {});

}  // namespace ffcontact
