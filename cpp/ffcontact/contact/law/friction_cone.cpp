// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/friction_cone.hpp"

#include <cmath>

#include "ffcontact/base/plane.hpp"
#include "ffcontact/contact/law/bounded_friction.hpp"

namespace ffcontact {

namespace {

/// The end values of a bound along an edge, which is linear between the nodes where it is
/// not given.
Vector2d at_ends(const ContactLine& line, const Matrix2Xd& bound,
                 const VectorXd& nodal, int edge) {
  if (bound.size() > 0) return bound.col(edge);
  return {nodal[line.edge_node(0, edge)], nodal[line.edge_node(1, edge)]};
}

using Bound = Matrix2Xd EdgeRange::*;

void put_limits(const ContactLine& line, const ContactLaw<2>& law, Bound bound,
                int edge, ConesAtEnds& cones) {
  const Vector2d limits =
      at_ends(line, law.limit_between_nodes.*bound, law.shear_limit, edge);
  cones[0].limit = limits[0];
  cones[1].limit = limits[1];
}

/// The cones by the least or the most of what the law has along an edge.
ConesAtEnds cones(const ContactLine& line, const ContactLaw<2>& law,
                  Bound bound, int edge) {
  const VectorXd& coefficient = law.tresca() ? law.slip_bound : law.friction;
  const Vector2d values =
      at_ends(line, law.between_nodes.*bound, coefficient, edge);
  ConesAtEnds result;
  for (int end = 0; end < 2; ++end)
    (law.tresca() ? result[end].cohesion : result[end].friction) = values[end];
  for (FrictionCone& cone : result)
    cone.bonded = law.is_bonded(line.edge_node(0, edge));
  if (law.limited()) put_limits(line, law, bound, edge, result);
  return result;
}

/// The largest value >= 0 on (0, 1) of a quadratic: at an end or where its slope
/// vanishes.
template <class Quadratic>
double largest_value(Quadratic&& f) {
  const double start = f(0.0), middle = f(0.5), end = f(1.0);
  const double ends = std::max({0.0, start, end});
  const double bend = start - 2 * middle + end;
  const double slope =
      -3 * start + 4 * middle - end;  // of 2 bend s^2 + slope s + start
  const bool peak_inside = bend < 0 && slope > 0 && slope < -4 * bend;
  return peak_inside ? std::max(ends, f(-slope / (4 * bend))) : ends;
}

/// The cone at the place s on an edge, without its limit.
FrictionCone cone_at(const ConesAtEnds& ends, double s) {
  FrictionCone cone;
  cone.cohesion = between(ends[0].cohesion, ends[1].cohesion, s);
  cone.friction = between(ends[0].friction, ends[1].friction, s);
  return cone;
}

/// c + mu p at the place s on an edge.
double friction_bound(const ConesAtEnds& cones, const Vector2d& normal,
                      double s) {
  const FrictionCone cone = cone_at(cones, s);
  const double p = std::max(-between(normal[0], normal[1], s), 0.0);
  return cone.cohesion + cone.friction * p;
}

/// Largest |r_t| - c - mu p on an edge.
double excess_of_friction(const ConesAtEnds& cones, const Vector2d& normal,
                          const Vector2d& tangential) {
  const auto excess = [&](int sign) {
    return largest_value([&](double s) {
      return sign * between(tangential[0], tangential[1], s) -
             friction_bound(cones, normal, s);
    });
  };
  return std::max(excess(1), excess(-1));
}

/// Largest |r_t| - k on an edge.
double excess_of_limit(const ConesAtEnds& cones, const Vector2d& tangential) {
  return std::max(std::abs(tangential[0]) - cones[0].limit,
                  std::abs(tangential[1]) - cones[1].limit);
}

/// The conditions of one end, from row `rows` on.
void add_end(const FrictionCone& cone, int end, EdgeCone& edge, Index& rows) {
  if (cone.bonded) return;
  const int n = 2 * end, t = n + 1;
  // For Coulomb's law |r_t| <= m p implies r_n <= 0, but in a thin cone their rounding
  // divided by m is its.
  edge.C(rows++, n) = -1;
  if (edge.frictionless[end]) return;
  for (const int sign : {1, -1}) {
    edge.C(rows, t) = sign;
    edge.C(rows, n) = -cone.friction;
    edge.d[rows++] = -cone.cohesion;
    if (std::isinf(cone.limit)) continue;
    edge.C(rows, t) = sign;
    edge.d[rows++] = -cone.limit;
  }
}

/// One sign's Bernstein coefficients of c + mu p -+ r_t as functions of the end values:
/// their rows, and what is added to these.
struct Bernstein {
  Matrix<double, 3, 4> rows;
  Vector3d constant;
};

Bernstein bernstein(const ConesAtEnds& cones, int sign) {
  const double mi = cones[0].friction, mj = cones[1].friction;
  const double ci = cones[0].cohesion, cj = cones[1].cohesion;
  const double half = 0.5 * sign;
  Bernstein b{{}, {ci, 0.5 * (ci + cj), cj}};
  b.rows << -mi, -sign, 0, 0, -0.5 * mj, -half, -0.5 * mi, -half, 0, 0, -mj,
      -sign;
  return b;
}

/// rho_k of EdgeCone.
double ray(int k) { return k < -EdgeCone::rays ? 0 : std::exp2(0.5 * k); }

/// Weights of b_0, b_1, b_2 in the condition between the rays k and k + 1.
Vector3d chord(int k) {
  const double low = ray(k), high = ray(k + 1);
  if (k == EdgeCone::rays) return {low, 1, 0};  // high is infinite
  return Vector3d(low * high, low + high, 1) / (low + high);
}

/// The conditions between the ends.
void add_between(const ConesAtEnds& cones, EdgeCone& edge, Index& rows) {
  if (cones[0].friction == cones[1].friction) return;
  for (const int sign : {1, -1}) {
    const Bernstein b = bernstein(cones, sign);
    for (int k = -EdgeCone::rays - 1; k <= EdgeCone::rays; ++k) {
      const Vector3d weights = chord(k);
      edge.C.row(rows) = weights.transpose() * b.rows;
      edge.d[rows++] = -weights.dot(b.constant);
    }
  }
}

/// How far the way from an inner point to r goes inside the cone, at most 1.
double part_inside(const EdgeCone& cone, const Vector4d& inner,
                   const Vector4d& r) {
  const VectorXd without = cone.C * inner - cone.d, with = cone.C * r - cone.d;
  double part = 1;
  for (Index row = 0; row < with.size(); ++row)
    if (with[row] < 0)
      part = std::min(part, without[row] / (without[row] - with[row]));
  return part;
}

}  // namespace

ConesAtEnds least_cones(const ContactLine& line, const ContactLaw<2>& law,
                        int edge) {
  ConesAtEnds least = cones(line, law, &EdgeRange::least, edge);
  for (FrictionCone& cone : least)
    cone.friction = bounded_friction(cone.friction);
  return least;
}

ConesAtEnds most_cones(const ContactLine& line, const ContactLaw<2>& law,
                       int edge) {
  return cones(line, law, &EdgeRange::most, edge);
}

EdgeCone edge_cone(const ConesAtEnds& cones) {
  EdgeCone result{{cones[0].frictionless(), cones[1].frictionless()},
                  Matrix<double, Dynamic, 4>::Zero(EdgeCone::most_rows, 4),
                  VectorXd::Zero(EdgeCone::most_rows)};
  Index rows = 0;
  for (int end = 0; end < 2; ++end) add_end(cones[end], end, result, rows);
  add_between(cones, result, rows);
  result.C.conservativeResize(rows, Eigen::NoChange);
  result.d.conservativeResize(rows);
  return result;
}

EdgeCone edge_cone(const ContactLine& line, const ContactLaw<2>& law,
                   int edge) {
  return edge_cone(least_cones(line, law, edge));
}

Vector4d clamped_to_cone(const ContactLine& line, const ContactLaw<2>& law,
                         int edge, const Vector4d& r) {
  const ConesAtEnds cones = least_cones(line, law, edge);
  const Vector2d first = cones[0].clamped(r.head<2>()),
                 second = cones[1].clamped(r.tail<2>());
  const Vector2d normal(first[0], second[0]), tangential(first[1], second[1]);
  const Vector4d clamped = interleaved(normal, tangential);
  if (cones[0].friction == cones[1].friction) return clamped;
  // r_n alone is in the cone, which is convex
  const Vector4d r_n = interleaved(normal, Vector2d::Zero());
  const double part = part_inside(edge_cone(cones), r_n, clamped);
  return interleaved(normal, part * tangential);
}

double cone_defect(const ContactLine& line, const ContactLaw<2>& law,
                   const ContactDensities& densities) {
  const double scale = largest_traction(densities);
  if (scale == 0) return 0;
  double excess = 0;
  for (int e = 0; e < line.edge_count(); ++e) {
    const ConesAtEnds of_law = cones(line, law, &EdgeRange::least, e);
    if (of_law[0].bonded) continue;
    const Vector2d normal = densities.normal.col(e),
                   tangential = densities.tangential.col(e);
    excess = std::max({excess, normal.maxCoeff(),
                       excess_of_limit(of_law, tangential),
                       excess_of_friction(of_law, normal, tangential)});
  }
  return excess / scale;
}

}  // namespace ffcontact
