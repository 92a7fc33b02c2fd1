// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/estimate/stress_on_triangles.hpp"
#include "ffcontact/sizing/local_rates.hpp"
//
#include "estimate_arrays.hpp"
#include "guard.hpp"
#include "judged.hpp"
#include "material_and_loads.hpp"
#include "progress_lines.hpp"
#include "registration.hpp"
#include "shared_error.hpp"
#include "solid_error.hpp"
#include "solid_loads.hpp"
#include "systems.hpp"

namespace ffcontact::plugin {

namespace {

/// Sweeps at most when the script asks for a tightness and not for a number of sweeps.
constexpr int most_sweeps = 20;

/// What is given for each body.
const NamedArguments::Table estimates_of_bodies = {
    {"lambda", &typeid(double)},         {"G", &typeid(double)},
    {"hooke", &typeid(E_Array)},         {"traction", &typeid(E_Array)},
    {"bodyforce", &typeid(E_Array)},     {"initialstrain", &typeid(E_Array)},
    {"initialstress", &typeid(E_Array)}, {"spring", &typeid(E_Array)},
    {"rest", &typeid(E_Array)},          {"eps", &typeid(KN<double>*)},
    {"rate", &typeid(KN<double>*)},      {"sxx", &typeid(KN<double>*)},
    {"syy", &typeid(KN<double>*)},       {"szz", &typeid(KN<double>*)},
    {"syz", &typeid(KN<double>*)},       {"sxz", &typeid(KN<double>*)},
    {"sxy", &typeid(KN<double>*)}};

/// What a solid has, and plane bodies have not.
void require_parameters_of_plane_bodies(const NamedArguments& named) {
  for (const char* parameter : {"rt1", "rt2"})
    if (named.given(parameter))
      refuse(parameter, "= is for a mesh3; plane bodies have rt=");
  for (const char* of_bodies : {"szz", "syz", "sxz", "tractionoscillation"})
    if (named.given_of_bodies(of_bodies)) refuse(of_bodies, "= is for a mesh3");
}

/// eps = contacterror(C, lambda=, G=, traction=[Fx, Fy], eps=, ...) for what contactsolve
/// found, or eps = contacterror(C, A, u, pn, pt, ...) with matrix and displacement of
/// each body for what another solver found.
class ContactErrorFunction : public E_F0mps {
 public:
  using Result = double;

