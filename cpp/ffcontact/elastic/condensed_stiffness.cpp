// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/condensed_stiffness.hpp"

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <new>
#include <stdexcept>

#include "ffcontact/base/require.hpp"

extern "C" {
void dgemm_(const char* transpose_a, const char* transpose_b, const int* rows,
            const int* columns, const int* depth, const double* alpha, const double* a,
            const int* stride_of_a, const double* b, const int* stride_of_b,
            const double* beta, double* c, const int* stride_of_c);
int openblas_get_parallel();
}

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
    common.method[0].ordering = CHOLMOD_NATURAL;  // the matrix comes in elimination order
    common.postorder = 0;
  }
  ~Session() { cholmod_finish(&common); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void require_memory() const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE)
      throw std::bad_alloc();
  }
  mutable cholmod_common common;
};

/// Owner of one CHOLMOD object.
template <class T, int (*Free)(T**, cholmod_common*)>
class Owned {
 public:
  Owned(T* object, const Session& session) : object_(object), session_(&session) {
    if (!object_) session.require_memory();
    if (!object_)
      throw std::runtime_error("CHOLMOD failed with status " +
                               std::to_string(session.common.status));
  }
  ~Owned() { Free(&object_, &session_->common); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  T* operator->() const { return object_; }
  T* get() const { return object_; }

 private:
  T* object_;
  const Session* session_;
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

/// Lower triangle of L L' for a lower triangular L, by blocks of columns: a row of L ends
/// at its diagonal.
MatrixXd lower_product(const MatrixXd& L) {
  constexpr int block = 256;
  const int n = static_cast<int>(L.rows());
  const double one = 1, zero = 0;
  MatrixXd product(n, n);
  for (int first = 0; first < n; first += block) {
    const int rows = n - first, columns = std::min(block, rows), depth = first + columns;
    dgemm_("N", "T", &rows, &columns, &depth, &one, &L(first, 0), &n, &L(first, 0), &n,
           &zero, &product(first, first), &n);
  }
  return product;
}

int* indices(void* p) { return static_cast<int*>(p); }
double* values(void* p) { return static_cast<double*>(p); }

/// Nested dissection of the graph of the vertices that have free dofs and are not kept.
std::vector<int> vertex_order(const ElasticSystem& system,
                              const std::vector<char>& interior, const Session& session) {
  const RowMatrix& K = system.stiffness;
  std::vector<int> vertex, number(interior.size(), -1);
  for (std::size_t v = 0; v < interior.size(); ++v)
    if (interior[v]) {
      number[v] = static_cast<int>(vertex.size());
      vertex.push_back(static_cast<int>(v));
    }
  if (vertex.empty()) return vertex;

  // A vertex sees another one when either of its rows does; the first row holds all of
  // them unless it is prescribed.
  std::vector<int> start(1, 0), neighbours;
  for (int v : vertex) {
    const Index row = system.prescribed[2 * v] ? 2 * v + 1 : 2 * v;
    int last = -1;
    for (RowMatrix::InnerIterator e(K, row); e; ++e) {
      const int w = number[e.col() / 2];
      if (w > number[v] && w != last) neighbours.push_back(last = w);
    }
    start.push_back(static_cast<int>(neighbours.size()));
  }
  const std::size_t n = vertex.size();
  const OwnedSparse graph(
      cholmod_allocate_sparse(n, n, std::max<std::size_t>(1, neighbours.size()), true,
                              true, -1, CHOLMOD_PATTERN, &session.common),
      session);
  std::copy(start.begin(), start.end(), indices(graph->p));
  std::copy(neighbours.begin(), neighbours.end(), indices(graph->i));
  std::vector<int> order(n);
  constexpr int postorder = 1;
  if (!cholmod_metis(graph.get(), nullptr, 0, postorder, order.data(), &session.common)) {
    session.require_memory();
    if (!cholmod_amd(graph.get(), nullptr, 0, order.data(), &session.common))
      session.require_memory();
  }
  for (int& v : order) v = vertex[v];
  return order;
}

/// Free dofs in elimination order: the interior by vertices, then the kept dofs.
std::vector<int> elimination_order(const ElasticSystem& system,
                                   const std::vector<int>& kept, const Session& session) {
  std::vector<char> is_kept(system.prescribed.size(), 0),
      interior(system.prescribed.size() / 2, 0);
  for (int dof : kept) is_kept[dof] = 1;
  const auto inside = [&](int dof) { return !system.prescribed[dof] && !is_kept[dof]; };
  for (int dof = 0; dof < system.dof_count(); ++dof)
    if (inside(dof)) interior[dof / 2] = 1;

  std::vector<int> order;
  for (int v : vertex_order(system, interior, session))
    for (int dof = 2 * v; dof < 2 * v + 2; ++dof)
      if (inside(dof)) order.push_back(dof);
  order.insert(order.end(), kept.begin(), kept.end());
  return order;
}

/// Place of each dof in the elimination order; prescribed ones -1.
std::vector<int> places(const std::vector<int>& order, std::size_t dofs) {
  std::vector<int> place(dofs, -1);
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  return place;
}

/// K_ii^-1/2 on the free dofs [all dofs]; 1 where nothing holds a dof, which shows in the
/// factor.
VectorXd inverse_roots(const ElasticSystem& system) {
  VectorXd roots = VectorXd::Ones(system.dof_count());
  for (int dof = 0; dof < system.dof_count(); ++dof) {
    const double own = system.prescribed[dof] ? 0 : system.stiffness.coeff(dof, dof);
    if (own > 0) roots[dof] = 1 / std::sqrt(own);
  }
  return roots;
}

/// Upper triangle by columns of R (K + D) R in elimination order; by symmetry column j is
/// read from the row of its dof.
cholmod_sparse* upper_triangle(const ElasticSystem& system, const std::vector<int>& order,
                               const std::vector<int>& place,
                               const std::vector<double>& added_diagonal,
                               const VectorXd& scale, const Session& session) {
  const RowMatrix& K = system.stiffness;
  const auto in_upper = [&](const RowMatrix::InnerIterator& e) {
    return place[e.col()] >= 0 && place[e.col()] <= place[e.row()];
  };
  std::size_t entries = 0;
  for (int dof : order)
    for (RowMatrix::InnerIterator e(K, dof); e; ++e) entries += in_upper(e);

  const std::size_t n = order.size();
  cholmod_sparse* upper = cholmod_allocate_sparse(n, n, entries, false, true, 1,
                                                  CHOLMOD_REAL, &session.common);
  if (!upper) throw std::bad_alloc();
  int *start = indices(upper->p), *index = indices(upper->i);
  double* value = values(upper->x);
  int next = 0;
  for (int dof : order) {
    *start++ = next;
    for (RowMatrix::InnerIterator e(K, dof); e; ++e)
      if (in_upper(e)) {
        index[next] = place[e.col()];
        const double sum = e.value() + (e.col() == dof ? added_diagonal[dof] : 0);
        value[next++] = scale[dof] * sum * scale[e.col()];
      }
  }
  *start = next;
  return upper;
}

}  // namespace

struct CondensedStiffness::Factor {
  Session session;
  /// of each dof in the elimination order, the kept ones last; -1 where prescribed
  std::vector<int> place;
  std::vector<int> kept;
  VectorXd added_diagonal;  ///< D on the kept dofs
  VectorXd scale;           ///< R, so that R K R has a diagonal of 1 [all dofs]
  std::unique_ptr<OwnedFactor> cholesky;
  MatrixXd trailing_factor;  ///< L_cc, lower triangular
  MatrixXd schur;

