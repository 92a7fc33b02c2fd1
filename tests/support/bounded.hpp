// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ffcontact/bounds/quantity_bounds.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "support/estimates.hpp"
#include "support/quantities.hpp"
#include "support/random.hpp"

/// Plane problems whose quantities are bounded.
namespace ffcontact::test {

/// A problem as contactsolve leaves it.
struct Solved {
  Problem problem;
  Topology<2> topology = topology_of(problem.mesh);
  ElasticSystem system = problem.system();
  SolvedBody<2> body = solved_body(
      problem, solve_contact(problem.mesh, problem.line, problem.law, system));

  explicit Solved(Problem any, const BoundarySprings<2>& springs = {})
      : problem(std::move(any)) {
    body.springs = springs;
  }

  SolvedProblem<2> as_problem() const {
    return {topology, problem.line, system, body};
  }
  Estimate<2> estimate(const EstimateSettings<2>& settings = {}) const {
    return estimate_error<2>(topology, problem.line, system, body, settings);
  }
  /// l(u_h)
  double value(const Quantity<2>& quantity) const {
    return load_of(problem.mesh, quantity).dot(body.displacement) +
           quantity.constant;
  }
  QuantityBounds bounds(const Quantity<2>& quantity,
                        const BoundSettings& settings = {}) const {
    return quantity_bounds<2>(as_problem(),
                              estimate(settings_of_first<2>(settings)),
                              quantity, settings);
  }
};

/// int M : sigma(v) of the cells that are chosen.
inline Quantity<2> stress_of(const Problem& problem, const Vector3d& M,
                             const std::function<bool(int)>& chosen) {
  Quantity<2> quantity = no_quantity<2>(problem.mesh);
  CellStresses<2> q = CellStresses<2>::Zero(3, problem.mesh.cells.cols());
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    if (chosen(t)) q.col(t) = problem.hooke[t] * M;
  quantity.stress = LinearStresses<2>(q);
  return quantity;
}

/// A quantity of a random kind on a mesh and on those that are subdivided from it.
class RandomQuantity {
 public:
  explicit RandomQuantity(const Mesh& mesh, Random& random)
      : kind_(random() % 4), w_(random_vector(2, random)) {
    M_ = random_vector(3, random);
    for (int t = 0; t < mesh.cell_count(); ++t)
      chosen_.push_back(random() % 3 == 0);
  }

  Quantity<2> on(const Problem& problem) const {
    if (kind_ == 0) return on_label<2>(problem.mesh, left, w_);
    if (kind_ == 1) return on_label<2>(problem.mesh, bottom, w_);
    const int children =
        problem.mesh.cell_count() / static_cast<int>(chosen_.size());
    const auto chosen = [&](int t) { return chosen_[t / children]; };
    if (kind_ == 2) return stress_of(problem, M_, chosen);
    Quantity<2> quantity = no_quantity<2>(problem.mesh);
    for (int t = 0; t < problem.mesh.cell_count(); ++t)
      if (chosen(t))
        quantity.body_loads.col(t) =
            (signed_area(problem.mesh, t) / 3 * w_).replicate<3, 1>();
    return quantity;
  }

 private:
  unsigned kind_;
  Vector2d w_;
  Vector3d M_;
  std::vector<bool> chosen_;
};

/// a + b x at the contact nodes.
inline VectorXd linear_along(const Problem& problem, const Vector2d& a_b) {
  const Eigen::RowVectorXd x =
      problem.mesh.vertices.row(0)(problem.line.vertex);
  return (a_b[0] + a_b[1] * x.array()).transpose();
}

/// @param gap, previous  as for linear_along
inline Problem with_law(Problem problem, double slip_bound, const Vector2d& gap,
                        const Vector2d& previous) {
  if (slip_bound > 0)
    problem.law.slip_bound = everywhere(problem.line, slip_bound);
  problem.law.gap = linear_along(problem, gap);
  problem.law.previous = linear_along(problem, previous);
  return problem;
}

/// Some random quantities are of vertices that all are prescribed.
inline bool moves(const QuantityBounds& bounds) {
  return bounds.reason.find("no free vertex of the mesh moves it") ==
         std::string::npos;
}

}  // namespace ffcontact::test