  explicit ContactErrorFunction(const basicAC_F0& arguments)
      : named_(arguments, table(arguments)),
        contact_(to<ContactVariable*>(arguments[0])) {
    if (arguments.size() == 1) return;
    if (arguments.size() % 2 == 0 || arguments.size() < 5)
      CompileError(
          "contacterror: after the contact come A and u of each body, then pn "
          "and pt, or nothing at all");
    const int last = arguments.size() - 2;
    for (int k = 1; k < last; k += 2) {
      matrix_.push_back(to<Matrice_Creuse<double>*>(arguments[k]));
      displacement_.push_back(to<KN<double>*>(arguments[k + 1]));
    }
    normal_ = to<KN<double>*>(arguments[last]);
    tangential_ = to<KN<double>*>(arguments[last + 1]);
  }

  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<ContactVariable*>(), true);
  }
  static E_F0* f(const basicAC_F0& arguments) {
    return new ContactErrorFunction(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("contacterror", [&] { return SetAny<double>(run(stack)); });
  }

 private:
  static NamedArguments::Table table(const basicAC_F0& arguments) {
    NamedArguments::Table table = for_bodies(estimates_of_bodies, arguments);
    table.insert(table.end(), {{"multiplier", &typeid(string*)},
                               {"tractions", &typeid(string*)},
                               {"construction", &typeid(string*)},
                               {"sweeps", &typeid(long)},
                               {"tightness", &typeid(double)},
                               {"verbosity", &typeid(long)},
                               {"stick", &typeid(string*)},
                               {"coulomb", &typeid(double*)},
                               {"bound", &typeid(double*)},
                               {"e", &typeid(double*)},
                               {"elasticpart", &typeid(double*)},
                               {"contactpart", &typeid(double*)},
                               {"springpart", &typeid(double*)},
                               {"history", &typeid(KN<double>*)},
                               {"rn", &typeid(KN<double>*)},
                               {"rt", &typeid(KN<double>*)},
                               {"rt1", &typeid(KN<double>*)},
                               {"rt2", &typeid(KN<double>*)},
                               {"rabscissa", &typeid(KN<double>*)},
                               {"corrected", &typeid(long*)},
                               {"unmended", &typeid(long*)},
                               {"oscillation", &typeid(double*)},
                               {"strainoscillation", &typeid(double*)},
                               {"tractionoscillation", &typeid(double*)},
                               {"balance", &typeid(double*)},
                               {"cone", &typeid(double*)},
                               {"penetration", &typeid(double*)},
                               {"admissible", &typeid(bool*)}});
    return table;
  }

  double run(Stack stack) const {
    const double start = CPUtime();
    Contact& contact = contact_of_processes(stack, contact_);
    if (contact.shared) return shared_run(stack, contact, start);
    if (contact.solid.problem) {
      require_own_solution(
          "that of a mesh3, which contacterror judges by what contactsolve "
          "found: contacterror(C, lambda=, G=, ...)");
      require_names_of_bodies(named_, estimates_of_bodies,
                              contact.solid.problem->body_count());
      return solid_error(stack, named_, contact.solid, solid_reader(stack));
    }
    require_names_of_bodies(named_, estimates_of_bodies,
                            contact.problem->body_count());
    return plane_error(stack, contact, plane_reader(stack), start);
  }

  double shared_run(Stack stack, Contact& contact, double start) const {
    SharedContact& shared = *contact.shared;
    require_own_solution(
        "one of several processes, which contacterror judges by what "
        "contactsolve found: contacterror(C, lambda=, G=, ...)");
    const int bodies = shared.plane ? shared.plane->own.body_count()
                                    : shared.solid->own.body_count();
    require_names_of_bodies(named_, estimates_of_bodies, bodies);
    if (shared.plane)
      return error_shared(stack, named_, shared, plane_reader(stack),
                          [&](const ReadPlane& read) {
                            return plane_error(stack, contact, read, start);
                          });
    return error_shared(stack, named_, shared, solid_reader(stack),
                        [&](const ReadSolids& read) {
                          return solid_error(stack, named_, contact.solid,
                                             read);
                        });
  }

  void require_own_solution(const char* kind) const {
    if (!matrix_.empty()) refuse("the contact is ", kind);
  }

  ReadPlane plane_reader(Stack stack) const {
    return [this, stack](const PlaneBodies& bodies, SolvedBody& body) {
      return read_material_and_loads(stack, named_, bodies, body);
    };
  }

  ReadSolids solid_reader(Stack stack) const {
    return
        [this, stack](const SolidBodies& bodies, ffcontact::SolvedSolid& body) {
          return read_material_and_loads(stack, named_, bodies, body);
        };
  }

  double plane_error(Stack stack, Contact& contact, const ReadPlane& read,
                     double start) const {
    const ContactProblem& problem = *contact.problem;
    require_parameters_of_plane_bodies(named_);
    const EstimateSettings settings = estimate_settings(stack);
    const StuckNodes stuck = stuck_nodes_of(stack, named_);
    Judged judged = matrix_.empty() ? own_solution(contact)
                                    : given_solution(stack, problem);
    const Oscillation oscillation = read(problem, judged.body);
    const ElasticSystem& system = *judged.system;
    Estimate estimate = estimate_error(problem.topology(), problem.line, system,
                                       judged.body, settings);
    put(stack, problem, estimate);
    put_rates(stack, problem, system, judged.body);
    named_.put(stack, "oscillation", oscillation.force);
    named_.put(stack, "strainoscillation", oscillation.strain);
    const double seconds = CPUtime() - start;
    std::optional<CoulombBound> bound;
    if (wants_bound()) {
      bound = coulomb_bound_of(problem.line, judged, estimate, stuck);
      named_.put(stack, "coulomb", bound->constant.kappa);
      named_.put(stack, "bound", bound->value);
    }
    report(stack, problem, estimate, bound, seconds);
    const double relative = estimate.relative;
    if (matrix_.empty())
      contact.solved->estimate =
          std::make_shared<const Estimate>(std::move(estimate));
    return relative;
  }

  Judged own_solution(const Contact& contact) const {
    if (named_.given("multiplier"))
      refuse(
          "multiplier= is given, but pn and pt are not: it is known from "
          "contactsolve");
    return judged_of(solved_contact(contact));
  }

  Judged given_solution(Stack stack, const ContactProblem& problem) const {
    problem.require_bodies("A, u", matrix_.size());
    std::vector<ElasticSystem> systems;
    for (int k = 0; k < problem.body_count(); ++k) {
      const RowMatrix A = matrix_of_body(stack, problem, k, matrix_[k]);
      systems.push_back(elastic_system(A, VectorXd::Zero(A.rows())));
    }
    const Matrix2Xd pressures =
        problem.pressures(value_of<KN<double>*>(stack, normal_),
                          value_of<KN<double>*>(stack, tangential_));
    Judged judged =
        judged_of(problem, joined(std::move(systems)),
                  joined_displacement(
                      problem, values_of<KN<double>*>(stack, displacement_)),
                  multiplier_of(stack, named_), pressures);
    // for the estimate, too
    if (wants_bound()) judged.factorise(problem.line);
    return judged;
  }

  bool wants_bound() const {
    return named_.given("coulomb") || named_.given("bound");
  }

  EstimateSettings estimate_settings(Stack stack) const {
    EstimateSettings settings;
    settings.tractions = named_.choice(stack, "tractions", Tractions::free,
                                       {{"free", Tractions::free},
                                        {"fixed", Tractions::fixed},
                                        {"published", Tractions::published}});
    settings.construction =
        named_.choice(stack, "construction", Construction::composite,
                      {{"composite", Construction::composite},
                       {"polynomial", Construction::polynomial}});
    RelaxationSettings& relaxation = settings.relaxation;
    relaxation.tightness =
        named_.number(stack, "tightness", relaxation.tightness);
    const int sweeps =
        relaxation.tightness > 0 ? most_sweeps : relaxation.sweeps;
    relaxation.sweeps =
        static_cast<int>(named_.integer(stack, "sweeps", sweeps));
    relaxation.report =
        progress_lines("contacterror", named_.verbosity_level(stack));
    return settings;
  }

  void put_rates(Stack stack, const ContactProblem& problem,
                 const ElasticSystem& system, const SolvedBody& body) const {
    if (!named_.given_of_bodies("rate")) return;
    const Topology& topology = problem.topology();
    const BoundaryTractions boundary =
        boundary_tractions(topology.mesh, topology.edges, system.prescribed,
                           boundary_moments(topology.mesh, body), problem.line,
                           edge_densities(problem.line, body.pressure));
    const std::vector<SingularVertex> singular = singular_vertices(
        topology, body.hooke,
        total_stresses(topology.mesh, body, body.displacement).mean, boundary,
        contact_edge_numbers(problem.line, topology.edges));
    put_by_bodies(stack, named_, problem.joined.first_cell, "rate",
                  local_rates(topology, singular));
  }

  void put_stress(Stack stack, const ContactProblem& problem,
                  const Estimate& estimate) const {
    constexpr std::array parameter = {"sxx", "syy", "sxy"};
    const auto wanted = [&](const char* name) {
      return named_.given_of_bodies(name);
    };
    if (std::none_of(parameter.begin(), parameter.end(), wanted)) return;
    const std::vector<CompositeStress> stress =
        stress_on_triangles(problem.mesh, estimate);
    for (int c = 0; c < 3; ++c)
      put_by_bodies(stack, named_, problem.joined.first_cell, parameter[c],
                    stress_component(stress, c));
  }

  void put(Stack stack, const ContactProblem& problem,
           const Estimate& estimate) const {
    put_by_bodies(stack, named_, problem.joined.first_cell, "eps",
                  estimate.local);
    put_stress(stack, problem, estimate);
    named_.put(stack, "rabscissa", abscissae(problem, estimate));
    named_.put(stack, "e", estimate.e);
    named_.put(stack, "elasticpart", estimate.elastic);
    named_.put(stack, "contactpart", estimate.contact);
    named_.put(stack, "springpart", estimate.springs);
    named_.put(stack, "history", packed(estimate.history));
    named_.put(stack, "rn", estimate.tractions.normal.reshaped());
    named_.put(stack, "rt", estimate.tractions.tangential.reshaped());
    named_.put(stack, "corrected",
               static_cast<long>(estimate.corrected_count()));
    named_.put(stack, "unmended", static_cast<long>(estimate.unmended.size()));
    named_.put(stack, "balance", estimate.equilibrium.largest());
    named_.put(stack, "cone", estimate.cone);
    named_.put(stack, "penetration", estimate.penetration);
    named_.put(stack, "admissible", estimate.admissible);
  }

  void report(Stack stack, const ContactProblem& problem,
              const Estimate& estimate,
              const std::optional<CoulombBound>& bound, double seconds) const {
    const long level = named_.verbosity_level(stack);
    if (level < 1 || mpirank != 0) return;
    cout << "contacterror: " << problem.mesh.cell_count() << " triangles, eps "
         << 100 * estimate.relative << " %, e " << estimate.e << ", "
         << estimate.corrected_count() << " edges corrected, " << seconds
         << " s" << endl;
    if (!estimate.admissible)
      cout << "contacterror: not admissible: " << estimate.reason << endl;
    if (bound)
      cout << "contacterror: mu kappa "
           << bound->constant.friction * bound->constant.kappa << ", bound "
           << bound->value << ", " << in_words(bound->stuck) << endl;
    if (level > 1)
      cout << "contacterror: elastic part " << estimate.elastic
           << ", contact part of e^2 " << estimate.contact
           << ", that of springs " << estimate.springs
           << ", equilibrium defect " << estimate.equilibrium.largest()
           << ", cone defect " << estimate.cone << ", penetration "
           << estimate.penetration << endl;
  }

  NamedArguments named_;
  Expression contact_;
  std::vector<Expression> matrix_,
      displacement_;  ///< empty: what contactsolve found
  Expression normal_ = nullptr, tangential_ = nullptr;
};

}  // namespace

void register_estimate_functions() {
  Global.Add("contacterror", "(", new OneOperatorCode<ContactErrorFunction>());
}

}  // namespace ffcontact::plugin
