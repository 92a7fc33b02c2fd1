// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/tiled_factor.hpp"
#include "ffcontact/equilibrium/wrench_basis.hpp"

namespace ffcontact {

using Matrix9Xd = Matrix<double, 9, Dynamic>;

using Vector36d = Matrix<double, 36, 1>;

/// face_energy of every tetrahedron in the wrenches and bars of its faces, while it stays
/// balanced: the wrench w_d on one face is what balances the others (balancing_shift),
///     x = T z,   z = x without w_d [30],   x' H x = z' (T' H T) z.
/// That face is the largest, to which shifts are small: where w_d vanishes, as around an
/// edge of the three others, terms of their square cancel.
///
/// Stored in single precision: the forms only steer a descent, whose corrections are
/// balanced by themselves. Products are of double precision: last digits of x turn last
/// digits of H x alone.
class FaceForms {
 public:
  /// Unknowns in z, and the numbers that are stored of a tetrahedron: T' H T in the tiles of
  /// tiled_factor, the unknowns of the three faces after d, then the bars of d.
  static constexpr int free_unknowns = 30;
  static constexpr Index stored = factor_size(free_unknowns);

  FaceForms(const SolidTopology& topology, const HookeTensors<3>& hooke);

  /// H x of one tetrahedron that x leaves balanced, but for what no such x has a product
  /// with: it is 0 for w_d.
  Vector36d times(int cell, const Vector36d& x) const;

  /// Block (k, l) of the form: the unknowns of face k with those of face l, 0 for w_d.
  Matrix<float, 9, 9> block(int cell, int k, int l) const;

 private:
  using InTiles = Matrix<double, tiled(free_unknowns), 1>;

  void put_form(const Matrix<float, 36, 36>& H, int cell);
  InTiles product(int cell, const InTiles& z) const;
  const float* form(int cell) const { return forms_.get() + stored * cell; }

  Flags dependent_;  ///< d, 0 to 3
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
