// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/quantity.hpp"

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/elastic/inner_forces.hpp"

namespace ffcontact {

namespace {

/// Adds forces at vertices, one after the other.
template <int d, class Vertices, class Forces>
void add_forces(const Vertices& vertices, const Forces& forces,
                VectorXd& load) {
  for (Index k = 0; k < vertices.size(); ++k)
    vector_at<d>(load, vertices[k]) += forces.template segment<d>(d * k);
}

}  // namespace

template <int d>
VectorXd load_of(const SimplexMesh<d>& mesh, const Quantity<d>& quantity) {
  VectorXd load = VectorXd::Zero(d * mesh.vertices.cols());
  if (!quantity.stress.empty())
    load += inner_forces<d>(mesh, quantity.stress.mean);
  for (int t = 0; t < mesh.cell_count(); ++t)
    add_forces<d>(mesh.cells.col(t), quantity.body_loads.col(t), load);
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    add_forces<d>(mesh.boundary.col(f), quantity.tractions.col(f), load);
  return load;
}

template VectorXd load_of(const SimplexMesh<FFCONTACT_DIMENSION>&,
                          const Quantity<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
