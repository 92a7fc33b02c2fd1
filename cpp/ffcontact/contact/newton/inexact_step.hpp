// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/contact/newton/single_stiffness.hpp"
#include "ffcontact/contact/newton/surface_equations.hpp"
#include "ffcontact/linear/dense/dense_cholesky.hpp"

namespace ffcontact {

/// The system of surface_step in single precision, to 1e-4, which is what Newton's steps
/// far from the solution are worth, and gains four digits a step near it: the residual of
/// each is one of double precision.
///
/// GMRES for the increment of v. With D of a state and T = I - D its rows are those of
///     T (S + T^-1 c D) + (P_n's part of Coulomb's bound),
/// preconditioned by the Cholesky factor of the symmetric S + T^-1 c D and by T^-1. A
/// factor serves the steps that follow as long as their unknowns are nearly its own: of
/// some thousand it is the dearest of all, and half of an LU.
///
/// Without unknown multipliers only, as of rows that depend on others.
class InexactStep {
 public:
  explicit InexactStep(const CondensedContact& contact) : S_(contact) {}

  /// @param contact    whose S it was made of, loads apart
  /// @param equations  all rows that are not primary are held
  /// @param rows       the last ones, then the next
  /// @return false, with rows as they were, if the system is not solved
  bool solve(const CondensedContact& contact, const SurfaceEquations& equations,
             ContactRows& rows);

 private:
  class System;
  /// Of S + T^-1 c D at some places.
  struct Factor {
    std::vector<int> places;
    LapackCholesky<float> cholesky;
    int steps = 0;  ///< that GMRES took with it last
  };

  bool needs_new_factor(const std::vector<int>& places) const;
  /// @param rows  where v is 0 if that is the condition
  bool advance(const System& system, ContactRows& rows);

  SingleStiffness S_;
  std::optional<Factor> factor_;
};

}  // namespace ffcontact
