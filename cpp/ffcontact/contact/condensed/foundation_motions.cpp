// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed/foundation_motions.hpp"

#include "ffcontact/base/flags.hpp"

namespace ffcontact {

namespace {

/// [A, B]
SparseMatrix beside(const SparseMatrix& A, const SparseMatrix& B) {
  SparseMatrix both(A.rows(), A.cols() + B.cols());
  both.leftCols(A.cols()) = A;
  both.rightCols(B.cols()) = B;
  return both;
}

/// Forces on held rows load no body, and none of the foundation's then.
MatrixXd felt(MatrixXd trace, const ContactLaw<2>& law, const Flags& held) {
  if (law.multiplier == Multiplier::pressure) return trace;
  for (Index row = 0; row < trace.rows(); ++row)
    if (held[row]) trace.row(row).setZero();
  return trace;
}

}  // namespace

void add_motions(const FoundationMotions& foundation, const ContactLaw<2>& law,
                 const Flags& held, const SparseMatrix& W,
                 ContactTrace& trace) {
  if (foundation.trace.cols() == 0) return;
  const MatrixXd moved = -(W * felt(foundation.trace, law, held));
  trace.A = beside(trace.A, moved.sparseView());
  trace.to_kept =
      beside(trace.to_kept, SparseMatrix(trace.to_kept.rows(), moved.cols()));
  trace.opposite_load = foundation.load;
}

}  // namespace ffcontact
