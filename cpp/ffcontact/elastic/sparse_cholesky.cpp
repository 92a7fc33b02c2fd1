// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/sparse_cholesky.hpp"

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <new>
#include <stdexcept>
#include <string>

extern "C" int openblas_get_parallel();

namespace ffcontact {

namespace {

/// CHOLMOD's workspace, silent: errors are read from its status.
class Session {
 public:
  Session() {
    cholmod_start(&common);
    common.print = 0;
    common.error_handler = nullptr;
    // the trailing block is read from the supernodes
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering =
        CHOLMOD_NATURAL;  // the matrix comes in elimination order
    common.postorder = 0;
  }
  ~Session() { cholmod_finish(&common); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void require_memory() const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY ||
        common.status == CHOLMOD_TOO_LARGE)
      throw std::bad_alloc();
  }
  mutable cholmod_common common;
};

template <class T>
using FreeFunction = int (*)(T**, cholmod_common*);

/// Owner of one CHOLMOD object.
template <class T, FreeFunction<T> free>
class Owned {
 public:
  Owned(T* object, const Session& session)
      : object_(object), session_(session) {
    if (object_) return;
    session.require_memory();
    throw std::runtime_error("CHOLMOD failed with status " +
                             std::to_string(session.common.status));
  }
  ~Owned() { free(&object_, &session_.common); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  T* operator->() const { return object_; }
  T* get() const { return object_; }

 private:
  T* object_;
  const Session& session_;
};
using OwnedSparse = Owned<cholmod_sparse, cholmod_free_sparse>;
using OwnedDense = Owned<cholmod_dense, cholmod_free_dense>;
using OwnedFactor = Owned<cholmod_factor, cholmod_free_factor>;

/// While it lives, CHOLMOD assembles on one thread. It asks for four whatever the machine
/// has; on two cores they cost more than they do. The dense kernels, which are
/// OpenBLAS's, keep its threads unless those are OpenMP's too.
class SerialAssembly {
 public:
  SerialAssembly() {
    constexpr int openmp = 2;
    if (openblas_get_parallel() != openmp) omp_set_max_active_levels(0);
  }
  ~SerialAssembly() { omp_set_max_active_levels(levels_); }
  SerialAssembly(const SerialAssembly&) = delete;
  SerialAssembly& operator=(const SerialAssembly&) = delete;

 private:
  const int levels_ = omp_get_max_active_levels();
};

int* indices(void* p) { return static_cast<int*>(p); }
double* values(void* p) { return static_cast<double*>(p); }

void copy(const std::vector<int>& from, void* to) {
  std::copy(from.begin(), from.end(), indices(to));
}

/// Room for the lower triangle of a pattern.
cholmod_sparse* pattern_of_size(std::size_t n, std::size_t entries,
                                const Session& session) {
  constexpr int sorted = 1, packed = 1, lower = -1;
  cholmod_sparse* room = cholmod_allocate_sparse(
      n, n, entries, sorted, packed, lower, CHOLMOD_PATTERN, &session.common);
  if (!room) throw std::bad_alloc();
  return room;
}

/// A graph as the lower triangle of a pattern.
cholmod_sparse* pattern(const Graph& graph, const Session& session) {
  const std::size_t entries = std::max<std::size_t>(1, graph.neighbours.size());
  cholmod_sparse* result =
      pattern_of_size(graph.vertex_count(), entries, session);
  copy(graph.start, result->p);
  copy(graph.neighbours, result->i);
  return result;
}

/// CHOLMOD's view of an upper triangle, which it only reads.
cholmod_sparse view_of(const SparseMatrix& upper) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(upper.cols());
  view.nzmax = static_cast<std::size_t>(upper.nonZeros());
  view.p = const_cast<int*>(upper.outerIndexPtr());
  view.i = const_cast<int*>(upper.innerIndexPtr());
  view.x = const_cast<double*>(upper.valuePtr());
  view.stype = 1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.packed = 1;
  return view;
}

cholmod_dense view_of(const VectorXd& b) {
  cholmod_dense view{};
  view.nrow = view.nzmax = view.d = static_cast<std::size_t>(b.size());
  view.ncol = 1;
  view.x = const_cast<double*>(b.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

/// One supernode of a factor: columns that have the same rows below their diagonal block.
struct Supernode {
  int first_column, end_column, row_count;
  const int* rows;
  const double* values;  ///< [rows x columns]

  Supernode(const cholmod_factor& L, int s)
      : first_column(indices(L.super)[s]),
        end_column(indices(L.super)[s + 1]),
        row_count(indices(L.pi)[s + 1] - indices(L.pi)[s]),
        rows(indices(L.s) + indices(L.pi)[s]),
        values(::ffcontact::values(L.x) + indices(L.px)[s]) {}

  /// Adds its columns from `first` on to the trailing block that begins there.
  void copy_to(MatrixXd& block, int first) const {
    for (int j = std::max(first_column, first); j < end_column; ++j) {
      const int column = j - first_column;
      for (int k = column; k < row_count; ++k)
        block(rows[k] - first, j - first) = values[column * row_count + k];
    }
  }
};

/// METIS's nested dissection, or minimum degree where METIS fails.
void put_order(cholmod_sparse* graph, const Session& session, int* order) {
  constexpr int postorder = 1;
  if (cholmod_metis(graph, nullptr, 0, postorder, order, &session.common))
    return;
  session.require_memory();
  if (!cholmod_amd(graph, nullptr, 0, order, &session.common))
    session.require_memory();
}

}  // namespace

std::vector<int> dissection_order(const Graph& graph) {
  std::vector<int> order(graph.vertex_count());
  if (order.empty()) return order;
  const Session session;
  const OwnedSparse sparse(pattern(graph, session), session);
  put_order(sparse.get(), session, order.data());
  return order;
}

struct SparseCholesky::Factor {
  Session session;
  OwnedFactor L;

  explicit Factor(cholmod_sparse matrix)
      : L(cholmod_analyze(&matrix, &session.common), session) {
    const SerialAssembly serial;
    cholmod_factorize(&matrix, L.get(), &session.common);
    session.require_memory();
  }

  VectorXd solve(int system, const VectorXd& b) const {
    cholmod_dense right = view_of(b);
    const OwnedDense x(cholmod_solve(system, L.get(), &right, &session.common),
                       session);
    return Map<VectorXd>(values(x->x), b.size());
  }
};

SparseCholesky::SparseCholesky(const SparseMatrix& upper)
    : factor_(std::make_unique<Factor>(view_of(upper))) {}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

int SparseCholesky::size() const { return static_cast<int>(factor_->L->n); }

double SparseCholesky::reciprocal_condition() const {
  return cholmod_rcond(factor_->L.get(), &factor_->session.common);
}

MatrixXd SparseCholesky::trailing_block(int size) const {
  const cholmod_factor& L = *factor_->L.get();
  assert(L.is_super && L.is_ll);
  const int first = this->size() - size;
  MatrixXd block = MatrixXd::Zero(size, size);
  for (int s = static_cast<int>(L.nsuper) - 1; s >= 0; --s) {
    const Supernode supernode(L, s);
    if (supernode.end_column <= first) break;
    supernode.copy_to(block, first);
  }
  return block;
}

VectorXd SparseCholesky::half_solve(const VectorXd& b) const {
  return factor_->solve(CHOLMOD_L, b);
}

VectorXd SparseCholesky::other_half_solve(const VectorXd& b) const {
  return factor_->solve(CHOLMOD_Lt, b);
}

}  // namespace ffcontact
