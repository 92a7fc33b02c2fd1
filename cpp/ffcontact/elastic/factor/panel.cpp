// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/panel.hpp"

#include "ffcontact/linear/dense/dense_factors.hpp"

namespace ffcontact {

namespace {

template <class Scalar>
Scalar* column_of(const Panel<Scalar>& panel, int column) {
  return panel.values + static_cast<Index>(column - panel.first) * panel.stride;
}

template <class Scalar>
void scatter(const FactorRows<Scalar>& L, const Scalar* from,
             const Panel<Scalar>& panel) {
  for (int j = 0; j < L.columns; ++j, from += L.rows) {
    Scalar* column = column_of(panel, L.row[j]);
    for (int i = j; i < L.rows; ++i) column[panel.place[L.row[i]]] += from[i];
  }
}

}  // namespace

template <class Scalar>
void subtract_product(const FactorRows<Scalar>& L, const Panel<Scalar>& panel,
                      Matrix<Scalar, Dynamic, 1>& product) {
  const int top = panel.place[L.row[0]],
            bottom = panel.place[L.row[L.rows - 1]];
  if (bottom - top == L.rows - 1) {
    subtract_lower_product<Scalar>(
        L.rows, L.columns, L.depth, L.values, L.stride, 1,
        column_of(panel, L.row[0]) + top, panel.stride);
    return;
  }
  subtract_lower_product<Scalar>(L.rows, L.columns, L.depth, L.values, L.stride,
                                 0, product.data(), L.rows);
  scatter(L, product.data(), panel);
}

template void subtract_product(const FactorRows<double>&, const Panel<double>&,
                               Matrix<double, Dynamic, 1>&);
template void subtract_product(const FactorRows<float>&, const Panel<float>&,
                               Matrix<float, Dynamic, 1>&);

}  // namespace ffcontact
