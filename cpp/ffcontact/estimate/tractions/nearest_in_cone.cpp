// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/nearest_in_cone.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "ffcontact/estimate/tractions/damped_newton.hpp"
#include "ffcontact/estimate/tractions/edge_projection.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Resultants are kept to this part of their terms.
constexpr double resultant_tolerance = 1e-13;
/// Where eta is so large that this part of the terms is lost, it has run away.
constexpr double most_rounding = 1e-8;

constexpr int most_steps = 100;

using EdgeProjections = std::vector<EdgeProjection>;

EdgeProjections edge_projections(const ContactLine& line,
                                 const ContactLaw<2>& law,
                                 const MatrixXd& motions,
                                 const std::vector<Carrying>& carrying) {
  EdgeProjections edges;
  for (int e = 0; e < line.edge_count(); ++e)
    edges.emplace_back(line, law, motions, e,
                       carrying.empty() ? Carrying::any : carrying[e]);
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

  Point point_at(const VectorXd& eta) const {
    Point point{eta, densities_, -resultants_};
    for (int e = 0; e < edge_count(); ++e) {
      const Vector4d r = edges_[e](outside(e, eta));
      set_end_values(point.r, e, r);
      point.off += edges_[e].resultants(r);
    }
    return point;
  }

  Point start() const { return point_at(VectorXd::Zero(resultants_.size())); }

  MatrixXd slope(const Point& point) const {
    MatrixXd sum = MatrixXd::Zero(resultants_.size(), resultants_.size());
    for (int e = 0; e < edge_count(); ++e)
      sum += edges_[e].slope(end_values(point.r, e), outside(e, point.eta));
    return sum;
  }

  /// Sum of the sizes of the terms of the resultants.
  double scale() const {
    double sum = max_norm(resultants_);
    for (int e = 0; e < edge_count(); ++e)
      sum +=
          edges_[e].terms_of_resultants(end_values(densities_, e)).maxCoeff();
    return sum;
  }

 private:
  int edge_count() const { return static_cast<int>(edges_.size()); }

  /// What is projected.
  Vector4d outside(int e, const VectorXd& eta) const {
    return edges_[e].moved(end_values(densities_, e), eta);
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

/// Newton's method; nothing if it runs away. Where the dual is all but flat its last steps
/// are long and lose digits: the point that was closest to the resultants.
std::optional<Dual::Point> minimum(const Dual& dual, double length) {
  Dual::Point point = dual.start(), closest = point;
  const double scale = dual.scale();
  DampedNewton newton(dual, length, scale);
  for (int step = 0; step < most_steps; ++step) {
    const double missed = rounding(point, length, scale);
    if (missed > most_rounding * scale) return std::nullopt;
    if (max_norm(point.off) <= missed) return closest;
    point = newton.after(point);
    if (point.off.norm() < closest.off.norm()) closest = point;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ContactDensities> nearest_in_cone(
    const ContactLine& line, const ContactLaw<2>& law,
    const ContactDensities& densities, const MatrixXd& motions,
    const VectorXd& resultants, const std::vector<Carrying>& carrying) {
  const double length = line.length.sum();
  const EdgeProjections edges = edge_projections(line, law, motions, carrying);
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
