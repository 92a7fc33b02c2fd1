// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set/convex_contact.hpp"

#include <algorithm>

#include "ffcontact/contact/active_set/next_states.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/minimum/bounded_minimum.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// r of the proximal terms: far above rounding, below what a body that is held has. With
/// the second one passes are slower, but C of a body that contact alone holds is small
/// enough to tell where two nodes of one vertex meet.
constexpr double proximal_terms[] = {1e-9, 1e-5};
/// r of the dependent rows falls by this factor from pass to pass, down to what rounding
/// allows: beside the compliance of a soft body it may be far above what moves their
/// multipliers.
constexpr double fall = 0.1, least_proximal = 1e-13;
constexpr int most_passes = 30;
/// Passes end when they change v by less than this part of what the loads would.
constexpr double settled = 1e-13;

/// Positions are those of the primary rows, then those of the dependent ones. Multipliers
/// are measured in units that give C a diagonal of 1.
class ProximalPasses {
 public:
  ProximalPasses(const CondensedContact& contact, const NodalLaw& law,
                 double proximal)
      : contact_(contact),
        law_(law),
        proximal_(proximal),
        dependent_proximal_(proximal),
        primary_(contact.S.rows()),
        dependent_(contact.E.cols()) {
    rows_ = contact.primary;
    rows_.insert(rows_.end(), contact.dependent.begin(),
                 contact.dependent.end());
    put_compliance();
    put_bounds();
    x_ = VectorXd::Zero(low_.size());
    v_ = VectorXd::Zero(primary_);
  }

  /// @return Cholesky factorisations
  int pass(int most_steps) {
    compliance_.diagonal()
        .tail(dependent_)
        .setConstant(1 + dependent_proximal_);
    dependent_proximal_ = std::max(fall * dependent_proximal_, least_proximal);
    const VectorXd h =
        unit_.cwiseProduct(displacement_of_multipliers()) - compliance_ * x_;
    BoundedMinimum minimum =
        bounded_minimum(compliance_, h, low_, high_, x_, most_steps);
    x_ = std::move(minimum.x);
    const VectorXd v = (compliance_ * x_ + h)
                           .head(primary_)
                           .cwiseQuotient(unit_.head(primary_));
    change_ = max_norm(v - v_);
    v_ = v;
    return minimum.steps;
  }

  /// Largest change of v by the last pass.
  double change() const { return change_; }

  /// By how much the multipliers do not balance v, relative to these or the loads: what
  /// the proximal terms still carry.
  double imbalance() const {
    const VectorXd P = unit_.cwiseProduct(x_);
    const double largest = std::max(max_norm(P), max_norm(contact_.g));
    const double off = max_norm(P.head(primary_) - balanced());
    return relative(off, largest);
  }

  ContactRows answer() const {
    const VectorXd P = unit_.cwiseProduct(x_), q = P.tail(dependent_);
    const VectorXd balanced = this->balanced();
    const VectorXd moved = dependent_displacement(v_, q);
    ContactRows rows{VectorXd(P.size()), VectorXd(P.size())};
    for (Index k = 0; k < P.size(); ++k) {
      const bool at_bound = x_[k] == low_[k] || x_[k] == high_[k];
      rows.P[rows_[k]] = at_bound || k >= primary_ ? P[k] : balanced[k];
      rows.v[rows_[k]] = k < primary_ ? v_[k] : moved[k - primary_];
    }
    return rows;
  }

  ContactStates states() const {
    ContactStates states;
    for (int node = 0; node < x_.size() / 2; ++node)
      states.push_back(state(node));
    return states;
  }

 private:
  /// 1 along t, -1 against t, where friction is at its bound; 0 where it holds.
  int slip(int node) const {
    const Index t = place(2 * node + 1);
    return x_[t] == -bound(t) ? 1 : x_[t] == bound(t) ? -1 : 0;
  }
  ContactState state(int node) const {
    if (law_.cone[node].bonded) return ContactState::stick;
    const bool open = x_[place(2 * node)] == 0;
    if (law_.cone[node].frictionless())
      return open ? ContactState::open : ContactState::slip_forward;
    return open ? open_state(slip(node)) : closed_state(slip(node));
  }

  /// Multipliers of the primary rows that balance v.
  VectorXd balanced() const {
    const VectorXd q = unit_.cwiseProduct(x_).tail(dependent_);
    return contact_.S * v_ - contact_.g - contact_.E * q;
  }

  Index place(int row) const {
    const int k = contact_.position[row];
    return k >= 0 ? k : primary_ - 1 - k;
  }

  void put_compliance() {
    MatrixXd S = contact_.S;
    S.diagonal() *= 1 + proximal_;
    stiffness_ = Cholesky(S);
    MatrixXd C = compliance();
    const double softest = C.diagonal().head(primary_).maxCoeff();
    for (Index k = primary_; k < C.rows(); ++k)
      if (C(k, k) == 0) C(k, k) = softest;
    unit_ = C.diagonal().cwiseSqrt().cwiseInverse();
    compliance_ = unit_.asDiagonal() * C * unit_.asDiagonal();
  }

  /// With S' = S + r diag(S):   [S'^-1, S'^-1 E; E' S'^-1, F + E' S'^-1 E].
  MatrixXd compliance() const {
    const MatrixXd& E = contact_.E;
    MatrixXd C(primary_ + dependent_, primary_ + dependent_);
    C.topLeftCorner(primary_, primary_) =
        stiffness_.solve_columns(MatrixXd::Identity(primary_, primary_));
    auto coupling = C.topRightCorner(primary_, dependent_);
    coupling = stiffness_.solve_columns(E);
    C.bottomLeftCorner(dependent_, primary_) = coupling.transpose();
    C.bottomRightCorner(dependent_, dependent_) =
        contact_.F + transposed_product(E, coupling);
    return C;
  }

