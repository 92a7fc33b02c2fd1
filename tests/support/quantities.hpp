// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/bounds/quantity.hpp"
#include "ffcontact/elastic/loads_and_supports.hpp"

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

}  // namespace ffcontact::test
