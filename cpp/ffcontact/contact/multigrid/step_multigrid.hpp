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
///     v = y_k + v_prescribed + gamma P_k,   P_k = (K u - b)_k in the components of y,
/// so that contact vertices follow what they face, and what their states hold is a mask. A
/// compliant layer gives way by gamma P_k between y and v, gamma = c / A of the node.
struct SurfaceUnknowns {
  VertexFrames<3> frames;
  VectorXi of_row;      ///< k of each row, or -1 where it is held [3 p]
  VectorXd compliance;  ///< gamma, nodal_compliance [3 p]

  /// Calls visit(row, k) for the rows that are not held and their y_k.
  template <class Visit>
  void for_rows(const Visit& visit) const {
    for (int row = 0; row < of_row.size(); ++row)
      if (const int k = of_row[row]; k >= 0) visit(row, k);
  }
};

/// Has every row that is not held an unknown of its own? It has not where nodes share a
/// vertex, where contact vertices follow each other, and where a fixed one faces what moves.
bool has_own_unknowns(const SurfaceTrace& trace);

/// @param trace  with own unknowns
SurfaceUnknowns surface_unknowns(const ContactSurface& surface,
                                 const SurfaceTrace& trace,
                                 const CompliantLayer& layer,
                                 const ElasticSystem& system);

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
  Matrix2d slip_stiffness(const SurfaceEquations& equations, int node) const;
  /// s of a row with a layer.
  double spring(int row) const;
  /// Does the layer have v = 0 by a spring, where a row without one leaves the system?
  bool is_sprung(const SurfaceEquations& equations, int row) const {
    return equations.is_fixed(row) && unknowns_.compliance[row] > 0;
  }

  /// To a residual of so much of |missed|.
  /// @return nothing where GMRES leads nowhere
  std::optional<VectorXd> change(const SurfaceEquations& equations,
                                 const VectorXd& missed, double residual);

 private:
  /// What multigrid was told of a node.
  struct Node {
    Eigen::Matrix<bool, 3, 1> moves{true, true, true};
    Matrix2d slip = Matrix2d::Zero();
    Vector3d layer = Vector3d::Zero();  ///< s, 0 of other rows

    SingleBlock<3, 3> springs() const;
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
