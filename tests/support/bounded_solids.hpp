// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>

#include "ffcontact/bounds/quantity_bounds.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "support/quantities.hpp"
#include "support/solid_estimates.hpp"
#include "support/solid_springs.hpp"

/// Solids whose quantities are bounded.
namespace ffcontact::test {

using Chosen = std::function<bool(const Vector3d& centroid)>;

/// int p . v + M : C eps(v) over cells that are chosen.
inline Quantity<3> in_cells(const SolidMesh& mesh, const HookeTensors<3>& hooke,
                            const Vector3d& p, const VectorOf<6>& M,
                            const Chosen& chosen) {
  Quantity<3> quantity = no_quantity<3>(mesh);
  CellStresses<3> q = CellStresses<3>::Zero(6, mesh.cells.cols());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    if (!chosen(centroid_of(mesh, t))) continue;
    quantity.body_loads.col(t) =
        (signed_volume(mesh, t) / 4 * p).replicate<4, 1>();
    q.col(t) = hooke[t] * M;
  }
  quantity.stress = LinearStresses<3>(q);
  return quantity;
}

/// A problem as contactsolve leaves it.
struct SolidWithAnswer {
  SolidProblem problem;
  Topology<3> topology = topology_of(problem.mesh);
  ElasticSystem system = problem.system();
  SolvedBody<3> body = solved_solid(problem, problem.solve());

  explicit SolidWithAnswer(SolidProblem any,
                           const BoundarySprings<3>& springs = {})
      : problem(std::move(any)) {
    body.springs = springs;
  }

  /// l(u_h)
  double value(const Quantity<3>& quantity) const {
    return load_of(problem.mesh, quantity).dot(body.displacement) +
           quantity.constant;
  }
  SolvedProblem<3> as_problem() const {
    return {topology, problem.surface, system, body};
  }
  QuantityBounds bounds(const Quantity<3>& quantity,
                        const BoundSettings& settings = {}) const {
    return quantity_bounds<3>(
        as_problem(),
        estimate_error<3>(topology, problem.surface, system, body), quantity,
        settings);
  }
};

inline VectorXd on_all_nodes(const SolidProblem& problem, double value) {
  return VectorXd::Constant(problem.surface.node_count(), value);
}

}  // namespace ffcontact::test
