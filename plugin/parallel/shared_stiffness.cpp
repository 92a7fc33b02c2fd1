// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/shared_stiffness.hpp"

#include <cmath>
#include <tuple>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/factor/elimination_order.hpp"
#include "ffcontact/elastic/factor/scaled_stiffness.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact::plugin {

namespace {

/// What each process has to know of an order.
std::vector<FactorOrder> orders_of(const std::vector<std::vector<int>>& dofs,
                                   const std::vector<int>& order, int kept,
                                   Precision precision, const VectorXd& scale) {
  const std::vector<int> place = places(order, scale.size());
  std::vector<FactorOrder> orders;
  for (const std::vector<int>& own : dofs) {
    FactorOrder of_part{count_of(order), kept, precision, {}, scale(own)};
    for (int dof : own) of_part.place.push_back(place[dof]);
    orders.push_back(std::move(of_part));
  }
  return orders;
}

}  // namespace

MatrixPart matrix_part(const ElasticSystem& part, const FactorOrder& order) {
  MatrixPart matrix;
  for (int i = 0; i < part.dof_count(); ++i) {
    if (order.place[i] < 0 || part.prescribed[i]) continue;
    for (RowMatrix::InnerIterator e(part.stiffness, i); e; ++e) {
      const Index j = e.col();
      if (part.prescribed[j] || order.place[j] < 0 ||
          order.place[j] > order.place[i])
        continue;
      matrix.row.push_back(order.place[i]);
      matrix.column.push_back(order.place[j]);
      matrix.value.push_back(order.scale[i] * e.value() * order.scale[j]);
    }
  }
  return matrix;
}

SharedStiffness::SharedStiffness(std::shared_ptr<Team> team,
                                 const std::vector<std::vector<int>>& dofs,
                                 const ElasticSystem& own,
                                 const ElasticSystem& system,
                                 const std::vector<int>& kept,
                                 Precision precision)
    : team_(std::move(team)),
      precision_(precision),
      kept_(count_of(kept)),
      order_(elimination_order(system, required_kept(system, kept))),
      scale_(inverse_roots(system)) {
  std::tie(factor_, schur_) = team_->factorise(
      orders_of(dofs, order_, count_of(kept), precision, scale_),
      [&own](const FactorOrder& order) { return matrix_part(own, order); });
  schur_ = unscaled(std::move(schur_), scale_(kept));
  require_regular(system);
}

SharedStiffness::~SharedStiffness() { team_->discard(factor_); }

/// Where nothing holds a part of the body, what K u balances is not u.
void SharedStiffness::require_regular(const ElasticSystem& system) const {
  const double much = precision_ == Precision::full ? 1e-3 : 0.1;
  VectorXd u = VectorXd::Zero(scale_.size());
  for (int k = 0; k < count_of(order_); ++k)
    u[order_[k]] = scale_[order_[k]] * (1.5 + std::sin(0.7 * (k % 1009)));
  const VectorXd kept = u(order_).tail(kept_count());
  const VectorXd found = extended(condensed(system.stiffness * u), kept);
  const VectorXd wrong = (found - u)(order_).cwiseQuotient(scale_(order_));
  if (!(max_norm(wrong) <= much)) fail_as_singular();
}

CondensedStiffness::Load SharedStiffness::condensed(
    const Ref<const VectorXd>& load) const {
  require_size("load", load.size(), scale_.size());
  VectorXd b = scale_(order_).cwiseProduct(load(order_));
  const VectorXd g = team_->condensed(factor_, b);
  const VectorXd R = scale_(order_).tail(kept_count());
  last_ = b;
  return {std::move(b), g.cwiseQuotient(R)};
}

VectorXd SharedStiffness::extended(Load load,
                                   const Ref<const VectorXd>& kept) const {
  require_size("kept displacement", kept.size(), kept_count());
  if (load.eliminated != last_) {
    team_->condensed(factor_, load.eliminated);
    last_ = load.eliminated;
  }
  const VectorXd R = scale_(order_).tail(kept_count());
  const VectorXd x = team_->extended(factor_, kept.cwiseQuotient(R));
  VectorXd u = VectorXd::Zero(scale_.size());
  u(order_) = scale_(order_).cwiseProduct(x);
  last_.resize(0);
  return u;
}

}  // namespace ffcontact::plugin
