// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/corrected_answer.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/checks/balance.hpp"

namespace ffcontact {

namespace {

constexpr int correction_limit = 20;
constexpr int systems_of_correction = 30;  ///< of a correction
/// Of what is missed by a correction.
constexpr double least_gain = 2;
/// What a violation may be of the residual before a correction, which gains more.
constexpr double beside_residual = 1e-3;
/// Nothing beside the tolerance.
constexpr double beside_tolerance = 1e-2;
/// Residuals below this are rounding.
constexpr double residual_rounding = 1e-12;

/// A state as answers have it.
ContactState answered(ContactState state) {
  if (is_open(state)) return ContactState::open;
  if (!is_limited(state)) return state;
  return slip_sign(state) > 0 ? ContactState::slip_forward
                              : ContactState::slip_backward;
}

}  // namespace

template <int d>
CorrectedAnswer<d>::CorrectedAnswer(const StatedContact<d>& stated,
                                    std::unique_ptr<ContactRelation> relation)
    : stated_(stated),
      relation_(std::move(relation)),
      displacement_(stated.system.prescribed_value) {
  RelationAnswer first = relation_->answer();
  history_ = std::move(first.law.history);
  scales_ = relation_->scales(
      first.law.answer.v.head(d * stated.contact.node_count()));
  take(std::move(first));
}

template <int d>
void CorrectedAnswer<d>::correct() {
  for (int k = 0; k < correction_limit && can_gain(); ++k) {
    const ActiveSetResult last = condensed_;
    const VectorXd u = displacement_, P = P_;
    const Missed before = missed_;
    take(next(last));
    condensed_.iterations += last.iterations;
    if (missed_.largest() < before.largest() / least_gain) continue;
    condensed_ = last;
    displacement_ = u;
    P_ = P;
    missed_ = before;
    return;
  }
}

/// Without its rounding, or where the law is missed, too, by the law anew.
template <int d>
RelationAnswer CorrectedAnswer<d>::next(const ActiveSetResult& last) {
  const VectorXd none = VectorXd::Zero(stated_.system.dof_count());
  const LastAnswer known{last,
                         force_residual(stated_.system, displacement_, none),
                         stated_.v_of(displacement_, P_)};
  if (missed_.of_law <= stated_.settings.tolerance)
    if (std::optional<RelationAnswer> refined = relation_->refined(known))
      return *std::move(refined);
  return relation_->corrected(known, limits());
}

template <int d>
bool CorrectedAnswer<d>::is_off() const {
  return missed_.largest() > stated_.settings.tolerance;
}

template <int d>
ContactSolution<d> CorrectedAnswer<d>::solution(
    const SimplexMesh<d>& mesh) const {
  const double tolerance = stated_.settings.tolerance;
  ContactSolution<d> solution;
  solution.displacement = displacement_;
  solution.force = stated_.forces_of(P_);
  for (ContactState state : condensed_.state)
    solution.state.push_back(answered(state));
  solution.iterations = condensed_.iterations;
  solution.products = relation_->products();
  solution.history = history_;
  solution.complementarity = missed_.of_law;
  solution.residual =
      with_balance(missed_.residual.of_forces,
                   balance_defect(mesh, stated_.system, stated_.load_of(P_)));
  solution.status = judged_status(condensed_.status, solution.complementarity,
                                  solution.residual, tolerance);
  return solution;
}

template <int d>
ResidualDefect CorrectedAnswer<d>::residual_with(const VectorXd& P) const {
  return residual_defect(stated_.system, displacement_, stated_.load_of(P),
                         largest_given(stated_.law));
}

/// The law is met as well as the correction after this one will need it.
template <int d>
NewtonSettings CorrectedAnswer<d>::limits() const {
  const double tolerance = stated_.settings.tolerance,
               enough = std::max(beside_tolerance * tolerance,
                                 beside_residual * missed_.residual.of_forces);
  return {systems_of_correction, std::max(tolerance, enough),
          stated_.settings.report, enough};
}

template <int d>
bool CorrectedAnswer<d>::can_gain() const {
  return condensed_.status == ContactStatus::converged &&
         (is_off() || missed_.residual.of_forces >
                          beside_tolerance * stated_.settings.tolerance);
}

template <int d>
void CorrectedAnswer<d>::take(RelationAnswer answer) {
  condensed_ = std::move(answer.law.answer);
  displacement_ += answer.displacement;
  P_ = condensed_.P.head(d * stated_.contact.node_count());
  if (d == 3) P_ = without(stated_.held.row, P_);
  missed_.residual = residual_with(P_);
  if (d == 2) drop_rounding();
  missed_.of_law = stated_.law_defect(displacement_, P_, scales_);
}

/// Multipliers that the residual does not notice are none with Coulomb's law: their
/// friction would know no slip. Plane bodies are asked, whose residuals cost little.
template <int d>
void CorrectedAnswer<d>::drop_rounding() {
  if (stated_.law.tresca() || condensed_.status != ContactStatus::converged)
    return;
  const VectorXd none = VectorXd::Zero(P_.size());
  const ResidualDefect left = residual_with(none);
  if (left.largest() > std::max(residual_rounding, missed_.residual.largest()))
    return;
  P_ = condensed_.P = none;
  missed_.residual = left;
}

template class CorrectedAnswer<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
