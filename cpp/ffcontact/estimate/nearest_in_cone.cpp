// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/nearest_in_cone.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <vector>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/base/quadratic_minimum.hpp"
#include "ffcontact/equilibrium/boundary_tractions.hpp"

namespace ffcontact {

namespace {

/// Resultants are kept to this part of their terms.
constexpr double resultant_tolerance = 1e-13;

/// Conditions that are met with equality to this part of the tractions hold the
/// projection.
constexpr double tight = 1e-11;

constexpr int most_steps = 100;

/// [z] at a node, one column per motion.
Matrix2Xd jumps_at(const ContactLine& line, const MatrixXd& motions, int node) {
  Matrix2Xd jumps = motions.middleRows<2>(2 * line.vertex[node]);
  visit_opposite(line, node, [&](int vertex, double weight) {
    jumps -= weight * motions.middleRows<2>(2 * vertex);
  });
  return jumps;
}

using EndValues = Matrix<double, 4, Dynamic>;

/// Its components (n, t) at both ends of an edge.
EndValues motions_on_edge(const ContactLine& line, const MatrixXd& motions,
                          int e) {
  EndValues values(4, motions.cols());
  for (int end = 0; end < 2; ++end)
    values.middleRows<2>(2 * end) =
        edge_frame(line, e) * jumps_at(line, motions, line.edge_node(end, e));
  return values;
}

/// int a . b over an edge for end values a and b: a' mass b.
Matrix4d mass_of(const ContactLine& line, int e) {
  Matrix4d mass = 2 * Matrix4d::Identity();
  mass.topRightCorner<2, 2>().setIdentity();
  mass.bottomLeftCorner<2, 2>().setIdentity();
  return line.length[e] / 6 * mass;
}

/// Basis of the end values that friction leaves free.
MatrixXd free_end_values(const EdgeCone& cone) {
  MatrixXd basis = MatrixXd::Zero(4, 4 - cone.frictionless.count());
  for (int k = 0, column = 0; k < 4; ++k)
    if (k % 2 == 0 || !cone.frictionless[k / 2]) basis(k, column++) = 1;
  return basis;
}

/// The projection Pi_C on the cone of one edge, in L2 of the edge.
class EdgeProjection {
 public:
  EdgeProjection(const ContactLine& line, const ContactLaw& law,
                 const MatrixXd& motions, int e)
      : line_(line),
        law_(law),
        edge_(e),
        cone_(edge_cone(line, law, e)),
        mass_(mass_of(line, e)),
        motions_(motions_on_edge(line, motions, e)),
        basis_(free_end_values(cone_)),
        free_mass_(basis_.transpose() * mass_ * basis_),
        half_(free_mass_.llt().matrixL()) {}

  Vector4d operator()(const Vector4d& r) const {
    const auto y = quadratic_minimum(
        free_mass_, -basis_.transpose() * mass_ * r, cone_.C * basis_, cone_.d);
    return y ? clamped_to_cone(line_, law_, edge_, basis_ * *y)
             : Vector4d::Zero();
  }

  /// r_0 + sum eta_k [z_k].
  Vector4d moved(const Vector4d& r, const VectorXd& eta) const {
    return r + motions_ * eta;
  }

  VectorXd resultants(const Vector4d& r) const {
    return motions_.transpose() * (mass_ * r);
  }

  VectorXd terms_of_resultants(const Vector4d& r) const {
    return motions_.cwiseAbs().transpose() * (mass_ * r.cwiseAbs());
  }

  /// d resultants / d eta where r is the projection of `outside`.
  MatrixXd slope(const Vector4d& r, const Vector4d& outside) const {
    return moving().transpose() * moving_on_face(held(r, outside));
  }

 private:
  /// The motions in the coordinates y = half' x of the free end values x [b x k].
  MatrixXd moving() const {
    return lower().solve(basis_.transpose() * mass_ * motions_);
  }

  /// The conditions that are tight at r. Where r is the apex of the cone it is rounding,
  /// small against `outside` only.
  std::vector<int> held(const Vector4d& r, const Vector4d& outside) const {
    const double scale =
        outside.cwiseAbs().maxCoeff() + cone_.d.cwiseAbs().maxCoeff();
    std::vector<int> held;
    for (int row = 0; row < cone_.d.size(); ++row)
      if (cone_.C.row(row).dot(r) - cone_.d[row] <= tight * scale)
        held.push_back(row);
    return held;
  }

  /// What is left of the motions where some conditions stay tight.
  MatrixXd moving_on_face(const std::vector<int>& held) const {
    const MatrixXd all = moving();
    if (held.empty()) return all;
    const MatrixXd normals =
        lower().solve((cone_.C(held, Eigen::all) * basis_).transpose());
    return all - normals * least_squares_of_columns(normals, all);
  }

  Eigen::TriangularView<const MatrixXd, Eigen::Lower> lower() const {
    return half_.triangularView<Eigen::Lower>();
  }

  const ContactLine& line_;
  const ContactLaw& law_;
  int edge_;
  EdgeCone cone_;
  Matrix4d mass_;
  EndValues motions_;
  MatrixXd basis_;      ///< free_end_values
  MatrixXd free_mass_;  ///< the mass on them
  MatrixXd half_;       ///< its Cholesky factor
};

using EdgeProjections = std::vector<EdgeProjection>;

EdgeProjections edge_projections(const ContactLine& line, const ContactLaw& law,
                                 const MatrixXd& motions) {
  EdgeProjections edges;
  for (int e = 0; e < line.edge_count(); ++e)
    edges.emplace_back(line, law, motions, e);
  return edges;
}

/// The dual problem.
class Dual {
 public:
  Dual(const EdgeProjections& edges, const ContactDensities& densities,
       const VectorXd& resultants)
      : edges_(edges), densities_(densities), resultants_(resultants) {}

