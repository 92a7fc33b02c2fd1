// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/energy/facet_forms.hpp"

namespace ffcontact {

/// What relaxes contact tractions inside the cone between the steps of a descent.
template <int d>
class ContactRelaxation {
 public:
  virtual ~ContactRelaxation() = default;
  /// Is there anything to relax?
  virtual bool is_free() const = 0;
  /// Before the first step, of which e^2 is given: how much FacingOscillation counts.
  virtual void weigh(double) {}
  /// The contact part of e^2, and FacingOscillation.
  virtual double contact_part() const = 0;
  /// One pass; returns by how much e^2 fell.
  /// @param least_fall   what is nothing
  /// @param corrections  unknowns (w, y) of all facets
  /// @param residual     minus half the slope of the elastic part of e^2 by these
  virtual double pass(double least_fall, FacetColumns<d>& corrections,
                      FacetColumns<d>& residual) = 0;
};

}  // namespace ffcontact
