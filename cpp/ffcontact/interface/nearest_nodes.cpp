// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/nearest_nodes.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace ffcontact {

namespace {

/// The axis along which places differ most.
Index longest_axis(const MatrixXd& place) {
  Index axis;
  (place.rowwise().maxCoeff() - place.rowwise().minCoeff()).maxCoeff(&axis);
  return axis;
}

/// Old nodes in the order of one coordinate: those far away along it are not looked at.
class OrderedNodes {
 public:
  explicit OrderedNodes(const PlacedNodes& old)
      : old_(old),
        axis_(longest_axis(old.place)),
        order_(static_cast<std::size_t>(old.place.cols())) {
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(),
              [&](int a, int b) { return coordinate(a) < coordinate(b); });
  }

  int nearest(const VectorXd& x, const VectorXd& n, double h) const {
    const auto first =
        std::partition_point(order_.begin(), order_.end(),
                             [&](int k) { return coordinate(k) < x[axis_]; });
    Nearest best;
    const auto is_near = [&](int k) {
      const double along = coordinate(k) - x[axis_];
      if (along * along >= best.square) return false;
      const double square = (old_.place.col(k) - x).squaredNorm() +
                            h * h * (old_.normal.col(k) - n).squaredNorm();
      if (square < best.square) best = {k, square};
      return true;
    };
    for (auto k = first; k != order_.end() && is_near(*k); ++k) continue;
    for (auto k = first; k != order_.begin() && is_near(*(k - 1)); --k)
      continue;
    return best.node;
  }

 private:
  struct Nearest {
    int node = 0;
    double square = std::numeric_limits<double>::infinity();
  };

  double coordinate(int k) const { return old_.place(axis_, k); }

  const PlacedNodes& old_;
  Index axis_;
  std::vector<int> order_;
};

}  // namespace

std::vector<int> nearest_nodes(const PlacedNodes& nodes,
                               const PlacedNodes& old) {
  const OrderedNodes ordered(old);
  std::vector<int> nearest;
  for (Index i = 0; i < nodes.place.cols(); ++i)
    nearest.push_back(ordered.nearest(nodes.place.col(i), nodes.normal.col(i),
                                      nodes.size[i]));
  return nearest;
}

}  // namespace ffcontact
