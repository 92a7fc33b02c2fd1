// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/body_loads.hpp"

#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

template <int d>
BodyLoadsOfCells<d> lumped_loads(const SimplexMesh<d>& mesh,
                                 const VectorXd& force) {
  BodyLoadsOfCells<d> loads(d * (d + 1), mesh.cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= d; ++k)
      loads.col(t).template segment<d>(d * k) =
          signed_volume(mesh, t) / (d + 1) *
          vector_at<d>(force, mesh.cells(k, t));
  return loads;
}

template <int d>
void add_body_loads(const SimplexMesh<d>& mesh,
                    const BodyLoadsOfCells<d>& loads, VectorXd& b) {
  for (int t = 0; t < loads.cols(); ++t)
    for (int k = 0; k <= d; ++k)
      vector_at<d>(b, mesh.cells(k, t)) +=
          loads.col(t).template segment<d>(d * k);
}

template BodyLoadsOfCells<FFCONTACT_DIMENSION> lumped_loads(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const VectorXd&);
template void add_body_loads(const SimplexMesh<FFCONTACT_DIMENSION>&,
                             const BodyLoadsOfCells<FFCONTACT_DIMENSION>&,
                             VectorXd&);

}  // namespace ffcontact
