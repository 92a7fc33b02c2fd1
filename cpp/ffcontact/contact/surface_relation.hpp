// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/contact/fixed_point/fixed_point.hpp"
#include "ffcontact/contact/stated_surface.hpp"

namespace ffcontact {

/// The relation between P and v of a stated surface, and the law solved on it: by
/// CondensedContact, or by multigrid_relation.
class SurfaceRelation {
 public:
  virtual ~SurfaceRelation() = default;

  /// From the states of the settings, or near ones that are found. Of an inexact
  /// stiffness by surface_newton to what a correction needs.
  virtual FixedPointResult answer() = 0;
  /// For a load on all dofs and the v of other prescribed values, where a layer carries P
  /// already.
  virtual void put_loads(const VectorXd& load, const VectorXd& v_prescribed,
                         const VectorXd& P) = 0;
  /// By surface_newton from P and v of a problem nearby.
  virtual ActiveSetResult answer_near(const ContactRows& rows,
                                      const NewtonSettings& limits) = 0;
  /// On all dofs, 0 on prescribed ones.
  virtual VectorXd displacement(const ContactRows& rows) const = 0;
  /// law_scales
  /// @param v  at the nodes [3 p]
  virtual LawScales scales(const VectorXd& v) const = 0;
};

/// @param stated  outlives it
std::unique_ptr<SurfaceRelation> surface_relation(
    const StatedSurface& stated,
    const std::shared_ptr<const CondensedStiffness>& stiffness);

}  // namespace ffcontact
