// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/condensed_stiffness.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/factor/elimination_order.hpp"
#include "ffcontact/elastic/factor/partial_cholesky.hpp"
#include "ffcontact/elastic/factor/scaled_stiffness.hpp"

namespace ffcontact {

namespace {

/// R K R in elimination order.
struct Eliminated {
  const RowMatrix& K;
  const std::vector<int>& order;
  const std::vector<int>& place;
  const VectorXd& scale;  ///< R

  bool in_lower(const RowMatrix::InnerIterator& e) const {
    return place[e.col()] >= place[e.row()];
  }

  /// R_i K_ij R_j
  double scaled(const RowMatrix::InnerIterator& e) const {
    return scale[e.row()] * e.value() * scale[e.col()];
  }

  Index lower_entries() const {
    Index entries = 0;
    for (int dof : order)
      for (RowMatrix::InnerIterator e(K, dof); e; ++e) entries += in_lower(e);
    return entries;
  }

  /// By symmetry column j is read from the row of its dof.
  void append_column(Index j, SparseMatrix& lower) const {
    lower.startVec(j);
    for (RowMatrix::InnerIterator e(K, order[j]); e; ++e)
      if (in_lower(e))
        lower.insertBackByOuterInnerUnordered(j, place[e.col()]) = scaled(e);
  }

  SparseMatrix lower_triangle() const {
    const auto n = static_cast<Index>(order.size());
    SparseMatrix lower(n, n);
    lower.reserve(std::max<Index>(1, lower_entries()));
    for (Index j = 0; j < n; ++j) append_column(j, lower);
    lower.finalize();
    return lower;
  }
};

using AnyCholesky =
    std::variant<PartialCholesky<double>, PartialCholesky<float>>;

/// Reciprocal condition below which a factor is none.
template <class Scalar>
constexpr double least_condition =
    std::is_same_v<Scalar, double> ? 1e-15 : 1e-6;

template <class Scalar>
PartialCholesky<Scalar> regular_factor(const SparseMatrix& lower, int kept,
                                       const ProgressReport& report) {
  PartialCholesky<Scalar> factor(lower, kept, report);
  if (factor.reciprocal_condition() < least_condition<Scalar>)
    fail_as_singular();
  return factor;
}

AnyCholesky factorised(const SparseMatrix& lower, int kept, Precision precision,
                       const ProgressReport& report) {
  if (precision == Precision::full)
    return regular_factor<double>(lower, kept, report);
  return regular_factor<float>(lower, kept, report);
}

/// S, taken out of the factor of R K R.
MatrixXd schur_of(AnyCholesky& factor, const VectorXd& R) {
  return std::visit([&R](auto& own) { return unscaled(own.take_schur(), R); },
                    factor);
}

}  // namespace

struct CondensedStiffness::Factor {
  std::vector<int> kept;
  VectorXd scale;  ///< R, so that R K R has a diagonal of 1 [all dofs]
  std::vector<int>
      order;  ///< the free dofs as they are eliminated, the kept ones last
  std::vector<int> place;  ///< of each dof in it; -1 where prescribed
  AnyCholesky cholesky;
  MatrixXd schur;

  Factor(const ElasticSystem& system, const std::vector<int>& kept_dofs,
         Precision precision, const ProgressReport& report)
      : kept(kept_dofs),
        scale(inverse_roots(system)),
        order(elimination_order(system, kept)),
        place(places(order, system.prescribed.size())),
        cholesky(factorised(
            Eliminated{system.stiffness, order, place, scale}.lower_triangle(),
            static_cast<int>(kept.size()), precision, report)),
        schur(schur_of(cholesky, scale(kept))) {}

  Index kept_count() const { return static_cast<Index>(kept.size()); }

  /// R^-1 x on the kept dofs.
  VectorXd unscaled(const VectorXd& x) const {
    return x.cwiseQuotient(scale(kept));
  }

  /// L^-1 R b on the free dofs in elimination order; R g on the kept ones.
  VectorXd forward(const Ref<const VectorXd>& load) const {
    require_size("load", load.size(), scale.size());
    const VectorXd b = scale(order).cwiseProduct(load(order));
    return std::visit([&b](const auto& L) { return L.half_solve(b); },
                      cholesky);
  }

  /// R L'^-1 y on all dofs, 0 on prescribed ones.
  VectorXd backward(const VectorXd& y) const {
    VectorXd u = VectorXd::Zero(scale.size());
    const VectorXd x = std::visit(
        [&y](const auto& L) { return L.other_half_solve(y); }, cholesky);
    u(order) = scale(order).cwiseProduct(x);
    return u;
  }
};

CondensedStiffness::CondensedStiffness(const ElasticSystem& system,
                                       const std::vector<int>& kept,
                                       Precision precision,
                                       const ProgressReport& report)
    : factor_(std::make_unique<Factor>(system, required_kept(system, kept),
                                       precision, report)) {}

CondensedStiffness::CondensedStiffness() = default;
CondensedStiffness::~CondensedStiffness() = default;
CondensedStiffness::CondensedStiffness(CondensedStiffness&&) noexcept = default;
CondensedStiffness& CondensedStiffness::operator=(
    CondensedStiffness&&) noexcept = default;

Precision CondensedStiffness::precision() const {
  return std::holds_alternative<PartialCholesky<double>>(factor_->cholesky)
             ? Precision::full
             : Precision::single;
}

const MatrixXd& CondensedStiffness::schur() const { return factor_->schur; }

CondensedStiffness::Load CondensedStiffness::condensed(
    const Ref<const VectorXd>& load) const {
  VectorXd y = factor_->forward(load);
  VectorXd g = factor_->unscaled(y.tail(factor_->kept_count()));
  return {std::move(y), std::move(g)};
}

VectorXd CondensedStiffness::extended(
    Load load, const Ref<const VectorXd>& kept_displacement) const {
  const Index kept = factor_->kept_count();
  require_size("kept displacement", kept_displacement.size(), kept);
  // overwriting y_c prescribes u_c
  load.eliminated.tail(kept) = factor_->unscaled(kept_displacement);
  return factor_->backward(load.eliminated);
}

}  // namespace ffcontact
