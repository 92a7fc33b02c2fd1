// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/matrix_free/product_relation.hpp"
#include "ffcontact/contact/newton/newton_relation.hpp"

namespace ffcontact {

/// The system of surface_step by products with S alone, to 1e-4 a step as InexactStep,
/// with residuals of double precision. Unknown are v of the primary rows without the
/// condition v = 0, w_o, and P of the dependent rows that are not held.
///
/// GMRES for the increment, preconditioned as the lines of (ProductPreconditioner)
///     T (S + T^-1 c D) x - T E q,    B x + C q.
/// Where it does not converge, as on bodies that an active set leaves free, the increment
/// is held by springs, which leave the solution what it is.
struct ProductStep {
  SystemKind kind = SystemKind::regular;
  int products = 0;  ///< with S, of GMRES
};

/// @param rows  the last ones, then the next; unchanged if the system is not solved
ProductStep solve_product_step(const ProductRelation& relation,
                               const SurfaceEquations& equations,
                               ContactRows& rows);

}  // namespace ffcontact
