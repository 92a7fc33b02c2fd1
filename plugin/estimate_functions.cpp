// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <optional>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/estimate/stress_on_triangles.hpp"
#include "ffcontact/sizing/local_rates.hpp"
//
#include "coulomb.hpp"
#include "guard.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// Sweeps at most when the script asks for a tightness and not for a number of sweeps.
constexpr int most_sweeps = 20;

/// What is given for each body.
const NamedArguments::Table of_bodies = {
    {"lambda", &typeid(double)},     {"G", &typeid(double)},
    {"hooke", &typeid(E_Array)},     {"traction", &typeid(E_Array)},
    {"bodyforce", &typeid(E_Array)}, {"eps", &typeid(KN<double>*)},
    {"rate", &typeid(KN<double>*)},  {"sxx", &typeid(KN<double>*)},
    {"syy", &typeid(KN<double>*)},   {"sxy", &typeid(KN<double>*)}};

/// A solution that is to be judged: of contactsolve, or given by the script.
struct Judged {
  std::shared_ptr<const ElasticSystem> system;
  SolvedBody body;
  ContactForces forces;
  const SolvedContact* solved = nullptr;  ///< null: given by the script
  double oscillation = 0;
};

/// kappa of Coulomb's law and what it makes of e.
struct CoulombBound {
  CoulombConstant constant;
  double value;
  StuckNodes stuck;
};

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
          "and pt, or "
          "nothing at all");
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
    NamedArguments::Table table = for_bodies(of_bodies, arguments);
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
                               {"history", &typeid(KN<double>*)},
                               {"rn", &typeid(KN<double>*)},
                               {"rt", &typeid(KN<double>*)},
                               {"rabscissa", &typeid(KN<double>*)},
                               {"corrected", &typeid(long*)},
                               {"unmended", &typeid(long*)},
                               {"oscillation", &typeid(double*)},
                               {"balance", &typeid(double*)},
                               {"cone", &typeid(double*)},
                               {"penetration", &typeid(double*)},
                               {"admissible", &typeid(bool*)}});
    return table;
  }

  double run(Stack stack) const {
    const double start = CPUtime();
    const Contact& contact = stated_contact(stack, contact_);
    const ContactProblem& problem = *contact.problem;
    require_names_of_bodies(named_, of_bodies, problem.body_count());
    const EstimateSettings settings = estimate_settings(stack);
    const StuckNodes stuck = stuck_nodes_of(stack, named_);
    Judged judged = matrix_.empty() ? own_solution(contact)
                                    : given_solution(stack, problem);
    add_law_and_loads(stack, problem, judged);
    const SolvedBody& body = judged.body;
    const auto& system = judged.system;
    const Estimate estimate = estimate_error(problem.topology(), problem.line,
                                             *system, body, settings);
    put(stack, problem, estimate);
    put_rates(stack, problem, *system, body);
    named_.put(stack, "oscillation", judged.oscillation);
    const double seconds = CPUtime() - start;
    const std::optional<CoulombBound> bound =
        coulomb_bound_of(problem, judged, estimate, stuck);
    if (bound) {
      named_.put(stack, "coulomb", bound->constant.kappa);
      named_.put(stack, "bound", bound->value);
    }
    report(stack, problem, estimate, bound, seconds);
    return estimate.relative;
  }

  Judged own_solution(const Contact& contact) const {
    if (named_.given("multiplier"))
      refuse(
          "multiplier= is given, but pn and pt are not: it is known from "
          "contactsolve");
    const SolvedContact& solved = solved_contact(contact);
    Judged judged;
    judged.system = solved.system;
    judged.body.displacement = solved.solution.displacement;
    judged.body.pressure = solved.solution.pressure;
    judged.body.law = solved.law;
    judged.body.stiffness = solved.solution.stiffness;
    judged.forces = contact_forces(solved.law, solved.solution);
    judged.solved = &solved;
    return judged;
  }

  Judged given_solution(Stack stack, const ContactProblem& problem) const {
    problem.require_bodies("A, u", matrix_.size());
    std::vector<ElasticSystem> systems;
    Judged judged;
    SolvedBody& body = judged.body;
    body.displacement.resize(problem.first_dof(problem.body_count()));
    for (int k = 0; k < problem.body_count(); ++k) {
      const RowMatrix A =
          matrix_of(value_of<Matrice_Creuse<double>*>(stack, matrix_[k]));
      KN<double>* u = value_of<KN<double>*>(stack, displacement_[k]);
      problem.require_dofs("A", k, A.rows());
      problem.require_dofs("u", k, u->N());
      body.displacement.segment(problem.first_dof(k), problem.dof_count(k)) =
          vector_of(u);
      systems.push_back(elastic_system(A, VectorXd::Zero(A.rows())));
    }
    judged.system = std::make_shared<const ElasticSystem>(
        systems.size() == 1 ? std::move(systems.front())
                            : joined_systems(systems));
    body.law = problem.law;
    body.law.multiplier = multiplier_of(stack, named_);
    const Matrix2Xd given =
        problem.pressures(value_of<KN<double>*>(stack, normal_),
                          value_of<KN<double>*>(stack, tangential_));
    body.pressure = multiplier_density(problem.line, body.law.multiplier,
                                       judged.system->prescribed, given);
    judged.forces = contact_forces(problem.line, body.law, given);
    return judged;
  }

  static std::shared_ptr<const CondensedContact> contact_of(
      const ContactProblem& problem, const Judged& judged) {
    if (judged.solved) return contact_of_forces(problem.line, *judged.solved);
    const ElasticSystem& system = *judged.system;
    return contact_of_forces(
        problem.line, judged.body.law, system,
        CondensedStiffness(system, contact_dofs(problem.line, system)));
  }

  /// Nothing where the script does not ask for it; infinite for a pair that is not
  /// admissible.
  std::optional<CoulombBound> coulomb_bound_of(const ContactProblem& problem,
                                               const Judged& judged,
                                               const Estimate& estimate,
                                               StuckNodes stuck) const {
    if (!named_.given("coulomb") && !named_.given("bound")) return std::nullopt;
    const CoulombConstant constant = coulomb_constant_of(
        problem.line, judged.body.law, *contact_of(problem, judged),
        judged.body.displacement, judged.forces, stuck);
    const double value =
        estimate.admissible
            ? coulomb_bound(estimate.e, constant.friction, constant.kappa)
            : std::numeric_limits<double>::infinity();
    return CoulombBound{constant, value, stuck};
  }

  EstimateSettings estimate_settings(Stack stack) const {
    EstimateSettings settings;
    const std::string tractions = named_.text(stack, "tractions", "free");
    if (tractions == "fixed")
      settings.tractions = Tractions::fixed;
    else if (tractions == "published")
      settings.tractions = Tractions::published;
    else if (tractions != "free")
      refuse("tractions must be \"free\", \"fixed\" or \"published\", got \"",
             tractions, "\"");
    const std::string construction =
        named_.text(stack, "construction", "composite");
    if (construction == "polynomial")
      settings.construction = Construction::polynomial;
    else if (construction != "composite")
      refuse("construction must be \"composite\" or \"polynomial\", got \"",
             construction, "\"");
    RelaxationSettings& relaxation = settings.relaxation;
    relaxation.tightness =
        named_.number(stack, "tightness", relaxation.tightness);
    const int sweeps =
        relaxation.tightness > 0 ? most_sweeps : relaxation.sweeps;
    relaxation.sweeps =
        static_cast<int>(named_.integer(stack, "sweeps", sweeps));
    return settings;
  }

  void add_law_and_loads(Stack stack, const ContactProblem& problem,
                         Judged& judged) const {
    const JoinedMesh& joined = problem.joined;
    const int bodies = problem.body_count();
    SolvedBody& body = judged.body;
    body.neumann.resize(4, joined.first_boundary.back());
    body.body_loads.resize(6, joined.first_triangle.back());
    for (int k = 0; k < bodies; ++k) {
      const Fem2D::Mesh& fem_mesh = *problem.fem_meshes[k];
      const std::string traction = name_of_body("traction", k, bodies),
                        f = name_of_body("bodyforce", k, bodies);
      add_hooke(stack, problem, k, body.hooke);
      const Mesh mesh = mesh_of(&fem_mesh);
      body.neumann.middleCols(joined.first_boundary[k], mesh.boundary.cols()) =
          traction_moments(stack, named_.component(traction, 0, 2),
                           named_.component(traction, 1, 2), fem_mesh, mesh);
      const BodyForce force =
          body_force_loads(stack, named_.component(f, 0, 2),
                           named_.component(f, 1, 2), fem_mesh, mesh);
      body.body_loads.middleCols(joined.first_triangle[k], mesh.cells.cols()) =
          force.loads;
      judged.oscillation = std::hypot(judged.oscillation, force.oscillation);
    }
  }

  /// Appends the tensors of one body's triangles.
  void add_hooke(Stack stack, const ContactProblem& problem, int body,
                 Hooke& all) const {
    const int bodies = problem.body_count();
    const Fem2D::Mesh& fem_mesh = *problem.fem_meshes[body];
    const std::string name = name_of_body("hooke", body, bodies),
                      lambda_name = name_of_body("lambda", body, bodies),
                      G_name = name_of_body("G", body, bodies);
    const Expression lambda = named_.expression(lambda_name),
                     G = named_.expression(G_name);
    const bool lame = lambda && G;
    if (lame == named_.given(name))
      refuse("give either ", lambda_name, "= and ", G_name,
             "= (Lame's constants) or ", name,
             "=[C11, C12, C13, C22, C23, C33]");
    Hooke hooke(fem_mesh.nt);
    if (lame) {
      const VectorXd lambdas = at_triangles(stack, lambda, fem_mesh, 0);
      const VectorXd Gs = at_triangles(stack, G, fem_mesh, 0);
      for (Index t = 0; t < Gs.size(); ++t)
        hooke[t] = isotropic(lambdas[t], Gs[t]);
    } else {
      constexpr int row[] = {0, 0, 0, 1, 1, 2}, column[] = {0, 1, 2, 1, 2, 2};
      for (int c = 0; c < 6; ++c) {
        const VectorXd values =
            at_triangles(stack, named_.component(name, c, 6), fem_mesh, 0);
        for (Index t = 0; t < values.size(); ++t)
          hooke[t](row[c], column[c]) = hooke[t](column[c], row[c]) = values[t];
      }
    }
    all.insert(all.end(), hooke.begin(), hooke.end());
  }

  bool is_wanted(const char* parameter, int bodies) const {
    for (int k = 0; k < bodies; ++k)
      if (named_.given(name_of_body(parameter, k, bodies))) return true;
    return false;
  }

  void put_rates(Stack stack, const ContactProblem& problem,
                 const ElasticSystem& system, const SolvedBody& body) const {
    if (!is_wanted("rate", problem.body_count())) return;
    const Topology& topology = problem.topology();
    const BoundaryTractions boundary = boundary_tractions(
        topology.mesh, topology.edges, system.prescribed, body.neumann,
        problem.line, edge_densities(problem.line, body.pressure));
    const std::vector<SingularVertex> singular = singular_vertices(
        topology, body.hooke,
        stresses(topology.mesh, body.hooke, body.displacement), boundary,
        contact_edge_numbers(problem.line, topology.edges));
    put_by_triangles(stack, problem, "rate", local_rates(topology, singular));
  }

  void put_by_triangles(Stack stack, const ContactProblem& problem,
                        const char* parameter, const VectorXd& values) const {
    const std::vector<int>& first = problem.joined.first_triangle;
    const int bodies = problem.body_count();
    for (int k = 0; k < bodies; ++k)
      named_.put(stack, name_of_body(parameter, k, bodies),
                 values.segment(first[k], first[k + 1] - first[k]));
  }

  /// One stress component as a P1dc array on splitmesh3(Th), whose triangle 3 t + k is
  /// triangle t with vertex k moved to the centroid. FreeFEM keeps P1dc values at the
  /// vertices shrunk by 1 % towards the triangle's centroid.
  static VectorXd stress_component(const std::vector<CompositeStress>& stress,
                                   int component) {
    constexpr double shrink = 0.01;
    VectorXd values(9 * static_cast<Index>(stress.size()));
    for (std::size_t t = 0; t < stress.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        // k+1, k+2, centroid
        const Vector3d corners =
            stress[t].block<1, 3>(component, 3 * k).transpose();
        for (int c = 0; c < 3; ++c) {
          const int vertex = (k + 1 + c) % 3;
          values[9 * static_cast<Index>(t) + 3 * k + vertex] =
              (1 - shrink) * corners[c] + shrink * corners.mean();
        }
      }
    return values;
  }

  void put_stress(Stack stack, const ContactProblem& problem,
                  const Estimate& estimate) const {
    constexpr const char* parameter[] = {"sxx", "syy", "sxy"};
    const int bodies = problem.body_count();
    if (!is_wanted("sxx", bodies) && !is_wanted("syy", bodies) &&
        !is_wanted("sxy", bodies))
      return;
    const std::vector<CompositeStress> stress =
        stress_on_triangles(problem.mesh, estimate);
    const std::vector<int>& first = problem.joined.first_triangle;
    for (int c = 0; c < 3; ++c) {
      const VectorXd values = stress_component(stress, c);
      for (int k = 0; k < bodies; ++k)
        named_.put(stack, name_of_body(parameter[c], k, bodies),
                   values.segment(9 * first[k], 9 * (first[k + 1] - first[k])));
    }
  }

  /// Abscissae of the ends of the edges on which r_hat is linear, two an edge, on the
  /// line that coefficients are stated on.
  static VectorXd abscissae(const ContactProblem& problem,
                            const Estimate& estimate) {
    if (!estimate.refinement) return problem.edge_abscissa.reshaped();
    const ContactLine& line = estimate.refinement->line;
    VectorXd values(2 * line.edge_count());
    for (int e = 0; e < line.edge_count(); ++e) {
      const int k = estimate.refinement->parent_contact_edge[e];
      const Vector2d ends = problem.edge_abscissa.col(k);
      for (int end = 0; end < 2; ++end) {
        const int vertex = line.vertex[line.edge_node(end, e)];
        const double place = estimate.refinement->place(problem.edges, vertex,
                                                        problem.line.edge[k]);
        values[2 * e + end] =
            ends[0] + problem.line.share(k, place) * (ends[1] - ends[0]);
      }
    }
    return values;
  }

  void put(Stack stack, const ContactProblem& problem,
           const Estimate& estimate) const {
    put_by_triangles(stack, problem, "eps", estimate.local);
    put_stress(stack, problem, estimate);
    named_.put(stack, "rabscissa", abscissae(problem, estimate));
    named_.put(stack, "e", estimate.e);
    named_.put(stack, "elasticpart", estimate.elastic);
    named_.put(stack, "contactpart", estimate.contact);
    named_.put(
        stack, "history",
        Map<const VectorXd>(estimate.history.data(), estimate.history.size()));
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
