// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/wrench_basis.hpp"

namespace ffcontact {

using Matrix9Xd = Matrix<double, 9, Dynamic>;

/// face_energy of every tetrahedron in the wrenches and bars of its faces, in single
/// precision: the forms only steer a descent, whose corrections are balanced by
/// themselves.
class FaceForms {
 public:
  FaceForms(const SolidTopology& topology, const HookeTensors<3>& hooke);

  /// H x of one tetrahedron.
  Matrix<double, 36, 1> times(int cell, const Matrix<double, 36, 1>& x) const;

  /// Block (k, l) of H: the unknowns of face k with those of face l.
  Matrix9d block(int cell, int k, int l) const;

 private:
  static constexpr int packed = 36 * 37 / 2;  ///< lower triangle, row by row
  const float* form(int cell) const {
    return forms_.get() + static_cast<std::size_t>(packed) * cell;
  }
  // Not a vector, which would be filled with zeros by one thread first.
  std::unique_ptr<float[]> forms_;
};

/// The unknowns of a tetrahedron's faces among those of all.
inline Matrix<double, 36, 1> unknowns_at(const Facets<3>& faces,
                                         const Matrix9Xd& of_all, int cell) {
  Matrix<double, 36, 1> unknowns;
  for (int k = 0; k < 4; ++k)
    unknowns.segment<9>(9 * k) = of_all.col(faces.of_cell(k, cell));
  return unknowns;
}

}  // namespace ffcontact
