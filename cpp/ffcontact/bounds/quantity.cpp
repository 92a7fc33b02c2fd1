// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/quantity.hpp"

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/elastic/inner_forces.hpp"

namespace ffcontact {

template <int d>
VectorXd load_of(const SimplexMesh<d>& mesh, const Quantity<d>& quantity) {
  VectorXd load = VectorXd::Zero(d * mesh.vertices.cols());
  if (!quantity.stress.empty())
    load += inner_forces<d>(mesh, quantity.stress.mean);
  const auto add = [&load](const auto& vertices, const auto& forces) {
    for (Index k = 0; k < vertices.size(); ++k)
      vector_at<d>(load, vertices[k]) += forces.template segment<d>(d * k);
  };
  for (int t = 0; t < mesh.cell_count(); ++t)
    add(mesh.cells.col(t), quantity.body_loads.col(t));
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    add(mesh.boundary.col(f), quantity.tractions.col(f));
  return load;
}

template VectorXd load_of(const SimplexMesh<2>&, const Quantity<2>&);

}  // namespace ffcontact
