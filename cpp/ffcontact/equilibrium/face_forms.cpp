// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/face_forms.hpp"

#include <Eigen/LU>

#include "ffcontact/equilibrium/face_tractions.hpp"

namespace ffcontact {

FaceForms::FaceForms(const SolidTopology& topology,
                     const HookeTensors<3>& hooke) {
  const int cells = topology.mesh.cell_count();
  forms_.reset(new float[static_cast<std::size_t>(packed) * cells]);
#pragma omp parallel for
  for (int t = 0; t < cells; ++t) {
    const FaceForm H =
        face_energy(corners_of(topology.mesh, t), hooke[t].inverse(),
                    wrench_bases(topology, t));
    float* next = forms_.get() + static_cast<std::size_t>(packed) * t;
    for (int r = 0; r < 36; ++r)
      for (int c = 0; c <= r; ++c) *next++ = static_cast<float>(H(r, c));
  }
}

Matrix<double, 36, 1> FaceForms::times(int cell,
                                       const Matrix<double, 36, 1>& x) const {
  const float* row = form(cell);
  Matrix<double, 36, 1> y;
  for (int r = 0; r < 36; row += ++r) {
    double sum = row[r] * x[r];
    for (int c = 0; c < r; ++c) {
      sum += row[c] * x[c];
      y[c] += row[c] * x[r];
    }
    y[r] = sum;
  }
  return y;
}

Matrix9d FaceForms::block(int cell, int k, int l) const {
  const float* H = form(cell);
  Matrix9d block;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) {
      const int r = std::max(9 * k + i, 9 * l + j),
                c = std::min(9 * k + i, 9 * l + j);
      block(i, j) = H[r * (r + 1) / 2 + c];
    }
  return block;
}

}  // namespace ffcontact
