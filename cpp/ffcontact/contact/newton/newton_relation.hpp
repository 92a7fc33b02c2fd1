// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/newton/surface_equations.hpp"

namespace ffcontact {

/// The relation between P and v of a surface, as surface_newton meets it. Its rows are 3 i
/// + c of the nodes, and behind them those of what moves freely, whose condition is P = 0.
class NewtonRelation {
 public:
  virtual ~NewtonRelation() = default;

  virtual Index row_count() const = 0;
  /// @param held  of surface_trace, outlives it [3 p]
  virtual NaturalMap natural_map(const Flags& held) const = 0;
  /// As law_scales.
  /// @param v  at the nodes [3 p]
  virtual LawScales scales(const VectorXd& v) const = 0;
  /// The largest load: what moves freely misses its condition by a part of it. Contact may
  /// have next to no forces beside it.
  virtual double largest_load() const { return 0; }
  /// The next P and v by the equations of the nodes' states.
  /// @param rows  the last ones, then the next; unchanged if the system is not solved
  virtual SystemKind step(const SurfaceEquations& equations,
                          ContactRows& rows) = 0;
};

}  // namespace ffcontact
