// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "ffcontact/bounds/bounds_cost.hpp"
#include "ffcontact/bounds/quantity.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

struct BoundSettings {
  /// steps s at which bounds are built, at most; those that are too long for any equilibrium
  /// do not count
  int steps = 8;
  /// at each step, of which one improves the tractions and stresses for v, and v for these
  int turns = 1;
  RelaxationSettings relaxation{8};
  /// of each bound at the best step, with twice the sweeps each, at most; the last one is that
  /// which gains less than 1 % of the width
  int further_turns = 5;
  /// mu kappa of Coulomb's law (coulomb_constant); nothing: Coulomb's law is refused
  std::optional<double> friction_share{};
  ContactSettings contact{};
};

inline RelaxationSettings with_twice_the_sweeps(RelaxationSettings relaxation) {
  relaxation.steps = 2 * relaxation.steps.value_or(1);
  return relaxation;
}

/// With Coulomb's law bounds are no better than the estimate that they start from.
template <int d>
EstimateSettings<d> settings_of_first(const BoundSettings& settings) {
  EstimateSettings<d> of_first;
  if (settings.friction_share)
    of_first.relaxation = with_twice_the_sweeps(settings.relaxation);
  return of_first;
}

/// lower <= l(u) <= upper for the exact solution u of the problem on the mesh's polygon or
/// polyhedron.
struct QuantityBounds {
  double lower = -infinity, upper = infinity;
  double value = 0;  ///< l(u_h)
  double step = 0;   ///< s
  VectorXd local;    ///< >= 0 per cell, upper - lower in all
  BoundsCost cost;
  /// why there are no bounds, one sentence without a full stop
  std::string reason;

  double width() const { return upper - lower; }
  double midpoint() const { return (upper + lower) / 2; }
  bool found() const { return std::isfinite(width()); }
  /// (upper - lower) / |midpoint|; infinite where there are none, or 0 is in the middle.
  double relative_width() const {
    return width() == 0 ? 0 : width() / std::abs(found() ? midpoint() : 1);
  }
};

/// Strict bounds of a linear quantity of frictionless contact or of Tresca's law (excess).
/// At each step t = +- s pairs are built in turns (BoundsByTurns), with rho of the estimate at
/// first. Any s, v and tau give bounds; of several s (StepSearch) the narrowest ones are taken,
/// and both are improved by further turns.
/// @param solved  what contactsolve found
/// @param first   its estimate, to which bounds with Coulomb's law stay near
/// What is bounded is that of the problem on the mesh's polygon or polyhedron, with contact
/// directions, a gap, a load step before and prescribed displacements that are linear between
/// its vertices.
///
/// With Coulomb's law, in the plane, the same with CoulombTerms and the conditions on v that go
/// with them; there are none where mu kappa >= 1. The bounds are as strict as kappa: under
/// its hypothesis on the signs of slip, and of displacements of the mesh.
/// @throws std::invalid_argument  for what the theorem, or this construction, does not cover
template <int d>
QuantityBounds quantity_bounds(const SolvedProblem<d>& solved,
                               const Estimate<d>& first,
                               const Quantity<d>& quantity,
                               const BoundSettings& settings = {});

}  // namespace ffcontact
