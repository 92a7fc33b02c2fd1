// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/contact/multigrid/shared_rows.hpp"
#include "ffcontact/contact/multigrid/surface_unknowns.hpp"
#include "ffcontact/contact/newton/surface_equations.hpp"
#include "ffcontact/elastic/multigrid/body_grid.hpp"
#include "ffcontact/elastic/multigrid/smoothed_aggregation.hpp"

namespace ffcontact {

/// The linear systems of surface_newton with K for that of y, for the change y of the unknowns:
///     inside, open:  K y = -missed          where v = 0 is the condition:  y = 0
///     slip:          (K y)_t + mu (K y)_n e + w (1 - e e') y_t = -missed,
///                    1 / w = (|tau_t| - rho) / (c rho) + gamma,
/// by GMRES. Where v = 0 is the condition on a row with a layer, y + gamma K y = -v makes the
/// layer a spring of the node,
///     (K + s) y = -s v,   s = min(1 / gamma, 1e4 K_kk):
/// one that is much stiffer than the body is taken for softer, and v still tends to 0, by a
/// factor of 1e4 or more a step. The preconditioner is multigrid of the symmetric part, that
/// without mu, and follows the states of the nodes.
///
/// Rows of shared vertices add - E'dP at them and - E_j'dP at what they face, and unknowns z
/// behind y (SharedRows). Multigrid knows the springs that they are to their own y. Of
///     (K, -E'; c E, H) (y, z) = (r, r_z)
/// it is given   z = r_z, y = M (r + E'z):   Schur's complement c E K^-1 E' is about 1.
class StepMultigrid {
 public:
  /// @param unknowns  outlives it
  StepMultigrid(const ElasticSystem& system, const Matrix3Xd& vertices,
                const SurfaceUnknowns& unknowns);

  /// Of K on its diagonal at each row that is not held [3 p].
  double stiffness(int row) const;
  /// Of K at shared vertex i.
  Matrix3d shared_diagonal(int i) const {
    return shared_diagonal_[i].cast<double>();
  }
  /// The diagonal of K, 0 at unknowns that stand for nothing.
  const VectorXf& diagonal_of_all() const { return diagonal_of_all_; }

  /// w (1 - e e') of a slipping node, 0 of others.
  Matrix2d slip_stiffness(const SurfaceEquations& equations, int node) const;
  /// s of a row with a layer.
  double spring(int row) const;
  /// Does the layer have v = 0 by a spring, where a row without one leaves the system?
  bool is_sprung(const SurfaceEquations& equations, int row) const {
    return equations.is_fixed(row) && unknowns_.compliance[row] > 0;
  }

  /// To a residual of so much of |missed|.
  /// @param missed  by y, then by z
  /// @return nothing where GMRES leads nowhere
  std::optional<VectorXd> change(const SurfaceEquations& equations,
                                 const SharedRows& shared,
                                 const VectorXd& missed, double residual);
  /// That GMRES needed so far.
  int products() const { return products_; }

 private:
  /// What multigrid was told of a node.
  struct Node {
    Eigen::Matrix<bool, 3, 1> moves{true, true, true};
    Matrix2d slip = Matrix2d::Zero();
    Vector3d layer = Vector3d::Zero();  ///< s, 0 of other rows

    SingleBlock<3, 3> springs() const;
  };
  /// And of a shared vertex.
  struct Shared {
    Vector3d moves = Vector3d::Ones();
    Matrix3d springs = Matrix3d::Zero();

    bool is_stale(const Shared& now, double c) const;
  };

  Node node_of(const SurfaceEquations& equations, int node) const;
  /// @param c  of the natural map, beside which small w are nothing
  bool is_stale(int node, const Node& now, double c) const;
  using Change = SmoothedAggregation<3>::Change;
  void follow(const SurfaceEquations& equations, const SharedRows& shared);
  void follow_nodes(const SurfaceEquations& equations,
                    std::vector<Change>& changes);
  void follow_shared(const SharedRows& shared, std::vector<Change>& changes);
  Change change_of(const SharedVertex& shared, const Matrix3d& K,
                   const Shared& state) const;
  Change change_of(int node, const Node& state) const;
  /// What the equations of a node make of rows of K y.
  SingleBlock<3, 1> rows_of(int node, const SurfaceEquations& equations,
                            const SingleBlock<3, 1>& K_y,
                            const SingleBlock<3, 1>& y) const;
  /// K y at a vertex with D of K, where multigrid has other blocks on the diagonal.
  SingleBlock<3, 1> at(int vertex, const SingleBlock<3, 3>& D,
                       const VectorXf& y, const VectorXf& product) const;
  /// Of the true states, which multigrid may have a little behind.
  VectorXf product(const SurfaceEquations& equations, const SharedRows& shared,
                   const VectorXf& x) const;
  VectorXf of_nodes(const SurfaceEquations& equations, const VectorXf& y) const;
  VectorXf preconditioned(const SharedRows& shared,
                          const VectorXf& right) const;
  int node_count() const { return static_cast<int>(vertex_.size()); }

  const SurfaceUnknowns& unknowns_;
  std::vector<int> vertex_;  ///< of each node, -1 where all rows are held
  std::vector<SingleBlock<3, 3>> diagonal_;  ///< of K at it
  VectorXf diagonal_of_all_;
  std::vector<Node> known_;
  std::vector<SingleBlock<3, 3>> shared_diagonal_;  ///< of K at them
  std::vector<Shared> known_shared_;
  SmoothedAggregation<3> multigrid_;
  int products_ = 0;
};

}  // namespace ffcontact
