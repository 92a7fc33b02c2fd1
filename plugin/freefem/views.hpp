// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/row_matrix.hpp"
//
#include "freefem/freefem.hpp"

/// FreeFEM's data as the core's.
namespace ffcontact::plugin {

/// FreeFEM's matrix by rows. A matrix that stores one triangle only (sym=1) is completed.
/// @throws std::invalid_argument  if the matrix was never assigned
RowMatrix matrix_of(Matrice_Creuse<double>* matrix);

Map<VectorXd> vector_of(KN<double>* array);

}  // namespace ffcontact::plugin
