// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/estimate_outputs.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/plane.hpp"

namespace ffcontact::plugin {

namespace {

/// Of one end of an edge of the refined line.
double abscissa(const ContactProblem<2>& problem,
                const CommonRefinement& refinement, int e, int end) {
  const ContactLine& line = refinement.line;
  const int k = refinement.parent_contact_edge[e];
  const Vector2d ends = problem.edge_abscissa.col(k);
  const int vertex = line.vertex[line.edge_node(end, e)];
  const double place =
      refinement.place(problem.facets, vertex, problem.contact.edge[k]);
  return between(ends[0], ends[1], problem.contact.share(k, place));
}

/// Values at the corners of a triangle as those at its shrunk vertices.
Vector3d shrunk(const Vector3d& corners) {
  constexpr double shrink = 0.01;
  Vector3d values;
  for (int c = 0; c < 3; ++c)
    values[c] = (1 - shrink) * corners[c] + shrink * corners.mean();
  return values;
}

}  // namespace

VectorXd stress_component(const std::vector<SubcellStress<2>>& stress,
                          int component) {
  VectorXd values(9 * count_of(stress));
  Index first = 0;
  for (const SubcellStress<2>& of_triangle : stress)
    for (int k = 0; k < 3; ++k, first += 3) {
      // k+1, k+2, centroid
      const Vector3d corners =
          shrunk(of_triangle.block<1, 3>(component, 3 * k).transpose());
      for (int c = 0; c < 3; ++c) values[first + (k + 1 + c) % 3] = corners[c];
    }
  return values;
}

VectorXd abscissae(const ContactProblem<2>& problem,
                   const Estimate<2>& estimate) {
  if (!estimate.refinement) return problem.edge_abscissa.reshaped();
  return VectorXd::NullaryExpr(
      2 * estimate.refinement->line.edge_count(), [&](int k) {
        return abscissa(problem, *estimate.refinement, k / 2, k % 2);
      });
}

namespace {

void put_parts(Stack stack, const NamedArguments& named,
               const PairError& error) {
  named.put(stack, "elasticpart", error.elastic);
  named.put(stack, "contactpart", error.contact);
  named.put(stack, "springpart", error.springs);
}

}  // namespace

void put_error(Stack stack, const NamedArguments& named,
               const PairError& error) {
  named.put(stack, "e", error.e);
  put_parts(stack, named, error);
  named.put(stack, "tractionoscillation", error.oscillation);
  named.put(stack, "history", packed(error.history));
}

void put_defects(Stack stack, const NamedArguments& named,
                 const PairError& error) {
  named.put(stack, "balance", error.equilibrium.largest());
  named.put(stack, "cone", error.cone);
  named.put(stack, "penetration", error.penetration);
  named.put(stack, "admissible", error.admissible);
}

void report_oscillation(const PairError& error) {
  constexpr double rounding = 1e-12;  // of |sigma_hat + C eps(u_hat)| = e / eps
  if (error.oscillation * error.relative > rounding * error.e)
    cout << "contacterror: bounds hold with e + " << error.oscillation
         << " in place of e, as meshes do not match or directions turn" << endl;
}

void report_parts(const PairError& error) {
  cout << "contacterror: elastic part " << error.elastic
       << ", contact part of e^2 " << error.contact << ", that of springs "
       << error.springs << ", equilibrium defect "
       << error.equilibrium.largest() << ", cone defect " << error.cone
       << ", penetration " << error.penetration << endl;
}

void report_reason(Stack stack, const NamedArguments& named,
                   const PairError& error) {
  if (error.admissible || mpirank != 0) return;
  if (named.verbosity_level(stack) < 1 && named.given("admissible")) return;
  cout << "contacterror: not admissible: e is no bound, as " << error.reason
       << endl;
}

}  // namespace ffcontact::plugin
