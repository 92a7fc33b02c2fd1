// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/shared_rows.hpp"

#include <Eigen/LU>

namespace ffcontact {

namespace {

/// 0 for y that are held.
Vector3d moving(const SharedVertex& shared, const SurfaceEquations& equations) {
  Vector3d moves = Vector3d::Zero();
  for (int k = 0; k < shared.own; ++k)
    moves[k] = holds(shared, equations, k) ? 0 : 1;
  return moves;
}

Matrix3d symmetric(const Matrix3d& S) { return 0.5 * (S + S.transpose()); }

/// - E' of_v E of the y that move, without what P_n makes of P_t.
Matrix3d springs_of(const SharedVertex& shared,
                    const SurfaceEquations& equations, const Vector3d& moves) {
  const MatrixXd of_v = shared_response(shared, equations, false).of_v;
  const Matrix3d S = -shared.E.transpose() * of_v * shared.E;
  return moves.asDiagonal() * symmetric(S) * moves.asDiagonal();
}

}  // namespace

SharedRows::SharedRows(const std::vector<SharedVertex>& shared)
    : shared_(shared), first_{0} {
  for (const SharedVertex& vertex : shared) {
    first_.push_back(first_.back() + vertex.coupling);
    states_.push_back({SharedResponse(vertex)});
  }
}

SharedRows::State SharedRows::state(const SharedVertex& shared,
                                    const SurfaceEquations& equations,
                                    const VectorXd& P) const {
  State state{shared_response(shared, equations)};
  SharedResponse& response = state.response;
  const VectorXd v = v_prescribed_(shared.rows) -
                     softness(shared).cwiseProduct(P(shared.rows));
  response.given += response.of_v * v;
  response.z_value -= response.z_of_v * v;
  state.moves = moving(shared, equations);
  state.springs = springs_of(shared, equations, state.moves);
  return state;
}

void SharedRows::put(const SurfaceEquations& equations, const VectorXd& P) {
  for (int i = 0; i < count(); ++i)
    states_[i] = state(shared_[i], equations, P);
}

void SharedRows::put_own(const VectorXd& v, const VectorXd& P,
                         VectorXd& y) const {
  for (const SharedVertex& shared : shared_)
    shared.for_own([&](int k, int row, int place) {
      y[place] = v[row] - v_prescribed_[row] - shared.layer[k] * P[row];
    });
}

VectorXd SharedRows::z_of(const VectorXd& P) const {
  VectorXd z(first_.back());
  for (int i = 0; i < count(); ++i)
    z_at(i, z) = own(i, P).tail(shared_[i].coupling);
  return z;
}

void SharedRows::fix(VectorXd& y) const {
  for (int i = 0; i < count(); ++i)
    shared_[i].for_own([&](int k, int row, int place) {
      if (moves(i)[k] == 0) y[place] = -v_prescribed_[row];
    });
}

VectorXd SharedRows::forces(int i, const Vector3d& F, const VectorXd& v,
                            const VectorXd& z) const {
  const SharedResponse& response = states_[i].response;
  return response.of_force * F + response.of_v * v + forces_of_z(i, z);
}

VectorXd SharedRows::z_missed(int i, const VectorXd& v,
                              const VectorXd& P) const {
  const SharedResponse& response = states_[i].response;
  return response.z_of_P * P + response.z_of_v * v;
}

/// Of what is left at a vertex by its y.
Matrix3d SharedRows::derivative(int i, const Matrix3d& D) const {
  const SharedVertex& shared = shared_[i];
  const SharedResponse& response = states_[i].response;
  const Matrix3d of_P =
      shared.E.transpose() * (response.of_force * D + response.of_v * shared.E);
  Matrix3d H = moves(i).asDiagonal() * (D - of_P) * moves(i).asDiagonal();
  H.diagonal() += Vector3d::Ones() - moves(i);
  return H;
}

void SharedRows::relax(int i, const Matrix3d& D, const VectorXd& F,
                       const VectorXd& z, VectorXd& y) const {
  const SharedVertex& shared = shared_[i];
  const Vector3d force = SharedVertex::at(shared.vertex, F);
  const VectorXd P =
      forces(i, force, shared.motion(y), z) + states_[i].response.given;
  const Vector3d left = force - shared.E.transpose() * P;
  const Vector3d change =
      derivative(i, D).inverse() * moves(i).cwiseProduct(left);
  if (change.allFinite()) y.segment<3>(3 * shared.vertex) -= change;
}

/// F - E'P of the y that move, F_j - E_j'P.
template <class Vector>
void SharedRows::take(int i, const VectorXd& P, Vector& F) const {
  using Number = typename Vector::Scalar;
  shared_[i].add_forces(-P, F);
  F.template segment<3>(3 * shared_[i].vertex).array() *=
      moves(i).array().template cast<Number>();
}

void SharedRows::take(const VectorXd& P, VectorXd& F) const {
  for (int i = 0; i < count(); ++i) take(i, own(i, P), F);
}

VectorXd SharedRows::put_forces(const VectorXd& y, const VectorXd& z,
                                const VectorXd& F, VectorXd& P) const {
  VectorXd missed(z.size());
  for (int i = 0; i < count(); ++i) {
    const SharedVertex& shared = shared_[i];
    const SharedResponse& response = states_[i].response;
    const VectorXd v = shared.motion(y);
    const VectorXd own =
        forces(i, SharedVertex::at(shared.vertex, F), v, z) + response.given;
    P(shared.rows) = own;
    z_at(i, missed) = z_missed(i, v, own) - response.z_value;
  }
  return missed;
}

void SharedRows::put_motion(const VectorXd& y, const VectorXd& P,
                            VectorXd& v) const {
  for (const SharedVertex& shared : shared_)
    v(shared.rows) = shared.motion(y) + v_prescribed_(shared.rows) +
                     shared.layer.cwiseProduct(P(shared.rows));
}

VectorXf SharedRows::change(const VectorXf& y, const VectorXf& z,
                            VectorXf& F) const {
  const VectorXd all_z = z.cast<double>();
  VectorXf of_z(z.size());
  for (int i = 0; i < count(); ++i) {
    const SharedVertex& shared = shared_[i];
    const VectorXd v = shared.motion(y);
    const VectorXd P = forces(i, SharedVertex::at(shared.vertex, F), v, all_z);
    z_at(i, of_z) = z_missed(i, v, P).cast<float>();
    take(i, P, F);
  }
  return of_z;
}

void SharedRows::add_forces(const VectorXf& z, VectorXf& forces) const {
  for (int i = 0; i < count(); ++i)
    shared_[i].add_forces(forces_of_z(i, z), forces);
}

}  // namespace ffcontact