  struct Point {
    VectorXd eta;
    ContactDensities r;
    VectorXd off;  ///< gradient: the resultants of r less the wanted ones
  };

  Point at(const VectorXd& eta) const {
    Point point{eta, densities_, -resultants_};
    for (int e = 0; e < edge_count(); ++e) {
      const Vector4d r = edges_[e](outside(e, eta));
      set_end_values(point.r, e, r);
      point.off += edges_[e].resultants(r);
    }
    return point;
  }

  Point start() const { return at(VectorXd::Zero(resultants_.size())); }

  MatrixXd slope(const Point& point) const {
    MatrixXd sum = MatrixXd::Zero(resultants_.size(), resultants_.size());
    for (int e = 0; e < edge_count(); ++e)
      sum += edges_[e].slope(end_values(point.r, e), outside(e, point.eta));
    return sum;
  }

  /// Sum of the sizes of the terms of the resultants.
  double scale() const {
    double sum = resultants_.cwiseAbs().maxCoeff();
    for (int e = 0; e < edge_count(); ++e)
      sum +=
          edges_[e].terms_of_resultants(end_values(densities_, e)).maxCoeff();
    return sum;
  }

  /// The point to which a step leads that is shortened until the gradient along it has
  /// changed its sign by little or itself has halved, or lengthened as long as that
  /// leaves more than half of the gradient along it: the dual is nearly flat where few
  /// tractions in the cone have the resultants.
  Point moved(const Point& from, const VectorXd& step) const {
    double length = 1;
    Point next = at(from.eta + step);
    while (too_far(next, from, step) && length > 1e-10) {
      length /= 2;
      next = at(from.eta + length * step);
    }
    return length < 1 ? next : lengthened(std::move(next), from, step);
  }

 private:
  int edge_count() const { return static_cast<int>(edges_.size()); }

  /// What is projected.
  Vector4d outside(int e, const VectorXd& eta) const {
    return edges_[e].moved(end_values(densities_, e), eta);
  }

  static bool half_way(const Point& next, const Point& from,
                       const VectorXd& step) {
    return next.off.dot(step) > 0.5 * from.off.dot(step);
  }

  static bool too_far(const Point& next, const Point& from,
                      const VectorXd& step) {
    return next.off.dot(step) > -0.1 * from.off.dot(step) &&
           next.off.norm() > 0.5 * from.off.norm();
  }

  Point lengthened(Point next, const Point& from, const VectorXd& step) const {
    for (double length = 4; !half_way(next, from, step) && length < 1e8;
         length *= 4) {
      Point farther = at(from.eta + length * step);
      if (too_far(farther, from, step)) break;
      next = std::move(farther);
    }
    return next;
  }

  const EdgeProjections& edges_;
  const ContactDensities& densities_;
  const VectorXd& resultants_;
};

/// What a gradient has at least: of the terms of the resultants, and of eta.
double rounding(const Dual::Point& point, double length, double scale) {
  const double of_eta =
      std::numeric_limits<double>::epsilon() * length * point.eta.norm();
  return std::max(resultant_tolerance * scale, 2 * of_eta);
}

/// Regularised by what is left to do: no step is longer than the tractions, and the last
/// ones are Newton's. [z] is of size 1: `length` is what the slope is where nothing is
/// held.
VectorXd newton_step(const Dual& dual, const Dual::Point& point, double length,
                     double scale) {
  const Index k = point.eta.size();
  const double regular = length * point.off.cwiseAbs().maxCoeff() / scale;
  const MatrixXd slope = dual.slope(point) + regular * MatrixXd::Identity(k, k);
  return -slope.ldlt().solve(point.off);
}

/// Newton's method; nothing if it runs away. Where the dual is all but flat its last steps
/// are long and lose digits: the point that was closest to the resultants.
std::optional<Dual::Point> minimum(const Dual& dual, double length) {
  Dual::Point point = dual.start(), closest = point;
  const double scale = dual.scale();
  for (int step = 0; step < most_steps; ++step) {
    if (point.off.cwiseAbs().maxCoeff() <= rounding(point, length, scale))
      return closest;
    point = dual.moved(point, newton_step(dual, point, length, scale));
    if (point.off.norm() < closest.off.norm()) closest = point;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ContactDensities> nearest_in_cone(
    const ContactLine& line, const ContactLaw& law,
    const ContactDensities& densities, const MatrixXd& motions,
    const VectorXd& resultants) {
  const double length = line.length.sum();
  const EdgeProjections edges = edge_projections(line, law, motions);
  const Dual dual(edges, densities, resultants);
  if (motions.cols() == 0) return dual.start().r;
  const auto nearest = minimum(dual, length);
  if (!nearest) return std::nullopt;
  // Where eta is large the resultants have its rounding, from r itself they have not.
  const auto closer = minimum(Dual(edges, nearest->r, resultants), length);
  return closer && closer->off.norm() < nearest->off.norm() ? closer->r
                                                            : nearest->r;
}

VectorXd resultants_of(const ContactLine& line,
                       const ContactDensities& densities,
                       const MatrixXd& motions) {
  VectorXd sum = VectorXd::Zero(motions.cols());
  for (int e = 0; e < line.edge_count(); ++e)
    sum += motions_on_edge(line, motions, e).transpose() *
           (mass_of(line, e) * end_values(densities, e));
  return sum;
}

}  // namespace ffcontact
