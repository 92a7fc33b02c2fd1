// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/condensed_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/elimination_order.hpp"
#include "ffcontact/elastic/sparse_cholesky.hpp"

extern "C" void dgemm_(const char* transpose_a, const char* transpose_b,
                       const int* rows, const int* columns, const int* depth,
                       const double* alpha, const double* a,
                       const int* stride_of_a, const double* b,
                       const int* stride_of_b, const double* beta, double* c,
                       const int* stride_of_c);

namespace ffcontact {

namespace {

/// Lower triangle of L L' for a lower triangular L, by blocks of columns: a row of L ends
/// at its diagonal.
MatrixXd lower_product(const MatrixXd& L) {
  constexpr int block = 256;
  const int n = static_cast<int>(L.rows());
  const double one = 1, zero = 0;
  MatrixXd product(n, n);
  for (int first = 0; first < n; first += block) {
    const int rows = n - first, columns = std::min(block, rows),
              depth = first + columns;
    dgemm_("N", "T", &rows, &columns, &depth, &one, &L(first, 0), &n,
           &L(first, 0), &n, &zero, &product(first, first), &n);
  }
  return product;
}

/// Place of each dof in the elimination order; prescribed ones -1.
std::vector<int> places(const std::vector<int>& order, std::size_t dofs) {
  std::vector<int> place(dofs, -1);
  int next = 0;
  for (int dof : order) place[dof] = next++;
  return place;
}

/// K_ii^-1/2; 1 where nothing holds a dof, which shows in the factor.
double inverse_root(const ElasticSystem& system, int dof) {
  if (system.prescribed[dof]) return 1;
  const double own = system.stiffness.coeff(dof, dof);
  return own > 0 ? 1 / std::sqrt(own) : 1;
}

/// R [all dofs], 1 where prescribed.
VectorXd inverse_roots(const ElasticSystem& system) {
  VectorXd roots(system.dof_count());
  for (int dof = 0; dof < system.dof_count(); ++dof)
    roots[dof] = inverse_root(system, dof);
  return roots;
}

void require_free(const ElasticSystem& system, int dof) {
  if (dof < 0 || dof >= system.dof_count() || system.prescribed[dof])
    refuse("kept dof ", dof, " is prescribed or does not exist");
}

/// D on the kept dofs [all dofs]: the diagonal of K.
VectorXd added_diagonal(const ElasticSystem& system,
                        const std::vector<int>& kept) {
  VectorXd added = VectorXd::Zero(system.dof_count());
  for (int dof : kept) {
    require_free(system, dof);
    if (added[dof] != 0) refuse("kept dof ", dof, " is listed twice");
    added[dof] = system.stiffness.coeff(dof, dof);
  }
  return added;
}

/// R (K + D) R in elimination order.
struct Eliminated {
  const RowMatrix& K;
  const std::vector<int>& order;
  const std::vector<int>& place;
  const VectorXd& added;  ///< D
  const VectorXd& scale;  ///< R

  bool in_upper(const RowMatrix::InnerIterator& e) const {
    return place[e.col()] >= 0 && place[e.col()] <= place[e.row()];
  }

  /// R_i (K + D)_ij R_j
  double scaled(const RowMatrix::InnerIterator& e) const {
    const double sum = e.value() + (e.col() == e.row() ? added[e.row()] : 0);
    return scale[e.row()] * sum * scale[e.col()];
  }

  Index upper_entries() const {
    Index entries = 0;
    for (int dof : order)
      for (RowMatrix::InnerIterator e(K, dof); e; ++e) entries += in_upper(e);
    return entries;
  }

  /// By symmetry column j is read from the row of its dof.
  void append_column(Index j, SparseMatrix& upper) const {
    upper.startVec(j);
    for (RowMatrix::InnerIterator e(K, order[j]); e; ++e)
      if (in_upper(e))
        upper.insertBackByOuterInnerUnordered(j, place[e.col()]) = scaled(e);
  }

