// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/wrench_basis.hpp"

namespace ffcontact {

using Matrix9Xd = Matrix<double, 9, Dynamic>;

using Vector36d = Matrix<double, 36, 1>;

/// face_energy of every tetrahedron in the wrenches and bars of its faces, stored in single
/// precision: the forms only steer a descent, whose corrections are balanced by
/// themselves. Products are of double precision: last digits of x turn last digits of H x
/// alone.
class FaceForms {
 public:
  FaceForms(const SolidTopology& topology, const HookeTensors<3>& hooke);

  /// H x of one tetrahedron.
  Vector36d times(int cell, const Vector36d& x) const;

  /// Block (k, l) of H: the unknowns of face k with those of face l.
  Matrix<float, 9, 9> block(int cell, int k, int l) const;

 private:
  /// H in tiles of 4 x 4, those of the lower triangle column by column of tiles
  static constexpr int tiles = 9, packed = 16 * tiles * (tiles + 1) / 2;
  const float* form(int cell) const {
    return forms_.get() + static_cast<std::size_t>(packed) * cell;
  }
  // Not a vector, which would be filled with zeros by one thread first.
  std::unique_ptr<float[]> forms_;
};

/// The unknowns of a tetrahedron's faces among those of all.
inline Vector36d unknowns_at(const Facets<3>& faces, const Matrix9Xd& of_all,
                             int cell) {
  Vector36d unknowns;
  for (int k = 0; k < 4; ++k)
    unknowns.segment<9>(9 * k) = of_all.col(faces.of_cell(k, cell));
  return unknowns;
}

}  // namespace ffcontact
