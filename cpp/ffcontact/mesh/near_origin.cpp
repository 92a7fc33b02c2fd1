// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/near_origin.hpp"

#include <cmath>

namespace ffcontact {

namespace {

/// A multiple of a power of two well above the size of the bodies: its difference to
/// their coordinates is exact, and bodies within a few sizes of zero keep theirs.
template <int dim>
VectorOf<dim> origin_near(const Matrix<double, dim, Dynamic>& vertices) {
  using Point = VectorOf<dim>;
  if (vertices.cols() == 0) return Point::Zero();
  const Point lowest = vertices.rowwise().minCoeff(),
              highest = vertices.rowwise().maxCoeff();
  const double size = (highest - lowest).norm(),
               step = std::exp2(std::ceil(std::log2(size)) + 3);
  const Point middle = 0.5 * (lowest + highest);
  if (!middle.allFinite() || !std::isnormal(step)) return Point::Zero();
  return middle.unaryExpr(
      [step](double x) { return std::rint(x / step) * step; });
}

}  // namespace

template <int dim>
void take_from_near_origin(SimplexMesh<dim>& mesh) {
  mesh.origin = origin_near<dim>(mesh.vertices);
  mesh.vertices.colwise() -= mesh.origin;
}

template void take_from_near_origin<FFCONTACT_DIMENSION>(
    SimplexMesh<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
