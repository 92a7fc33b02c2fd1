// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
//
#include "estimate/contact_error.hpp"
#include "estimate/estimate_outputs.hpp"
#include "estimate/linear_tractions.hpp"
#include "freefem/stopwatch.hpp"
#include "problem/coulomb.hpp"

/// The body of contact_error.
namespace ffcontact::plugin {

/// B with Coulomb's law, and what it rests on.
struct CoulombBound {
  CoulombConstant constant;
  double missed;  ///< delta of solids
  double value;   ///< infinite for a pair that is not admissible
};

/// What differs between plane bodies and solids.
template <int d>
struct ErrorOf {
  /// But for the relaxation.
  /// @throws std::invalid_argument  if the call has what is for bodies of the other dimension,
  ///                                or for bodies that are not bonded
  static EstimateSettings<d> settings(Stack stack, const NamedArguments& named,
                                      const ContactLaw<d>& law);
  /// Tractions, stresses and rates.
  static void put(Stack stack, const NamedArguments& named,
                  const ContactProblem<d>& problem, const Topology<d>& topology,
                  const Judged<d>& judged, const Estimate<d>& estimate);
  static CoulombBound bound(const ContactProblem<d>& problem,
                            const Topology<d>& topology,
                            const Judged<d>& judged,
                            const Estimate<d>& estimate, StuckNodes stuck);
  /// Cells, and what was done, in words.
  static void report(const Estimate<d>& estimate, double seconds);
};

template <int d>
RelaxationSettings relaxation_of(Stack stack, const NamedArguments& named) {
  constexpr long most_sweeps = 20;  // where a tightness is given alone
  RelaxationSettings settings;
  settings.tightness = named.number(stack, "tightness", settings.tightness);
  if (!named.given("sweeps") && settings.tightness == 0) return settings;
  const long wanted = named.integer(stack, "sweeps", most_sweeps);
  if (wanted < 0) refuse("sweeps must not be negative, got ", wanted);
  settings.steps = steps_of_a_sweep<d> * static_cast<int>(wanted);
  return settings;
}

template <int d>
std::optional<CoulombBound> put_bound(Stack stack, const NamedArguments& named,
                                      const ContactProblem<d>& problem,
                                      const Topology<d>& topology,
                                      const Judged<d>& judged,
                                      const Estimate<d>& estimate,
                                      StuckNodes stuck) {
  if (!wants_bound(named)) return std::nullopt;
  const CoulombBound bound =
      ErrorOf<d>::bound(problem, topology, judged, estimate, stuck);
  named.put(stack, "coulomb", bound.constant.kappa);
  named.put(stack, "bound", bound.value);
  return bound;
}

template <int d>
void report_bound(const CoulombBound& bound, StuckNodes stuck) {
  cout << "contacterror: mu kappa "
       << bound.constant.friction * bound.constant.kappa;
  if (d == 3) cout << ", delta " << bound.missed;
  cout << ", bound " << bound.value << ", " << stuck_in_words(stuck) << endl;
}

/// The labelled facet with a free dof where tractions have most beyond linear functions, or
/// -1.
template <int d>
int most_bent(const Bodies<d>& bodies, const ElasticSystem& system,
              const VectorXd& bend) {
  int most = -1;
  const auto& boundary = bodies.joined.mesh.boundary;
  for (int f = 0; f < bend.size(); ++f) {
    if (bend[f] <= (most < 0 ? linear_to : bend[most])) continue;
    const auto vertices = boundary.col(f);
    const std::vector<int> of_facet(vertices.begin(), vertices.end());
    if (!free_dofs_at(of_facet, system).empty()) most = f;
  }
  return most;
}

/// What tractions have beyond what is judged exactly: e is no bound of that. Beyond a
/// twentieth of the largest one it is said at any verbosity.
template <int d>
void report_bend(Stack stack, const NamedArguments& named,
                 const Bodies<d>& bodies, const ElasticSystem& system,
                 const VectorXd& bend) {
  constexpr double much = 0.05;
  const int most = most_bent<d>(bodies, system, bend);
  if (most < 0 || mpirank != 0 ||
      (bend[most] <= much && named.verbosity_level(stack) < 1))
    return;
  const SimplexMesh<d>& mesh = bodies.joined.mesh;
  cout << "contacterror: traction= is not linear on the " << MeshWords<d>::facet
       << " at "
       << in_words(
              facet_points<d>(mesh, mesh.boundary.col(most)).rowwise().mean())
       << ", by " << 100 * bend[most]
       << " % of its largest value: e is no bound of what this does" << endl;
}

inline void report_varying_force(double oscillation,
                                 const Ref<const MatrixXd>& loads) {
  if (vary_in_cells(oscillation, loads))
    cout << "contacterror: bodyforce= varies within cells: e is no bound of "
            "what this does, oscillation= measures it"
         << endl;
}

template <int d>
JudgedError<d> contact_error(Stack stack, const NamedArguments& named,
                             const ContactProblem<d>& problem,
                             const JudgedOf<d>& judged_of,
                             const ReadBodies<d>& read,
                             const RelaxFacets<d>& relax) {
  const Stopwatch watch;
  EstimateSettings<d> settings =
      ErrorOf<d>::settings(stack, named, problem.law);
  settings.relaxation = relaxation_of<d>(stack, named);
  settings.relax = relax;
  const StuckNodes stuck = stuck_nodes_of(stack, named);
  Judged<d> judged = judged_of();
  const Oscillation oscillation = read(problem, judged.body);
  const Topology<d>& topology = problem.topology();
  Estimate<d> estimate = estimate_error(topology, problem.contact,
                                        *judged.system, judged.body, settings);
  put_by_bodies(stack, named, problem.joined.first_cell, "eps", estimate.local);
  put_error(stack, named, estimate);
  put_defects(stack, named, estimate);
  named.put(stack, "oscillation", oscillation.force);
  named.put(stack, "strainoscillation", oscillation.strain);
  ErrorOf<d>::put(stack, named, problem, topology, judged, estimate);
  const double seconds = watch.seconds();
  const auto bound =
      put_bound(stack, named, problem, topology, judged, estimate, stuck);
  if (named.verbosity_level(stack) >= 1 && mpirank == 0) {
    ErrorOf<d>::report(estimate, seconds);
    report_oscillation(estimate);
    report_varying_force(oscillation.force, judged.body.body_loads);
    if (bound) report_bound<d>(*bound, stuck);
    if (named.verbosity_level(stack) > 1) report_parts(estimate);
  }
  report_bend<d>(stack, named, problem, *judged.system, oscillation.bend);
  report_reason(stack, named, estimate);
  return {std::move(estimate), std::move(judged.body)};
}

}  // namespace ffcontact::plugin