  SparseMatrix upper_triangle() const {
    const auto n = static_cast<Index>(order.size());
    SparseMatrix upper(n, n);
    upper.reserve(std::max<Index>(1, upper_entries()));
    for (Index j = 0; j < n; ++j) append_column(j, upper);
    upper.finalize();
    return upper;
  }
};

SparseCholesky factorised(const SparseMatrix& upper) {
  SparseCholesky factor(upper);
  if (factor.reciprocal_condition() < 1e-15)
    throw std::runtime_error(
        "the stiffness matrix is singular: a part of the body is held neither "
        "by prescribed displacements nor by contact");
  return factor;
}

}  // namespace

struct CondensedStiffness::Factor {
  std::vector<int> kept;
  VectorXd scale;  ///< R, so that R K R has a diagonal of 1 [all dofs]
  std::vector<int>
      order;  ///< the free dofs as they are eliminated, the kept ones last
  std::vector<int> place;  ///< of each dof in it; -1 where prescribed
  SparseCholesky cholesky;
  MatrixXd trailing_factor;  ///< L_cc, lower triangular
  MatrixXd schur;

  Factor(const ElasticSystem& system, const std::vector<int>& kept_dofs,
         const VectorXd& added)
      : kept(kept_dofs),
        scale(inverse_roots(system)),
        order(elimination_order(system, kept)),
        place(places(order, system.prescribed.size())),
        cholesky(
            factorised(Eliminated{system.stiffness, order, place, added, scale}
                           .upper_triangle())),
        trailing_factor(
            cholesky.trailing_block(static_cast<int>(kept.size()))) {
    compute_schur(added);
  }

  Index kept_count() const { return static_cast<Index>(kept.size()); }

  /// S = R^-1 L_cc L_cc' R^-1 - D
  void compute_schur(const VectorXd& added) {
    const VectorXd R = scale(kept);
    schur = lower_product(trailing_factor).selfadjointView<Eigen::Lower>();
    for (Index j = 0; j < kept_count(); ++j) {
      schur.col(j).array() /= R.array() * R[j];
      schur(j, j) -= added[kept[j]];
    }
  }

  /// R^-1 x on the kept dofs.
  VectorXd unscaled(const VectorXd& x) const {
    return x.cwiseQuotient(scale(kept));
  }

  /// L^-1 R b on the free dofs in elimination order.
  VectorXd forward(const Ref<const VectorXd>& load) const {
    require_size("load", load.size(), scale.size());
    return cholesky.half_solve(scale(order).cwiseProduct(load(order)));
  }

  /// R L'^-1 y on all dofs, 0 on prescribed ones.
  VectorXd backward(const VectorXd& y) const {
    VectorXd u = VectorXd::Zero(scale.size());
    u(order) = scale(order).cwiseProduct(cholesky.other_half_solve(y));
    return u;
  }

  /// R^-1 L_cc y_c
  VectorXd load_on_kept(const VectorXd& y) const {
    const auto L_cc = trailing_factor.triangularView<Eigen::Lower>();
    return unscaled(L_cc * y.tail(kept_count()));
  }

  /// y_c = L_cc' R^-1 u_c, the trailing part of L' x = y
  VectorXd trailing_load(const VectorXd& u_c) const {
    const auto L_cc = trailing_factor.triangularView<Eigen::Lower>();
    return L_cc.transpose() * unscaled(u_c);
  }
};

CondensedStiffness::CondensedStiffness(const ElasticSystem& system,
                                       const std::vector<int>& kept)
    : factor_(std::make_unique<Factor>(system, kept,
                                       added_diagonal(system, kept))) {}

CondensedStiffness::~CondensedStiffness() = default;
CondensedStiffness::CondensedStiffness(CondensedStiffness&&) noexcept = default;
CondensedStiffness& CondensedStiffness::operator=(
    CondensedStiffness&&) noexcept = default;

const MatrixXd& CondensedStiffness::schur() const { return factor_->schur; }

CondensedStiffness::Load CondensedStiffness::condensed(
    const Ref<const VectorXd>& load) const {
  VectorXd y = factor_->forward(load);
  VectorXd g = factor_->load_on_kept(y);
  return {std::move(y), std::move(g)};
}

VectorXd CondensedStiffness::extended(
    Load load, const Ref<const VectorXd>& kept_displacement) const {
  const Index kept = factor_->kept_count();
  require_size("kept displacement", kept_displacement.size(), kept);
  // overwriting y_c prescribes u_c
  load.eliminated.tail(kept) = factor_->trailing_load(kept_displacement);
  return factor_->backward(load.eliminated);
}

}  // namespace ffcontact
