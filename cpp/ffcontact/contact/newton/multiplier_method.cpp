// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/multiplier_method.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// c over the stiffness of its node: from minimum to minimum that much more.
constexpr double first_penalty = 1, growth = 10, most_penalty = 1e6;
constexpr int most_minima = 60;
/// r
constexpr double proximal_term = 1e-9;
/// Newton's method: gradient beside its terms at the minimum, and from where on what no
/// longer halves is rounding.
constexpr double gradient_of_minimum = 1e-14, gradient_beside_it = 1e-9;
constexpr double least_step = 1e-6;
constexpr int most_steps = 60, most_halvings = 40;

/// The augmented Lagrangian at the multipliers P_k, in unknowns scaled by D^-1/2.
class AugmentedLagrangian {
 public:
  AugmentedLagrangian(const CondensedContact& contact, BodyRelation body,
                      const NodalLaw& law, const Flags& held)
      : contact_(contact), law_(law), held_(held) {
    const VectorXd unit =
        body.S.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    S_ = unit.asDiagonal() * body.S * unit.asDiagonal();
    g_ = unit.cwiseProduct(body.g);
    A_ = contact.A * unit.asDiagonal();
    z_ = last_z_ = VectorXd::Zero(g_.size());
    P_ = VectorXd::Zero(A_.rows());
    put_stiffness();
  }

  /// z_k and P_(k+1). @return Cholesky factorisations
  int minimise(double penalty, int most) {
    penalty_ = penalty;
    last_z_ = z_;
    int steps = 0;
    for (double off = infinity; steps < std::min(most, most_steps);) {
      const double last = std::exchange(off, imbalance());
      if (off <= gradient_of_minimum ||
          (off <= gradient_beside_it && off > last / 2))
        break;
      ++steps;
      if (!step()) break;
    }
    P_ = force(z_);
    return steps;
  }

  ContactRows rows() const { return {P_, displacement(z_)}; }

 private:
  /// c at penalty 1: what a node's own motion in A meets of S, which has a diagonal of 1.
  void put_stiffness() {
    VectorXd square = VectorXd::Zero(A_.rows());
    for (Index column = 0; column < A_.cols(); ++column)
      for (SparseMatrix::InnerIterator a(A_, column); a; ++a)
        square[a.row()] += a.value() * a.value();
    stiffness_ = VectorXd::Zero(law_.node_count());
    for (Index row = 0; row < A_.rows(); ++row) {
      double& own = stiffness_[row / 3];
      if (!held_[row]) own = std::max(own, square[row]);
    }
    const double most = max_norm(stiffness_);
    for (double& own : stiffness_)
      own = 1 / (own > 0 ? own : most > 0 ? most : 1);
  }

  VectorXd displacement(const VectorXd& z) const {
    return A_ * z + contact_.v_prescribed;
  }

  /// P_k - c v of a node, 0 in held rows.
  Vector3d trial(const VectorXd& v, int node) const {
    Vector3d tau = P_.segment<3>(3 * node) -
                   penalty_ * stiffness_[node] * v.segment<3>(3 * node);
    for (int c = 0; c < 3; ++c)
      if (held_[3 * node + c]) tau[c] = 0;
    return tau;
  }

  /// Pi(P_k - c v)
  VectorXd force(const VectorXd& z) const {
    const VectorXd v = displacement(z);
    VectorXd P(v.size());
    for (int node = 0; node < law_.node_count(); ++node)
      P.segment<3>(3 * node) = projected(law_.cone[node], trial(v, node));
    return P;
  }

  VectorXd forces_of_body(const VectorXd& z) const {
    return S_ * z - g_ + proximal_term * (z - last_z_);
  }

  VectorXd gradient(const VectorXd& z) const {
    return forces_of_body(z) - A_.transpose() * force(z);
  }

  /// The gradient beside its terms.
  double imbalance() const {
    const VectorXd of_contact = A_.transpose() * force(z_);
    const double size = std::max(max_norm(of_contact), max_norm(g_));
    return relative(max_norm(forces_of_body(z_) - of_contact), size);
  }

  /// Pi' of a node
  static Matrix3d derivative(const NodeState& node) {
    Matrix3d D = Matrix3d::Identity();
    D(0, 0) = node.open ? 0 : 1;
    if (node.slips)
      D.bottomRightCorner<2, 2>() =
          node.share * (Matrix2d::Identity() - node.e * node.e.transpose());
    return D;
  }

  /// S + A'c Pi' A + r
  MatrixXd hessian() const {
    const VectorXd v = displacement(z_);
    std::vector<Eigen::Triplet<double>> entries;
    for (int node = 0; node < law_.node_count(); ++node) {
      const Matrix3d D =
          penalty_ * stiffness_[node] *
          derivative(node_state(law_.cone[node], trial(v, node)));
      const int first = 3 * node;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          if (!held_[first + i] && !held_[first + j] && D(i, j) != 0)
            entries.emplace_back(first + i, first + j, D(i, j));
    }
    SparseMatrix D(A_.rows(), A_.rows());
    D.setFromTriplets(entries.begin(), entries.end());
    MatrixXd H = S_;
    H += SparseMatrix(A_.transpose() * D * A_);
    H.diagonal().array() += proximal_term;
    return H;
  }

  /// Along Newton's direction, until the slope there has fallen enough. @return whether
  /// there was such a step
  bool step() {
    const VectorXd now = gradient(z_);
    const Cholesky H(hessian());
    if (!H.is_positive_definite()) return false;
    const VectorXd d = -H.solve(now);
    const double slope = now.dot(d);
    if (!(slope < 0)) return false;
    double low = 0, high = 1, t = 1;
    for (int k = 0; k < most_halvings; ++k) {
      const double there = gradient(z_ + t * d).dot(d);
      if (std::abs(there) <= -slope / 2 || (there < 0 && t == 1)) break;
      (there > 0 ? high : low) = t;
      t = (low + high) / 2;
    }
    z_ += t * d;
    return t > least_step;
  }

  const CondensedContact& contact_;
  const NodalLaw& law_;
  const Flags& held_;
  MatrixXd S_;
  VectorXd g_;
  SparseMatrix A_;
  VectorXd stiffness_;  ///< [p]
  VectorXd z_, last_z_, P_;
  double penalty_ = 1;
};

}  // namespace

ActiveSetResult multiplier_method(const CondensedContact& contact,
                                  const CondensedStiffness& stiffness,
                                  const NodalLaw& law, const Flags& held,
                                  const NewtonSettings& settings) {
  AugmentedLagrangian lagrangian(contact, body_relation(contact, stiffness),
                                 law, held);
  const NaturalMap map(contact, held);
  ActiveSetResult result;
  result.violation = infinity;
  double penalty = first_penalty;
  for (int k = 0;
       k < most_minima && result.iterations < settings.max_iterations; ++k) {
    result.iterations +=
        std::max(1, lagrangian.minimise(
                        penalty, settings.max_iterations - result.iterations));
    penalty = std::min(growth * penalty, most_penalty);
    ContactRows rows = lagrangian.rows();
    const double violation = surface_violation(contact, law, held, rows);
    tell(settings.report,
         {"method of multipliers", result.iterations, "violation", violation});
    if (violation < result.violation) {
      ContactStates states = contact_states(map.states(law, rows));
      result.keep(std::move(states), std::move(rows), violation);
    }
    if (result.violation <= settings.enough) break;
  }
  if (result.violation <= settings.tolerance)
    result.status = ContactStatus::converged;
  return result;
}

}  // namespace ffcontact