  /// b of a tangential position in its unit; the law has no other friction.
  double bound(Index k) const {
    const FrictionCone& cone = law_.cone[rows_[k] / 2];
    return cone.bonded ? infinity : cone.cohesion / unit_[k];
  }

  void put_bounds() {
    low_.resize(unit_.size());
    high_.resize(unit_.size());
    for (Index k = 0; k < unit_.size(); ++k) {
      const bool pressed = rows_[k] % 2 == 0 && !law_.cone[rows_[k] / 2].bonded;
      low_[k] = pressed ? -infinity : -bound(k);
      high_[k] = pressed ? 0 : bound(k);
    }
    for (Index d = 0; d < dependent_; ++d)
      if (!contact_.loads_the_body(d))
        low_[primary_ + d] = high_[primary_ + d] = idle_multiplier(d);
  }

  /// Of a dependent row that does not load the body: its v is given, and with it what
  /// friction does there.
  double idle_multiplier(Index d) const {
    const Index k = primary_ + d;
    const double v = contact_.dependent_offset[d];
    if (rows_[k] % 2 == 0 || v == 0 || law_.cone[rows_[k] / 2].bonded) return 0;
    return v > 0 ? -bound(k) : bound(k);
  }

  VectorXd dependent_displacement(const VectorXd& v, const VectorXd& q) const {
    return contact_.E.transpose() * v + contact_.F * q +
           contact_.dependent_offset;
  }

  /// v of all rows under the multipliers of the last pass, by what they still lack of
  /// balancing its v.
  VectorXd displacement_of_multipliers() const {
    const VectorXd P = unit_.cwiseProduct(x_), q = P.tail(dependent_);
    VectorXd v(P.size());
    v.head(primary_) = v_ + stiffness_.solve(P.head(primary_) + contact_.g +
                                             contact_.E * q - contact_.S * v_);
    v.tail(dependent_) = dependent_displacement(v.head(primary_), q);
    return v;
  }

  const CondensedContact& contact_;
  const NodalLaw& law_;
  const double proximal_;
  double dependent_proximal_;  ///< r of the dependent rows in the next pass
  const Index primary_, dependent_;
  std::vector<int> rows_;  ///< of each position
  Cholesky stiffness_;     ///< S + r diag(S)
  MatrixXd compliance_;
  VectorXd unit_, low_, high_;
  VectorXd x_, v_;  ///< multipliers in their units; v of the primary rows
  double change_ = 0;
};

/// Whether the face that a pass ended on fulfils the law without the proximal terms.
bool keep_face(const CondensedContact& contact, const NodalLaw& law,
               const ProximalPasses& passes, double tolerance,
               ActiveSetResult& result) {
  ContactRows rows;
  const SystemKind kind = solve_active_set(contact, law, passes.states(), rows);
  if (kind == SystemKind::inconsistent) return false;
  const double violation = law_violation(contact, law, rows);
  if (violation > tolerance) return false;
  result.keep(passes.states(), std::move(rows), violation);
  return true;
}

/// Passes with one r. @return whether they ended at a solution
bool pass_to_the_minimum(const CondensedContact& contact, const NodalLaw& law,
                         double proximal, const NewtonSettings& settings,
                         ActiveSetResult& result) {
  ProximalPasses passes(contact, law, proximal);
  for (int k = 0;
       k < most_passes && result.iterations < settings.max_iterations; ++k) {
    const int left = settings.max_iterations - result.iterations;
    result.iterations += std::max(1, passes.pass(left));
    ContactRows rows = passes.answer();
    const double violation =
        std::max(law_violation(contact, law, rows), passes.imbalance());
    tell(settings.report,
         {"convex minimum", result.iterations, "violation", violation});
    const bool ends =
        violation <= settings.tolerance &&
        passes.change() <= settled * motion_scale(contact, rows.v);
    if (violation < result.violation || ends)
      result.keep(passes.states(), std::move(rows), violation);
    if (ends || keep_face(contact, law, passes, settings.tolerance, result))
      return true;
  }
  return false;
}

}  // namespace

ActiveSetResult convex_contact(const CondensedContact& contact,
                               const NodalLaw& law,
                               const NewtonSettings& settings) {
  ActiveSetResult result;
  result.violation = infinity;
  for (const double proximal : proximal_terms)
    if (pass_to_the_minimum(contact, law, proximal, settings, result)) break;
  if (result.violation <= settings.tolerance) {
    result.status = ContactStatus::converged;
    put_into_law(law, result.state, result.P);
  }
  return result;
}

ActiveSetResult solve_convex(const CondensedContact& contact,
                             const NodalLaw& law, ContactStates state,
                             const NewtonSettings& settings) {
  ActiveSetResult newton =
      active_set_newton(contact, law, std::move(state), settings);
  const int left = settings.max_iterations - newton.iterations;
  if (newton.status == ContactStatus::converged || left <= 0) return newton;
  ActiveSetResult convex =
      convex_contact(contact, law, settings.with_at_most(left));
  if (newton.status == ContactStatus::singular &&
      convex.status != ContactStatus::converged)
    convex.status = newton.status;
  ActiveSetResult& better = convex.is_better_than(newton) ? convex : newton;
  better.iterations = newton.iterations + convex.iterations;
  return better;
}

}  // namespace ffcontact
