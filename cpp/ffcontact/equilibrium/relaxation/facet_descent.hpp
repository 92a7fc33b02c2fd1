// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/energy/ridge_stars.hpp"
#include "ffcontact/equilibrium/relaxation/facet_exchange.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"

namespace ffcontact {

/// Conjugate gradients for the corrections x = (w, y) of all facets that lower
///     |sigma_hat - sigma|^2 + terms of facets = e_0^2 + 2 g'x + x'H x
/// most, from zero, with the additive solves of all ridge stars: with r = -(g + H x) and
/// the last direction p,
///     z = RidgeStars r,   p <- z - (z'Hp / p'Hp) p,   x <- x + (r'p / p'Hp) p.
/// Every direction is self-equilibrated and leaves known boundary tractions alone, but for
/// rounding. That of z is relative to z, and what p has of it does not fall with p: where
/// its bound grows to 1e4 times that of p itself, in bodies of few unknowns, p is z.
/// Contact tractions change between the steps only (ContactRelaxation); the next direction
/// is conjugate to the last one as ever.
/// Sums are over parts of fixed size and each facet gathers what the cells beside it have
/// for it: the digits do not depend on the number of threads.
///
/// Descents on the shares of a body go in step. Each knows all facets around its ridges, so
/// that z on its own facets needs nothing from others; H p on the cells of its halo is all
/// that it does, once a step, beside five sums.
template <int d>
class FacetDescent {
 public:
  /// Nothing is exchanged before begin().
  /// @param body     of the share and its halo; what it refers to, share and exchange stay
  ///                 where they are
  /// @param moments  in equilibrium, from which the descent starts
  FacetDescent(const LoadedFacets<d>& body, const FacetColumns<d>& moments,
               const FacetShare& share, const FacetExchange<d>& exchange);

  /// What one of a whole body takes, nearly [bytes].
  static double bytes(const FacetTopology<d>& topology);

  const FacetForms<d>& forms() const { return forms_; }

  /// @return e_0^2 [N mm]
  double begin();

  /// One step; returns by how much e^2 fell.
  double step();

  /// x and -(g + H x) [d^2 x facets], right on counted facets and, the latter, around
  /// ridges.
  FacetColumns<d>& corrections() { return corrections_; }
  FacetColumns<d>& residual() { return residual_; }

 private:
  using Element = CompositeElement<d>;

  void gather(FacetColumns<d>& y) const;
  double dot(const FacetColumns<d>& a, const FacetColumns<d>& b) const;
  void add(double factor, const FacetColumns<d>& y, FacetColumns<d>& x) const;
  bool find_conjugate();
  void find_steepest();
  bool turn_direction();  ///< false where there is none

  const LoadedFacets<d> body_;
  const FacetShare& share_;
  const FacetExchange<d>& exchange_;
  FacetForms<d> forms_;
  RidgeStars<d> stars_;
  FacetColumns<d> corrections_, residual_, direction_, next_;
  FacetImages<d> images_;  ///< slopes, then H p
  FacetColumns<d> image_;  ///< H p
  double square_ = 0;      ///< p'Hp; 0: no direction yet
  double rounding_ =
      0;  ///< bound of what p has of it, in units of the last digit
  double of_share_ = 0;  ///< |sigma_hat - sigma|^2 on its own cells at first
};

/// Adds the moments of corrections (w, y), but for those of components that are known.
template <int d>
void add_corrections(const FacetTopology<d>& topology,
                     const KnownTractions<d>& known,
                     const FacetColumns<d>& corrections,
                     FacetColumns<d>& moments);

}  // namespace ffcontact
