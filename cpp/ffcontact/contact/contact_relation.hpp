// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/contact/fixed_point/fixed_point.hpp"

namespace ffcontact {

/// An answer of a relation, and the displacement on all dofs that it adds, 0 on prescribed
/// ones.
struct RelationAnswer {
  FixedPointResult law;
  VectorXd displacement;
};

/// What is to be corrected.
struct LastAnswer {
  const ActiveSetResult& law;
  VectorXd load;  ///< b - K u on all dofs, contact forces left out
  VectorXd v;     ///< of u, with a layer that carries its multipliers
};

/// The relation between P and v of a stated contact, and the law solved on it: of plane bodies
/// by line_relation, of solids by surface_relation or multigrid_relation.
class ContactRelation {
 public:
  virtual ~ContactRelation() = default;

  /// From the states of the settings, or near ones that are found. Of an inexact
  /// stiffness to what a correction needs.
  virtual RelationAnswer answer() = 0;

  /// The law anew, from the last answer:   K (u' - u) = b - K u + B' P',   (P', v(u')) in it.
  virtual RelationAnswer corrected(const LastAnswer& last,
                                   const NewtonSettings& limits) = 0;

  /// The last answer without its rounding, states kept: what is added to P is as small as what
  /// is missed. Nothing where the relation has no such step.
  virtual std::optional<RelationAnswer> refined(const LastAnswer& /*last*/) {
    return std::nullopt;
  }

  /// With the stiffness, so far, where systems are solved by them.
  virtual int products() const { return 0; }

  /// law_scales
  /// @param v  at the nodes [d p]
  virtual LawScales scales(const VectorXd& v) const = 0;
};

}  // namespace ffcontact
