// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/stress/composite_element.hpp"

namespace ffcontact {

/// Loads, slopes or energies by the facets of each cell [12 or 36 x cells].
template <int d>
using FacetImages = Matrix<double, CompositeElement<d>::loads, Dynamic>;

/// How descents on the shares of one body go together.
template <int d>
class FacetExchange {
 public:
  virtual ~FacetExchange() = default;
  /// Over all shares, with the same digits on each.
  virtual double sum(double of_share) const = 0;
  /// Columns of the halo become those of whose own cells they are.
  virtual void complete(FacetImages<d>& images) const = 0;
};

/// Of a share that is all.
template <int d>
class NoExchange : public FacetExchange<d> {
 public:
  double sum(double of_share) const override { return of_share; }
  void complete(FacetImages<d>&) const override {}
};

}  // namespace ffcontact