  std::size_t free_count() const { return cholesky->get()->n; }
  std::size_t first_trailing() const { return free_count() - kept.size(); }

  void factorise(cholmod_sparse* matrix) {
    cholesky =
        std::make_unique<OwnedFactor>(cholmod_analyze(matrix, &session.common), session);
    {
      const SerialAssembly serial;
      cholmod_factorize(matrix, cholesky->get(), &session.common);
    }
    session.require_memory();
    // 0 where the factorisation broke off
    if (cholmod_rcond(cholesky->get(), &session.common) < 1e-15)
      throw std::runtime_error(
          "the stiffness matrix is singular: a part of the body is held neither by "
          "prescribed "
          "displacements nor by contact");
  }

  void read_trailing_block() {
    const cholmod_factor& L = *cholesky->get();
    assert(L.is_super && L.is_ll);
    const int first = static_cast<int>(first_trailing()),
              size = static_cast<int>(kept.size());
    trailing_factor = MatrixXd::Zero(size, size);
    const int *super = indices(L.super), *row_start = indices(L.pi),
              *value_start = indices(L.px), *row = indices(L.s);
    const double* value = values(L.x);
    for (int s = static_cast<int>(L.nsuper) - 1; s >= 0 && super[s + 1] > first; --s) {
      const int rows = row_start[s + 1] - row_start[s];
      for (int j = std::max(super[s], first); j < super[s + 1]; ++j)
        for (int k = j - super[s]; k < rows; ++k)
          trailing_factor(row[row_start[s] + k] - first, j - first) =
              value[value_start[s] + (j - super[s]) * rows + k];
    }
  }

