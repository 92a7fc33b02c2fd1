// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "ffcontact/base/eigen.hpp"
#include "ground.hpp"

namespace ffcontact::fuzz {

namespace {

/// Resultants that are met to this part of their size are met.
constexpr double met = 1e-7;

/// Rigid motions of each body alone that prescribed dofs leave free, of size 1 [dofs x
/// k].
Dense free_motions(const Assembled& parts) {
  const Mesh& mesh = parts.mesh();
  const std::vector<int>& first = parts.joined.first_vertex;
  std::vector<VectorXd> motions;
  for (std::size_t body = 0; body + 1 < first.size(); ++body) {
    const int begin = first[body], count = first[body + 1] - begin;
    const Vector2d centre =
        mesh.vertices.middleCols(begin, count).rowwise().mean();
    const double size =
        (mesh.vertices.middleCols(begin, count).colwise() - centre)
            .cwiseAbs()
            .maxCoeff();
    Dense rigid = Dense::Zero(2 * count, 3),
          stopped = Dense::Zero(2 * count, 3);
    for (int v = 0; v < count; ++v) {
      const Vector2d arm = (mesh.vertices.col(begin + v) - centre) / size;
      rigid.middleRows<2>(2 * v) << 1, 0, -arm.y(), 0, 1, arm.x();
      for (int c = 0; c < 2; ++c)
        if (parts.prescribed[2 * (begin + v) + c])
          stopped.row(2 * v + c) = rigid.row(2 * v + c);
    }
    Eigen::ColPivHouseholderQR<Dense> qr(stopped.transpose() * stopped);
    qr.setThreshold(1e-9);
    const Dense kernel = Dense(qr.matrixQ()).rightCols(3 - qr.rank());
    for (Index k = 0; k < kernel.cols(); ++k) {
      VectorXd motion = VectorXd::Zero(parts.load.size());
      motion.segment(2 * begin, 2 * count) = rigid * kernel.col(k);
      motions.push_back(motion);
    }
  }
  Dense result(parts.load.size(), static_cast<Index>(motions.size()));
  for (std::size_t k = 0; k < motions.size(); ++k)
    result.col(static_cast<Index>(k)) = motions[k];
  return result;
}

/// And those of a tool, which contact pushes as it is pushed.
Dense with_tool_motions(const Dense& motions, const Assembled& parts) {
  if (!parts.tool) return motions;
  const Index free = parts.tool->free.cols();
  Dense all(parts.load.size(), motions.cols() + free);
  all.leftCols(motions.cols()) = motions;
  const double length = parts.line.length.sum();
  for (int v = 0; v < parts.mesh().vertex_count(); ++v) {
    const Vector2d arm =
        (parts.mesh().vertices.col(v) - parts.tool->about) / length;
    Dense rigid(2, 3);
    rigid << 1, 0, -arm.y(), 0, 1, arm.x();
    all.rightCols(free).middleRows<2>(2 * v) = rigid.leftCols(free);
  }
  return all;
}

/// Distance of a vector to the cone of the columns, by active sets: Lawson and Hanson,
/// Solving Least Squares Problems, 1974.
double distance_to_cone(const Dense& columns, const VectorXd& wanted) {
  const Index n = columns.cols();
  VectorXd x = VectorXd::Zero(n);
  std::vector<int> used;
  const auto least = [&] {
    const Dense part = columns(Eigen::all, used);
    return VectorXd(part.colPivHouseholderQr().solve(wanted));
  };
  for (Index round = 0; round < 10 * n; ++round) {
    const VectorXd slope = columns.transpose() * (wanted - columns * x);
    Index best = -1;
    for (Index j = 0; j < n; ++j)
      if (std::find(used.begin(), used.end(), j) == used.end() &&
          (best < 0 || slope[j] > slope[best]))
        best = j;
    if (best < 0 || slope[best] <= 1e-14 * wanted.norm()) break;
    used.push_back(static_cast<int>(best));
    while (!used.empty()) {
      const VectorXd y = least();
      double step = 1;
      for (std::size_t k = 0; k < used.size(); ++k)
        if (y[k] <= 0) step = std::min(step, x[used[k]] / (x[used[k]] - y[k]));
      std::vector<int> kept;
      for (std::size_t k = 0; k < used.size(); ++k) {
        x[used[k]] += step * (y[k] - x[used[k]]);
        if (step == 1 || x[used[k]] > 1e-15 * x.maxCoeff())
          kept.push_back(used[k]);
        else
          x[used[k]] = 0;
      }
      used = kept;
      if (step == 1) break;
    }
  }
  return (wanted - columns * x).norm();
}

/// Places on each edge, denser towards its ends.
std::vector<double> places(int steps) {
  std::vector<double> result;
  for (int k = 0; k <= steps; ++k)
    result.push_back(std::pow(std::sin(k * std::acos(-1.) / (2 * steps)), 2));
  return result;
}

/// Work of the end values (r_n,i, r_t,i, r_n,j, r_t,j) of each contact edge along the
/// motions [motions x 4 edges], for edges of length 1: a factor on the density of an edge
/// is one on its forces.
Dense work_of_densities(const Assembled& parts, const Dense& motions) {
  const ContactLine& line = parts.line;
  Dense work(motions.cols(), 4 * line.edge_count());
  for (Index k = 0; k < motions.cols(); ++k) {
    const Matrix2Xd z = against_foundation(line, {}, {}, motions.col(k));
    for (int e = 0; e < line.edge_count(); ++e)
      for (int end = 0; end < 2; ++end)
        work.row(k).segment<2>(4 * e + 2 * end) =
            (2 * z.col(line.edge_node(end, e)) +
             z.col(line.edge_node(1 - end, e)))
                .transpose() /
            6;
  }
  return work;
}

/// coefficients x + given >= 0
struct Conditions {
  Dense coefficients;
  VectorXd given;
};

/// -r_n >= 0 and -mu r_n +- r_t >= 0, or Tresca's bound +- r_t >= 0, at some places of each edge: what the cone asks for
/// there; and the slope of the latter at ends without friction, where it vanishes
/// [conditions x 4 edges].
Conditions cone_conditions(const Assembled& parts, int steps) {
  const ContactLine& line = parts.line;
  const std::vector<double> all = places(steps);
  const auto rows = static_cast<Index>(3 * all.size() + 4);
  Dense conditions =
      Dense::Zero(rows * line.edge_count(), 4 * line.edge_count());
  VectorXd given = VectorXd::Zero(conditions.rows());
  const VectorXd& bound = parts.law.slip_bound;
  Index row = 0;
  for (int e = 0; e < line.edge_count(); ++e) {
    const double mu[2] = {parts.law.friction[line.edge_node(0, e)],
                          parts.law.friction[line.edge_node(1, e)]};
    const auto condition = [&](int end) {
      return conditions.row(row).segment<2>(4 * e + 2 * end);
    };
    for (const double s : all)
      for (int sign : {-1, 0, 1}) {
        const double hat[2] = {1 - s, s};
        const bool is_tresca = sign != 0 && bound.size() > 0;
        const double factor = sign == 0   ? 1
                              : is_tresca ? 0
                                          : hat[0] * mu[0] + hat[1] * mu[1];
        for (int end = 0; is_tresca && end < 2; ++end)
          given[row] +=
              hat[end] * bound[line.edge_node(end, e)] * line.length[e];
        for (int end = 0; end < 2; ++end)
          condition(end) << -factor * hat[end], sign * hat[end];
        ++row;
      }
    for (int end = 0; end < 2; ++end)
      for (int sign : {-1, 1}) {
        if (mu[end] > 0 || bound.size() > 0) continue;
        condition(end) << -mu[1 - end], sign;
        condition(1 - end) << 0, sign;
        ++row;
      }
  }
  return {conditions.topRows(row), given.head(row)};
}

/// How far resultants are from those of densities that are in the cone at some places.
/// work p - work q = resultants and conditions (p - q) = slack with p, q, slack >= 0.
double distance_to_densities(const Dense& work, const Conditions& conditions,
                             const VectorXd& resultants) {
  const Dense& of_values = conditions.coefficients;
  const Index m = work.rows(), n = of_values.rows(), d = work.cols();
  Dense columns = Dense::Zero(m + n, 2 * d + n);
  columns << work, -work, Dense::Zero(m, n), of_values, -of_values,
      -Dense::Identity(n, n);
  VectorXd wanted = VectorXd::Zero(m + n);
  wanted << resultants, -conditions.given;
  wanted /= resultants.norm();
  return distance_to_cone(columns, wanted);
}

}  // namespace

bool no_density_holds(const Assembled& parts,
                      const ContactSolution<2>& solution) {
  const Dense motions = with_tool_motions(free_motions(parts), parts);
  if (motions.cols() == 0) return false;
  VectorXd resultants(motions.cols());
  for (Index k = 0; k < motions.cols(); ++k)
    resultants[k] = against_foundation(parts.line, {}, {}, motions.col(k))
                        .cwiseProduct(solution.force)
                        .sum();
  const Dense work = work_of_densities(parts, motions);
  for (const int steps :
       {4, 32})  // few places are enough where they rule it out
    if (distance_to_densities(work, cone_conditions(parts, steps), resultants) >
        met)
      return true;
  return false;
}

}  // namespace ffcontact::fuzz
