// SPDX-License-Identifier: GPL-3.0-or-later
#include "freefem/views.hpp"

#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

RowMatrix matrix_of(Matrice_Creuse<double>* matrix) {
  HashMatrix<int, double>* hash = matrix ? matrix->pHM() : nullptr;
  if (!hash) refuse("the matrix A is not set");
  hash->setfortran(0);
  // FreeFEM's own CSR() sorts slowly
  RowMatrix stored =
      matrix_of_entries(hash->n, hash->m, static_cast<Index>(hash->nnz),
                        hash->i, hash->j, hash->aij);
  if (hash->half) {
    RowMatrix transposed = stored.transpose();
    transposed.prune([](Index i, Index j, double) { return i != j; });
    stored += transposed;
  }
  return stored;  // in place: Eigen 3.4 would copy what it could move
}

Map<VectorXd> vector_of(KN<double>* array) {
  return {static_cast<double*>(*array), array->N()};
}

}  // namespace ffcontact::plugin
