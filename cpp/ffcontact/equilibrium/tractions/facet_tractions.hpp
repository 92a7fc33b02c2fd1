// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/equilibrium/stress/composite_element.hpp"
#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// Which components of the traction on each facet are given [d x facets].
template <int d>
using KnownTractions = Eigen::Array<bool, d, Dynamic>;
using KnownComponents = KnownTractions<3>;
/// Of some facets those, not axes, that are known alone, one a column.
template <int d>
using KnownDirections = std::map<int, Matrix<double, d, Dynamic>>;

/// What the boundary of an admissible stress must carry, per facet and Cartesian component.
///
/// On Neumann and contact facets all components are known, on the latter as the sum of
/// given and contact tractions. On a Dirichlet facet a prescribed component is free (the
/// support answers) and the others are known, e.g. 0 on a plane of symmetry. A component of
/// a facet counts as prescribed when that dof is prescribed at every vertex of every facet
/// with the same label: a single Neumann edge between two supports stays Neumann.
template <int d>
struct FacetTractions {
  KnownTractions<d> known;  ///< false inside the body
  /// int F phi at the vertices of the facet of the known components, F = sigma n with the
  /// facet's normal (outward on the boundary), 0 elsewhere [N]
  FacetColumns<d> moments;
  /// of boundary facets along which directions, not axes, are known beside `known`
  KnownDirections<d> known_direction{};
};

/// The given tractions alone; contact facets are as any others.
/// @param prescribed  1 where the dof is prescribed [d * vertices]
/// @param neumann     moments of the given tractions at the vertices of each column of
///                    SimplexMesh::boundary [d^2 x boundary]; not read on prescribed
///                    components
/// @throws std::invalid_argument  if sizes differ or a traction is not finite
template <int d>
FacetTractions<d> given_tractions(const SimplexMesh<d>& mesh,
                                  const Facets<d>& facets,
                                  const Flags& prescribed,
                                  const Ref<const FacetColumns<d>>& neumann);

/// Known moments to the last digit, where there are others but for rounding.
template <int d>
void put_known(const FacetTractions<d>& boundary, FacetColumns<d>& moments) {
  for (Index f = 0; f < moments.cols(); ++f)
    for (int row = 0; row < moments.rows(); ++row)
      if (boundary.known(row % d, f))
        moments(row, f) = boundary.moments(row, f);
}

}  // namespace ffcontact
