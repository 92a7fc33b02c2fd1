// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/node_motions.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace ffcontact {

namespace {

constexpr double dependent = 1e-3;

/// Parameters about another centre: a' = a + w x r, w' = w.
template <int dim>
auto moved_by(const VectorOf<dim>& r) {
  constexpr int count = motion_count<dim>;
  Matrix<double, count, count> shift = Matrix<double, count, count>::Identity();
  shift.template topRightCorner<dim, count - dim>() = rotations<dim>(r);
  return shift;
}

/// Without unknowns yet.
template <int dim, int size>
NodeMotions<dim, NodeMotions<dim, size>::count> around(
    const std::vector<NodeMotions<dim, size>>& nodes,
    const std::vector<int>& members) {
  NodeMotions<dim, NodeMotions<dim, size>::count> all;
  for (int i : members)
    all.centre += nodes[i].centre / static_cast<double>(members.size());
  for (int i : members)
    all.radius = std::max(
        all.radius, (nodes[i].centre - all.centre).norm() + nodes[i].radius);
  return all;
}

/// What makes rotations as large as translations.
template <int dim, int size>
VectorXd scales(double radius) {
  constexpr int count = NodeMotions<dim, size>::count;
  VectorXd scale = VectorXd::Ones(count);
  if (radius > 0) scale.tail(count - dim).setConstant(1 / radius);
  return scale;
}

template <int dim>
using Wide = Matrix<double, Dynamic, motion_count<dim>>;

/// Motions about a centre, scaled, of all members, with as many rows as columns at least.
template <int dim, int size>
Wide<dim> stacked(const std::vector<NodeMotions<dim, size>>& nodes,
                  const std::vector<int>& members, const VectorOf<dim>& centre,
                  const VectorXd& scale) {
  const auto rows = static_cast<Index>(size * members.size());
  Wide<dim> B = Wide<dim>::Zero(std::max(rows, scale.size()), scale.size());
  for (std::size_t k = 0; k < members.size(); ++k) {
    const NodeMotions<dim, size>& node = nodes[members[k]];
    B.template middleRows<size>(size * k) =
        node.motions.template cast<double>() *
        moved_by<dim>(node.centre - centre) * scale.asDiagonal();
  }
  return B;
}

/// B = Q R of so many columns.
template <int dim>
struct Factors {
  Wide<dim> Q;
  MatrixXd R;
};
template <int dim>
Factors<dim> factors(const Wide<dim>& B) {
  Eigen::ColPivHouseholderQR<Wide<dim>> qr(B);
  qr.setThreshold(dependent);
  const Index rank = qr.rank();
  Factors<dim> result{Wide<dim>::Zero(B.rows(), B.cols()),
                      MatrixXd::Zero(B.cols(), B.cols())};
  result.Q.leftCols(rank) =
      qr.householderQ() * MatrixXd::Identity(B.rows(), rank);
  for (Index row = 0; row < B.rows(); ++row)
    if (B.row(row).isZero(0)) result.Q.row(row).setZero();  // not by rounding
  const MatrixXd upper =
      qr.matrixR().topRows(rank).template triangularView<Eigen::Upper>();
  result.R.topRows(rank) = upper * qr.colsPermutation().transpose();
  return result;
}

}  // namespace

template <int dim, int size>
AggregateBasis<dim, size> aggregate_basis(
    const std::vector<NodeMotions<dim, size>>& nodes,
    const std::vector<int>& members) {
  AggregateBasis<dim, size> basis;
  basis.motions = around(nodes, members);
  const VectorXd scale = scales<dim, size>(basis.motions.radius);
  const auto [Q, R] =
      factors<dim>(stacked(nodes, members, basis.motions.centre, scale));
  basis.motions.motions =
      (R * scale.cwiseInverse().asDiagonal()).template cast<float>();
  for (std::size_t k = 0; k < members.size(); ++k)
    basis.tentative.push_back(
        Q.template middleRows<size>(size * k).template cast<float>());
  return basis;
}

template AggregateBasis<3, 3> aggregate_basis(
    const std::vector<NodeMotions<3, 3>>&, const std::vector<int>&);
template AggregateBasis<3, 6> aggregate_basis(
    const std::vector<NodeMotions<3, 6>>&, const std::vector<int>&);

}  // namespace ffcontact
