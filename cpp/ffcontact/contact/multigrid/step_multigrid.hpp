// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/contact/condensed/surface_trace.hpp"
#include "ffcontact/contact/newton/surface_equations.hpp"
#include "ffcontact/elastic/multigrid/body_grid.hpp"
#include "ffcontact/elastic/multigrid/smoothed_aggregation.hpp"
#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// The unknowns of solids in contact, as many as they have free dofs: what u consists of
/// beside prescribed values, of which the rows 3 i + c of the nodes have
///     v = y_k + v_prescribed,   P_k = (K u - b)_k in the components of y,
/// so that contact vertices follow what they face, and what their states hold is a mask.
struct SurfaceUnknowns {
  VertexFrames<3> frames;
  VectorXi of_row;  ///< k of each row, or -1 where it is held [3 p]
};

/// Has every row that is not held an unknown of its own? It has not where nodes share a
/// vertex, where contact vertices follow each other, and where a fixed one faces what moves.
bool has_own_unknowns(const SurfaceTrace& trace);

/// @param trace  with own unknowns
SurfaceUnknowns surface_unknowns(const ContactSurface& surface,
                                 const SurfaceTrace& trace,
                                 const ElasticSystem& system);

/// The linear systems of surface_newton with K for that of y, for the change y of the unknowns:
///     inside, open:  K y = -missed          where v = 0 is the condition:  y = 0
///     slip:          (K y)_t + mu (K y)_n e + w (1 - e e') y_t = -missed,
///                    w = c rho / (|tau_t| - rho),
/// by GMRES. Its preconditioner is multigrid of the symmetric part, that without mu, and
/// follows the states of the nodes.
class StepMultigrid {
 public:
  /// @param unknowns  outlives it
  StepMultigrid(const ElasticSystem& system, const Matrix3Xd& vertices,
                const SurfaceUnknowns& unknowns);

  /// Of K on its diagonal at each row that is not held [3 p].
  double stiffness(int row) const;
  /// The diagonal of K, 0 at unknowns that stand for nothing.
  const VectorXf& diagonal_of_all() const { return diagonal_of_all_; }

  /// w (1 - e e') of a slipping node, 0 of others.
  static Matrix2d slip_stiffness(const SurfaceEquations& equations, int node);

  /// To a residual of so much of |missed|.
  /// @return nothing where GMRES leads nowhere
  std::optional<VectorXd> change(const SurfaceEquations& equations,
                                 const VectorXd& missed, double residual);

 private:
  /// What multigrid was told of a node.
  struct Node {
    Eigen::Matrix<bool, 3, 1> moves{true, true, true};
    Matrix2d slip = Matrix2d::Zero();
  };

  Node node_of(const SurfaceEquations& equations, int node) const;
  /// @param c  of the natural map, beside which small w are nothing
  bool is_stale(int node, const Node& now, double c) const;
  void follow(const SurfaceEquations& equations);
  SmoothedAggregation<3>::Change change_of(int node, const Node& state) const;
  /// What the equations of a node make of rows of K y.
  SingleBlock<3, 1> rows_of(int node, const SurfaceEquations& equations,
                            const SingleBlock<3, 1>& K_y,
                            const SingleBlock<3, 1>& y) const;
  /// Of the true states, which multigrid may have a little behind.
  VectorXf product(const SurfaceEquations& equations, const VectorXf& y) const;
  int node_count() const { return static_cast<int>(vertex_.size()); }

  const SurfaceUnknowns& unknowns_;
  std::vector<int> vertex_;  ///< of each node, -1 where all rows are held
  std::vector<SingleBlock<3, 3>> diagonal_;  ///< of K at it
  VectorXf diagonal_of_all_;
  std::vector<Node> known_;
  SmoothedAggregation<3> multigrid_;
};

}  // namespace ffcontact
