// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "ffcontact/bounds/quantity_bounds.hpp"
#include "ffcontact/elastic/loads_and_supports.hpp"
#include "support/random.hpp"

/// Quantities of interest that the tests share.
namespace ffcontact::test {

template <int d>
Quantity<d> no_quantity(const SimplexMesh<d>& mesh) {
  return {BodyLoadsOfCells<d>::Zero(d * (d + 1), mesh.cells.cols()),
          {},
          FacetColumns<d>::Zero(d * d, mesh.boundary.cols())};
}

/// int w . v over the facets of a label.
template <int d>
Quantity<d> on_label(const SimplexMesh<d>& mesh, int label,
                     const VectorOf<d>& w) {
  Quantity<d> quantity = no_quantity<d>(mesh);
  VectorXd load = VectorXd::Zero(d * mesh.vertices.cols());
  add_traction(mesh, label, w, load, quantity.tractions);
  return quantity;
}

/// The exact value is in both intervals, so that they meet.
inline void require_that_they_meet(const QuantityBounds& one,
                                   const QuantityBounds& other) {
  RC_ASSERT(one.reason == "");
  RC_ASSERT(other.reason == "");
  const double rounding = 1e-9 * (std::abs(one.lower) + std::abs(one.upper));
  RC_ASSERT(one.lower <= other.upper + rounding);
  RC_ASSERT(other.lower <= one.upper + rounding);
  RC_ASSERT(one.local.minCoeff() >= -rounding);
  RC_ASSERT(std::abs(one.local.sum() - one.width()) <=
            1e-8 * one.width() + rounding);
}

/// Those of nested meshes.
inline void require_that_they_narrow(const QuantityBounds& wide,
                                     const QuantityBounds& narrow) {
  require_that_they_meet(wide, narrow);
  const double rounding = 1e-9 * (std::abs(wide.lower) + std::abs(wide.upper));
  RC_ASSERT(narrow.width() <= wide.width() + rounding);
  RC_TAG(std::clamp(static_cast<int>(wide.width() / narrow.width()), 0, 20));
}

/// With values on a mesh that is finer and on one twice as fine: one of those that they tend
/// to, at the rate 1 or any faster one, is between the bounds.
inline void require_that_they_hold(const QuantityBounds& bounds, double finer,
                                   double finest) {
  const double limit = 2 * finest - finer,
               rounding =
                   1e-9 * (std::abs(bounds.lower) + std::abs(bounds.upper));
  RC_ASSERT(std::max(finest, limit) >= bounds.lower - rounding);
  RC_ASSERT(std::min(finest, limit) <= bounds.upper + rounding);
}

/// All of it, of bodies on nested meshes: their bounds on two and their value on a third one.
template <class Bodies>
void require_nested_bounds(const Bodies& bodies, int coarse, int fine,
                           int finest) {
  const QuantityBounds wide = bodies.bounds(coarse),
                       narrow = bodies.bounds(fine);
  require_that_they_narrow(wide, narrow);
  require_that_they_hold(wide, narrow.value, bodies.value(finest));
}

}  // namespace ffcontact::test
