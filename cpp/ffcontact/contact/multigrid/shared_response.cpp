// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/shared_response.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace ffcontact {

namespace {

/// s over the stiffness.
constexpr double of_softness = 1e4;

/// Row by row:   L P = of_force F + of_v v~ + of_z z + given.
class Conditions {
 public:
  Conditions(const SharedVertex& shared, const SurfaceEquations& equations,
             bool friction)
      : shared_(shared),
        equations_(equations),
        friction_(friction),
        give_(shared.layer + softness(shared)),
        L_(MatrixXd::Zero(shared.row_count(), shared.row_count())),
        right_(shared) {
    for (int k = 0; k < shared.row_count(); ++k)
      if (holds(shared, equations, k))
        take_force(k);
      else
        put_state(k);
  }

  SharedResponse response() && {
    const Eigen::PartialPivLU<MatrixXd> L(L_);
    right_.of_force = L.solve(right_.of_force);
    right_.of_v = L.solve(right_.of_v);
    right_.of_z = L.solve(right_.of_z);
    right_.given = L.solve(right_.given);
    return std::move(right_);
  }

 private:
  void take_force(int k) {
    L_.row(k) = shared_.E.col(k).transpose();
    right_.of_force(k, k) = 1;
  }

  void put_state(int k) {
    const Equation equation = equations_.equation(shared_.rows[k]);
    const auto has_v = [](const Term& term) { return term.v != 0; };
    const bool moves =
        std::any_of(equation.terms.begin(), equation.terms.end(), has_v);
    if (k >= shared_.first_coupling() && moves)
      put_coupling(k, k - shared_.first_coupling(), equation);
    else
      put_explicit(k, equation);
  }

  /// With a coefficient of about 1 for P.
  void put_explicit(int k, const Equation& equation) {
    const double scale =
        equations_.is_fixed(shared_.rows[k]) ? 1 / give_[k] : 1;
    visit(k, equation, [&](int l, double of_P, double of_v) {
      L_(k, l) += scale * of_P;
      right_.of_v(k, l) -= scale * of_v;
    });
    right_.given[k] = scale * equation.value;
  }

  void put_coupling(int k, int q, const Equation& equation) {
    const int row = shared_.rows[k];
    const double scale =
        equations_.is_fixed(row) ? equations_.stiffness(row / 3) : 1;
    L_(k, k) = 1;
    right_.of_z(k, q) = 1;
    visit(k, equation, [&](int l, double of_P, double of_v) {
      right_.z_of_P(q, l) += scale * of_P;
      right_.z_of_v(q, l) += scale * of_v;
    });
    right_.z_value[q] = scale * equation.value;
  }

  /// The terms of P and v~.
  template <class Visit>
  void visit(int k, const Equation& equation, const Visit& visit) const {
    const auto& rows = shared_.rows;
    for (const Term& term : equation.terms) {
      if (!friction_ && rows[k] % 3 > 0 && term.row % 3 == 0) continue;
      const auto found = std::find(rows.begin(), rows.end(), term.row);
      const auto l = static_cast<int>(found - rows.begin());
      visit(l, term.P + term.v * give_[l], term.v);
    }
  }

  const SharedVertex& shared_;
  const SurfaceEquations& equations_;
  bool friction_;
  VectorXd give_;
  MatrixXd L_;
  SharedResponse right_;
};

}  // namespace

SharedResponse::SharedResponse(const SharedVertex& shared)
    : of_force(MatrixXd::Zero(shared.row_count(), 3)),
      of_v(MatrixXd::Zero(shared.row_count(), shared.row_count())),
      of_z(MatrixXd::Zero(shared.row_count(), shared.coupling)),
      given(VectorXd::Zero(shared.row_count())),
      z_of_P(MatrixXd::Zero(shared.coupling, shared.row_count())),
      z_of_v(z_of_P),
      z_value(VectorXd::Zero(shared.coupling)) {}

VectorXd softness(const SharedVertex& shared) {
  return (of_softness * shared.stiffness).cwiseInverse();
}

bool holds(const SharedVertex& shared, const SurfaceEquations& equations,
           int place) {
  return place < shared.own && shared.layer[place] == 0 &&
         equations.is_fixed(shared.rows[place]);
}

SharedResponse shared_response(const SharedVertex& shared,
                               const SurfaceEquations& equations,
                               bool friction) {
  return Conditions(shared, equations, friction).response();
}

}  // namespace ffcontact
