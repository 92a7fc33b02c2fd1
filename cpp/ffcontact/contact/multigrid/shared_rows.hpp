// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/condensed/contact_rows.hpp"
#include "ffcontact/contact/multigrid/shared_response.hpp"
#include "ffcontact/linear/single.hpp"

namespace ffcontact {

/// The rows of shared vertices in a step of surface_newton, as StepConditions has those of
/// other vertices. With the forces F = K u - b on y,
///     P = of_force F + of_v (E y + sum_j E_j y_j) + of_z z + given
/// by the states (SharedResponse). The y of a vertex lack F - E'P, those of vertices that it
/// faces F_j - E_j'P, and z, unknown beside y, what its own equations lack.
class SharedRows {
 public:
  /// @param shared  outlives it
  explicit SharedRows(const std::vector<SharedVertex>& shared);

  int count() const { return static_cast<int>(shared_.size()); }
  const SharedVertex& vertex(int i) const { return shared_[i]; }

  /// @param v_prescribed  of all rows, less gamma P0 of a layer that carries P0
  void put(const VectorXd& v_prescribed) { v_prescribed_ = v_prescribed; }
  /// @param P  the last ones of all rows
  void put(const SurfaceEquations& equations, const VectorXd& P);

  /// 1 for the y that move, 0 for those that are held.
  const Vector3d& moves(int i) const { return states_[i].moves; }
  /// The symmetric matrix of the springs that rows are to y, what P_n makes of P_t apart.
  const Matrix3d& springs(int i) const { return states_[i].springs; }

  /// y for v and P of the rows, z for P.
  void put_own(const VectorXd& v, const VectorXd& P, VectorXd& y) const;
  VectorXd z_of(const VectorXd& P) const;
  /// v = 0 where that holds y.
  void fix(VectorXd& y) const;
  /// y of a vertex that lacks nothing if no other y changes, so that what is missed is no
  /// larger than the forces of the others' change.
  /// @param D  of K at it
  void relax(int i, const Matrix3d& D, const VectorXd& F, const VectorXd& z,
             VectorXd& y) const;

  /// P of all shared rows.
  /// @return what z lack
  VectorXd put_forces(const VectorXd& y, const VectorXd& z, const VectorXd& F,
                      VectorXd& P) const;
  /// From F to what P leaves of it.
  void take(const VectorXd& P, VectorXd& F) const;
  /// v of all shared rows.
  void put_motion(const VectorXd& y, const VectorXd& P, VectorXd& v) const;

  /// What a change of y and z changes, from that of F to that of what is missed.
  /// @return of what z lack
  VectorXf change(const VectorXf& y, const VectorXf& z, VectorXf& F) const;
  /// Adds what z are to y.
  void add_forces(const VectorXf& z, VectorXf& forces) const;

 private:
  struct State {
    SharedResponse response;
    Vector3d moves = Vector3d::Ones();
    Matrix3d springs = Matrix3d::Zero();
  };

  State state(const SharedVertex& shared, const SurfaceEquations& equations,
              const VectorXd& P) const;
  template <class Vector>
  auto z_at(int i, Vector& z) const {
    return z.segment(first_[i], shared_[i].coupling);
  }
  /// Without what is given.
  VectorXd forces(int i, const Vector3d& F, const VectorXd& v,
                  const VectorXd& z) const;
  VectorXd z_missed(int i, const VectorXd& v, const VectorXd& P) const;
  /// Of all rows those of a vertex.
  VectorXd own(int i, const VectorXd& rows) const {
    return rows(shared_[i].rows);
  }
  /// z of a vertex as forces of its rows.
  template <class Vector>
  VectorXd forces_of_z(int i, const Vector& z) const {
    return states_[i].response.of_z * z_at(i, z).template cast<double>();
  }
  /// Of what is left at a vertex by its y.
  Matrix3d derivative(int i, const Matrix3d& D) const;
  /// From F to what is left at a vertex and at what it faces.
  template <class Vector>
  void take(int i, const VectorXd& P, Vector& F) const;

  const std::vector<SharedVertex>& shared_;
  std::vector<int> first_;  ///< z of each, and their count
  VectorXd v_prescribed_;
  std::vector<State> states_;
};

}  // namespace ffcontact
