// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

/// Sizes of the composite element of degree 1 in dimension d: the moments of its linear
/// facet tractions are a wrench (force and moment) and self-equilibrated modes, equal and
/// opposite forces at the ends of each side of the facet along it.
template <int d>
struct CompositeElement {
  static constexpr int corners = d + 1;
  static constexpr int voigt = voigt_size<d>;
  static constexpr int wrench = d * (d + 1) / 2;  ///< r, as rigid motions
  static constexpr int turns = wrench - d;
  static constexpr int moments = d * d;  ///< of a facet
  static constexpr int modes = moments - wrench;
  static constexpr int loads = corners * moments;   ///< of a cell's facets
  static constexpr int values = corners * corners;  ///< corners of its subcells
};

/// One column of moments, or of a wrench and modes, per facet.
template <int d>
using FacetColumns = Matrix<double, CompositeElement<d>::moments, Dynamic>;

}  // namespace ffcontact
