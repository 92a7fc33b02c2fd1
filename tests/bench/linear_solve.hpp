// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

#include <stdexcept>
#include <vector>

#include "ffcontact/elastic/elastic_system.hpp"

/// What the benchmarks compare with.
namespace ffcontact::bench {

/// One linear solve: CHOLMOD with its METIS ordering on the graph of the dofs, analyse +
/// factorise + solve, of the stiffness matrix without its prescribed rows. The matrix is
/// copied for CHOLMOD beforehand, which does not count.
class LinearSolve {
 public:
  explicit LinearSolve(const ElasticSystem& system) {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_METIS;

    std::vector<int> number(system.prescribed.size(), -1);
    int n = 0;
    for (std::size_t dof = 0; dof < number.size(); ++dof)
      if (!system.prescribed[dof]) number[dof] = n++;
    matrix_ = cholmod_allocate_sparse(n, n, system.stiffness.nonZeros(), true,
                                      true, 1, CHOLMOD_REAL, &common_);
    load_ = cholmod_allocate_dense(n, 1, n, CHOLMOD_REAL, &common_);
    int *start = static_cast<int*>(matrix_->p),
        *index = static_cast<int*>(matrix_->i), next = 0;
    double *value = static_cast<double*>(matrix_->x),
           *load = static_cast<double*>(load_->x);
    for (int row = 0; row < system.dof_count(); ++row) {
      if (number[row] < 0) continue;
      *start++ = next;
      *load++ = system.load[row];
      for (RowMatrix::InnerIterator e(system.stiffness, row); e; ++e)
        if (number[e.col()] >= 0 && e.col() <= row) {
          index[next] = number[e.col()];
          value[next++] = e.value();
        }
    }
    *start = next;
  }
  ~LinearSolve() {
    cholmod_free_dense(&load_, &common_);
    cholmod_free_sparse(&matrix_, &common_);
    cholmod_finish(&common_);
  }
  LinearSolve(const LinearSolve&) = delete;
  LinearSolve& operator=(const LinearSolve&) = delete;

  void run() {
    cholmod_factor* factor = cholmod_analyze(matrix_, &common_);
    cholmod_factorize(matrix_, factor, &common_);
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor, load_, &common_);
    if (common_.status != CHOLMOD_OK)
      throw std::runtime_error("CHOLMOD failed");
    cholmod_free_dense(&x, &common_);
    cholmod_free_factor(&factor, &common_);
  }

 private:
  cholmod_common common_;
  cholmod_sparse* matrix_;
  cholmod_dense* load_;
};

}  // namespace ffcontact::bench
