// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/panel.hpp"

extern "C" {
void dgemm_(const char* transpose_a, const char* transpose_b, const int* rows,
            const int* columns, const int* depth, const double* alpha,
            const double* a, const int* stride_of_a, const double* b,
            const int* stride_of_b, const double* beta, double* c,
            const int* stride_of_c);
void dsyrk_(const char* triangle, const char* transpose, const int* n,
            const int* depth, const double* alpha, const double* a,
            const int* stride_of_a, const double* beta, double* c,
            const int* stride_of_c);
}

namespace ffcontact {

namespace {

double* column_of(const Panel& panel, int column) {
  return panel.values + static_cast<Index>(column - panel.first) * panel.stride;
}

/// target = beta target - L L_c', below the diagonal.
void subtract_dense(const FactorRows& L, double beta, double* target,
                    int stride) {
  const double minus = -1;
  const int below = L.rows - L.columns;
  dsyrk_("L", "N", &L.columns, &L.depth, &minus, L.values, &L.stride, &beta,
         target, &stride);
  if (below > 0)
    dgemm_("N", "T", &below, &L.columns, &L.depth, &minus, L.values + L.columns,
           &L.stride, L.values, &L.stride, &beta, target + L.columns, &stride);
}

void scatter(const FactorRows& L, const double* from, const Panel& panel) {
  for (int j = 0; j < L.columns; ++j, from += L.rows) {
    double* column = column_of(panel, L.row[j]);
    for (int i = j; i < L.rows; ++i) column[panel.place[L.row[i]]] += from[i];
  }
}

}  // namespace

void subtract_product(const FactorRows& L, const Panel& panel,
                      VectorXd& product) {
  const int top = panel.place[L.row[0]],
            bottom = panel.place[L.row[L.rows - 1]];
  if (bottom - top == L.rows - 1) {
    subtract_dense(L, 1, column_of(panel, L.row[0]) + top, panel.stride);
    return;
  }
  subtract_dense(L, 0, product.data(), L.rows);
  scatter(L, product.data(), panel);
}

}  // namespace ffcontact
