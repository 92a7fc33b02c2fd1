// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <cmath>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ground.hpp"

namespace ffcontact::fuzz {

namespace {

constexpr double rounding = 1e-8;

using Polygon = std::vector<Vector2d>;

double side_of(const Vector2d& a, const Vector2d& b, const Vector2d& x) {
  return (b.x() - a.x()) * (x.y() - a.y()) - (b.y() - a.y()) * (x.x() - a.x());
}

/// What of a convex polygon is on the left of the line from a to b.
Polygon clipped(const Polygon& polygon, const Vector2d& a, const Vector2d& b) {
  Polygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double at_p = side_of(a, b, p), at_q = side_of(a, b, q);
    if (at_p >= 0) result.push_back(p);
    if ((at_p > 0) != (at_q > 0) && at_p != 0 && at_q != 0)
      result.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return result;
}

Polygon common_part(const Corners& a, const Corners& b) {
  Polygon part{a.col(0), a.col(1), a.col(2)};
  for (int k = 0; k < 3 && part.size() > 2; ++k)
    part = clipped(part, b.col(k), b.col((k + 1) % 3));
  return part;
}

/// int d : C^-1 d over the common part of two triangles, d = constant less what is linear
/// on the second.
double square_on(const Corners& fine, const Corners& sub,
                 const Vector3d& constant, const Matrix3d& at_corners,
                 const Matrix3d& compliance) {
  const Polygon part = common_part(fine, sub);
  const auto at = [&](const Vector2d& x) {
    const Vector3d d = constant - at_corners * weights_at(sub, x);
    return d.dot(compliance * d);
  };
  double sum = 0;
  for (std::size_t k = 2; k < part.size(); ++k) {
    Corners piece;
    piece << part[0], part[k - 1], part[k];
    for (int c = 0; c < 3; ++c)
      sum += area_of(piece) / 3 *
             at(0.5 * (piece.col(c) + piece.col((c + 1) % 3)));
  }
  return sum;
}

/// |sigma - sigma_hat|^2 + |u - u_hat|^2, sigma constant on the fine triangles, of which
/// `ratio` cut each coarse one.
double squared_distance(const Assembled& coarse, const Estimate<2>& estimate,
                        const Assembled& fine, const VectorXd& reference,
                        int ratio) {
  double sum = 0;
  for (int t = 0; t < fine.mesh().cell_count(); ++t) {
    const int T = t / ratio;
    const Matrix3d &C = coarse.elasticity[coarse.region[T]],
                   compliance = C.inverse();
    const Corners parent = corners_at(coarse.mesh(), T);
    Corners own;
    for (int k = 0; k < 3; ++k)
      own.col(k) = fine.point_in(coarse, fine.mesh().cells(k, t));
    const Vector3d sigma = stress_of(fine.mesh(), t, C, reference);
    const Vector3d d =
        sigma - stress_of(coarse.mesh(), T, C, estimate.displacement);
    sum += area_of(own) * d.dot(compliance * d);
    for (int k = 0; k < 3; ++k)
      sum += square_on(own, subtriangle(parent, k), sigma,
                       estimate.stress[T].middleCols<3>(3 * k), compliance);
  }
  return sum;
}

/// 2 (sum (M k)_i |w_i| - int k |w|) on the fine line, w linear on each of its edges.
double bound_of_interpolation(const Assembled& fine, const VectorXd& w) {
  const VectorXd& k = fine.law.slip_bound;
  if (k.size() == 0) return 0;
  double sum = (mass_of(fine.mesh(), fine.line) * k).dot(w.cwiseAbs());
  for (int e = 0; e < fine.line.edge_count(); ++e) {
    const int i = fine.line.edge_node(0, e), j = fine.line.edge_node(1, e);
    const auto f = [&](double s) {
      return ((1 - s) * k[i] + s * k[j]) * std::abs((1 - s) * w[i] + s * w[j]);
    };
    const double zero = w[i] * w[j] < 0 ? w[i] / (w[i] - w[j]) : 0;
    sum -= fine.line.length[e] / 6 * zero * (f(0) + 4 * f(zero / 2) + f(zero));
    sum -= fine.line.length[e] / 6 * (1 - zero) *
           (f(zero) + 4 * f((1 + zero) / 2) + f(1));
  }
  return 2 * sum;
}

/// A displacement of the coarse mesh at the vertices of the fine one, of which `ratio`
/// triangles cut each coarse one.
VectorXd on_fine_mesh(const Assembled& coarse, const Assembled& fine,
                      const VectorXd& u, int ratio) {
  const Mesh& mesh = fine.mesh();
  VectorXd result(2 * mesh.vertex_count());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Corners parent = corners_at(coarse.mesh(), t / ratio);
    for (const int v : mesh.cells.col(t)) {
      const Vector3d weight = weights_at(parent, fine.point_in(coarse, v));
      Vector2d sum = Vector2d::Zero();
      for (int k = 0; k < 3; ++k)
        sum += weight[k] * u.segment<2>(2 * coarse.mesh().cells(k, t / ratio));
      result.segment<2>(2 * v) = sum;
    }
  }
  return result;
}

/// 2 sum |r_i| |u_i - u_hat,i| over the free dofs, r = K u - b - contact forces. The
/// reference has stresses in equilibrium with loads that are r off, which is rounding of
/// K u: beside a soft part a stiff one makes it larger than (2.20) is sharp.
double work_of_residual(const Assembled& fine,
                        const ContactSolution<2>& reference,
                        const VectorXd& u_hat) {
  const VectorXd& u = reference.displacement;
  VectorXd r = fine.stiffness * u - fine.load;
  for (int i = 0; i < fine.line.node_count(); ++i)
    r.segment<2>(2 * fine.line.vertex[i]) -=
        reference.force(0, i) * fine.line.normal.col(i) +
        reference.force(1, i) * fine.line.tangent(i);
  double sum = 0;
  for (Index dof = 0; dof < u.size(); ++dof)
    if (!fine.prescribed[dof]) sum += std::abs(r[dof] * (u[dof] - u_hat[dof]));
  return 2 * sum;
}

/// A label that its neighbours' supports hold at all of its vertices is read as a support
/// on the coarse mesh only.
bool reads_the_same(const Case& problem, const Assembled& parts) {
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    const Body& body = problem.bodies[k];
    for (int label : body.mesh.boundary_label)
      for (int c = 0; c < 2; ++c) {
        bool all = true, given = false;
        for (const Support& s : body.supports)
          given = given || (s.label == label && s.component == c);
        for (int e = 0; e < body.mesh.boundary.cols(); ++e)
          for (int v : body.mesh.boundary.col(e))
            if (body.mesh.boundary_label[e] == label)
              all =
                  all &&
                  parts.prescribed[2 * (parts.joined.first_vertex[k] + v) + c];
        if (all && !given) return false;
      }
  }
  return true;
}

