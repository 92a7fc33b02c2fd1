// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

/// A place on a labelled facet of one body.
template <int dim>
struct BoundaryPlace {
  int column;             ///< of the body's SimplexMesh::boundary
  VectorOf<dim> weights;  ///< of that column's vertices
};

/// Expressions at places of bodies whose meshes other processes hold.
template <int dim>
class PlacesElsewhere {
 public:
  virtual ~PlacesElsewhere() = default;
  virtual VectorXd values(
      Expression expression, int body,
      const std::vector<BoundaryPlace<dim>>& places) const = 0;
};

}  // namespace ffcontact::plugin