  void compute_schur() {
    const Index size = static_cast<Index>(kept.size());
    const MatrixXd product = lower_product(trailing_factor);
    schur.resize(size, size);
    for (Index j = 0; j < size; ++j)
      for (Index i = 0; i < size; ++i) {
        const auto [low, high] = std::minmax(i, j);
        schur(i, j) = product(high, low) / (scale[kept[i]] * scale[kept[j]]);
      }
    schur.diagonal() -= added_diagonal;
  }

  /// Solves with L (CHOLMOD_L) or L' (CHOLMOD_Lt) [free dofs].
  VectorXd step(int system, const VectorXd& right) const {
    cholmod_dense b{};
    b.nrow = b.nzmax = b.d = static_cast<std::size_t>(right.size());
    b.ncol = 1;
    b.x = const_cast<double*>(right.data());  // read only by cholmod_solve
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    const OwnedDense x(cholmod_solve(system, cholesky->get(), &b, &session.common),
                       session);
    return Map<VectorXd>(values(x->x), right.size());
  }

  /// L^-1 R b on the free dofs in elimination order.
  VectorXd forward(const Ref<const VectorXd>& load) const {
    require_size("load", load.size(), static_cast<Index>(place.size()));
    VectorXd b(free_count());
    for (std::size_t dof = 0; dof < place.size(); ++dof)
      if (place[dof] >= 0) b[place[dof]] = scale[dof] * load[dof];
    return step(CHOLMOD_L, b);
  }
};

CondensedStiffness::CondensedStiffness(const ElasticSystem& system,
                                       const std::vector<int>& kept)
    : factor_(std::make_unique<Factor>()) {
  Factor& f = *factor_;
  f.kept = kept;
  f.added_diagonal.resize(static_cast<Index>(kept.size()));
  std::vector<double> added(system.prescribed.size(), 0);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const int dof = kept[k];
    if (dof < 0 || dof >= system.dof_count() || system.prescribed[dof])
      refuse("kept dof ", dof, " is prescribed or does not exist");
    if (added[dof] != 0) refuse("kept dof ", dof, " is listed twice");
    added[dof] = f.added_diagonal[k] = system.stiffness.coeff(dof, dof);
  }
  f.scale = inverse_roots(system);
  const std::vector<int> order = elimination_order(system, kept, f.session);
  f.place = places(order, system.prescribed.size());
  const OwnedSparse matrix(
      upper_triangle(system, order, f.place, added, f.scale, f.session), f.session);
  f.factorise(matrix.get());
  f.read_trailing_block();
  f.compute_schur();
}

CondensedStiffness::~CondensedStiffness() = default;
CondensedStiffness::CondensedStiffness(CondensedStiffness&&) noexcept = default;
CondensedStiffness& CondensedStiffness::operator=(CondensedStiffness&&) noexcept =
    default;

const MatrixXd& CondensedStiffness::schur() const { return factor_->schur; }

VectorXd CondensedStiffness::condensed_load(const Ref<const VectorXd>& load) const {
  const Factor& f = *factor_;
  const auto size = static_cast<Index>(f.kept.size());
  const VectorXd g =
      f.trailing_factor.triangularView<Eigen::Lower>() * f.forward(load).tail(size);
  VectorXd result(size);
  for (Index k = 0; k < size; ++k) result[k] = g[k] / f.scale[f.kept[k]];
  return result;
}

VectorXd CondensedStiffness::extended(
    const Ref<const VectorXd>& load, const Ref<const VectorXd>& kept_displacement) const {
  const Factor& f = *factor_;
  const auto size = static_cast<Index>(f.kept.size());
  require_size("kept displacement", kept_displacement.size(), size);
  VectorXd u_c(size);
  for (Index k = 0; k < size; ++k) u_c[k] = kept_displacement[k] / f.scale[f.kept[k]];
  // L' x = y has the trailing part L_cc' u_c = y_c: overwriting y_c prescribes u_c.
  VectorXd y = f.forward(load);
  y.tail(size) = f.trailing_factor.transpose().triangularView<Eigen::Upper>() * u_c;
  const VectorXd x = f.step(CHOLMOD_Lt, y);
  VectorXd u = VectorXd::Zero(static_cast<Index>(f.place.size()));
  for (std::size_t dof = 0; dof < f.place.size(); ++dof)
    if (f.place[dof] >= 0) u[dof] = f.scale[dof] * x[f.place[dof]];
  return u;
}

}  // namespace ffcontact