VectorXd tangential_of(const Assembled& coarse, const Assembled& fine,
                       const VectorXd& u_hat) {
  const VectorXd w = against_foundation(coarse.line, coarse.law.gap,
                                        coarse.law.previous, u_hat)
                         .row(1);
  VectorXd result(fine.line.node_count());
  for (int i = 0; i < result.size(); ++i)
    result[i] =
        value_on_line(coarse, w, fine.point_in(coarse, fine.line.vertex[i]),
                      fine.line.normal.col(i));
  return result;
}

/// Friction and a gap that are given are none along an edge at the end of a crack, and on
/// the finer mesh these are shorter.
bool holds_elsewhere(const Case& problem) {
  return (problem.law == Law::tresca || problem.has_gap) &&
         problem.bodies.size() == 1 && problem.has_opposites();
}

}  // namespace

Finds bound_finds(const Case& problem, const Assembled& parts,
                  const Estimate<2>& estimate, int times) {
  if (problem.law == Law::coulomb || estimate.refinement ||
      !reads_the_same(problem, parts) || holds_elsewhere(problem))
    return {};
  Refined fine = refined(problem, parts);
  for (int k = 1; k < times; ++k) fine = refined(fine.problem, fine.parts);
  fine.parts.law.multiplier = Multiplier::force;
  const ContactSolution<2> reference =
      solve_contact(fine.parts.mesh(), fine.parts.line, fine.parts.law,
                    elastic_system(fine.parts.A, fine.parts.b));
  if (!reference.accepted({}))
    return {finding("reference", "the finer problem is not solved: ",
                    in_words(reference.status), ", residual ",
                    reference.residual, ", violation ",
                    reference.complementarity)};
  const int ratio = 1 << (2 * times);
  const double distance = squared_distance(parts, estimate, fine.parts,
                                           reference.displacement, ratio);
  const double allowed =
      estimate.e * estimate.e +
      bound_of_interpolation(
          fine.parts, tangential_of(parts, fine.parts, estimate.displacement)) +
      work_of_residual(
          fine.parts, reference,
          on_fine_mesh(parts, fine.parts, estimate.displacement, ratio));
  const double sum =
      estimate.relative > 0 ? std::pow(estimate.e / estimate.relative, 2) : 0;
  const double zero =
      square_called_zero(parts, ground_of(parts, estimate), estimate);
  if (distance <= (1 + rounding) * allowed + 1e-11 * sum + zero) return {};
  return {finding("bound", "the distance is ", std::sqrt(distance), ", e ",
                  estimate.e)};
}

}  // namespace ffcontact::fuzz
