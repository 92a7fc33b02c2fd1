// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"
//
#include "coulomb.hpp"
#include "guard.hpp"
#include "registration.hpp"
#include "solve_report.hpp"
#include "systems.hpp"

namespace ffcontact::plugin {

namespace {

/// 0 open, 1 stick, 2 slip along t, -2 slip against t.
std::vector<long> state_numbers(const std::vector<ContactState>& states) {
  std::vector<long> numbers;
  for (ContactState state : states)
    numbers.push_back(state == ContactState::stick ? 1 : 2 * slip_sign(state));
  return numbers;
}

ContactState state_of_number(long number) {
  switch (number) {
    case 0: return ContactState::open;
    case 1: return ContactState::stick;
    case 2: return ContactState::slip_forward;
    case -2: return ContactState::slip_backward;
    default:
      refuse(
          "an initial state must be 0 (open), 1 (stick), 2 or -2 (slip), got ",
          number);
  }
}

/// Results at the nodes: pn and pt are the multipliers of M'_h, for M''_h forces over
/// lengths.
NodalResults nodal_results(const ContactLine& line, const ContactLaw& law,
                           const std::vector<char>& prescribed,
                           const ContactSolution& solution) {
  const Matrix2Xd pressure =
      law.multiplier == Multiplier::pressure
          ? solution.pressure
          : lumped_pressures(line, prescribed, solution.force);
  const Matrix2Xd moved =
      displacement_against_foundation(line, law, solution.displacement);
  NodalResults results;
  results.pn = pressure.row(0);
  results.pt = pressure.row(1);
  results.fn = solution.force.row(0);
  results.ft = solution.force.row(1);
  results.gap = -moved.row(0);
  results.slip = moved.row(1);
  results.state = state_numbers(solution.state);
  return results;
}

bool is_same(const RowMatrix& A, const RowMatrix& B) {
  const auto same = [](const auto* a, const auto* b, Index count) {
    return std::equal(a, a + count, b);
  };
  if (A.rows() != B.rows() || A.nonZeros() != B.nonZeros()) return false;
  return same(A.valuePtr(), B.valuePtr(), A.nonZeros()) &&
         same(A.innerIndexPtr(), B.innerIndexPtr(), A.nonZeros()) &&
         same(A.outerIndexPtr(), B.outerIndexPtr(), A.rows() + 1);
}

bool is_same(const ElasticSystem& a, const ElasticSystem& b) {
  return a.prescribed == b.prescribed && is_same(a.stiffness, b.stiffness);
}

/// The vertices inside a body.
std::vector<int> inner_vertices(const Mesh& mesh) {
  std::vector<char> on_boundary(mesh.vertices.cols(), 0);
  for (int v : mesh.boundary.reshaped()) on_boundary[v] = 1;
  std::vector<int> inner;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (!on_boundary[v]) inner.push_back(v);
  return inner;
}

/// Are b and u exchanged? Loads on the boundary alone are 0 inside, displacements are
/// not.
void require_order(const Mesh& mesh, const VectorXd& load,
                   const VectorXd& displacement) {
  if (!load.isZero(0) || displacement.isZero(0)) return;
  const std::vector<int> inner = inner_vertices(mesh);
  for (int v : inner)
    if (!displacement.segment<2>(2 * v).isZero(0)) return;
  if (!inner.empty())
    refuse(
        "b is 0 and u is 0 inside the body, but not on its boundary: they are "
        "exchanged, give A, b, u");
}

/// iterations = contactsolve(C, A, b, u, ...), with matrix, load and displacement of each
/// body.
class ContactSolve : public E_F0mps {
 public:
  using Result = long;

  explicit ContactSolve(const basicAC_F0& arguments)
      : named_(arguments, {{"multiplier", &typeid(string*)},
                           {"solver", &typeid(string*)},
                           {"maxit", &typeid(long)},
                           {"tol", &typeid(double)},
                           {"initial", &typeid(KN_<long>)},
                           {"loadstep", &typeid(bool)},
                           {"verbosity", &typeid(long)},
                           {"pn", &typeid(KN<double>*)},
                           {"pt", &typeid(KN<double>*)},
                           {"fn", &typeid(KN<double>*)},
                           {"ft", &typeid(KN<double>*)},
                           {"gap", &typeid(KN<double>*)},
                           {"slip", &typeid(KN<double>*)},
                           {"node", &typeid(KN<long>*)},
                           {"abscissa", &typeid(KN<double>*)},
                           {"state", &typeid(KN<long>*)},
                           {"violation", &typeid(double*)},
                           {"status", &typeid(long*)},
                           {"history", &typeid(KN<double>*)},
                           {"opennodes", &typeid(long*)},
                           {"sticknodes", &typeid(long*)},
                           {"slipnodes", &typeid(long*)}}),
        contact_(to<ContactVariable*>(arguments[0])) {
    if (arguments.size() < 4 || arguments.size() % 3 != 1)
      CompileError(
          "contactsolve: after the contact come A, b and u of each body");
    for (int k = 1; k < arguments.size(); k += 3) {
      matrix_.push_back(to<Matrice_Creuse<double>*>(arguments[k]));
      load_.push_back(to<KN<double>*>(arguments[k + 1]));
      displacement_.push_back(to<KN<double>*>(arguments[k + 2]));
    }
  }

  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<ContactVariable*>(), true);
  }
  static E_F0* f(const basicAC_F0& arguments) {
    return new ContactSolve(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("contactsolve", [&] { return SetAny<long>(run(stack)); });
  }

 private:
  long run(Stack stack) const {
    const double start = CPUtime();
    Contact& contact = stated_contact(stack, contact_);
    ContactProblem& problem = *contact.problem;
    problem.require_bodies("A, b, u", matrix_.size());
    const std::vector<KN<double>*> u =
        values_of<KN<double>*>(stack, displacement_);

    SolvedContact solved;
    solved.system =
        std::make_shared<const ElasticSystem>(system_of(stack, problem, u));
    const ElasticSystem& system = *solved.system;
    // and stays: what a solution left belongs to its line
    if (!contact.solved) problem.choose_sides(system);
    solved.law = law_of(stack, contact);
    const ContactSettings settings = settings_of(stack, contact, system);
    solved.solution =
        solve_contact(problem.mesh, problem.line, solved.law, system, settings);
    const ContactSolution& solution = solved.solution;
    if (!solution.accepted(settings) && !named_.given("status"))
      refuse_solution(problem, system, solution);

    for (int k = 0; k < problem.body_count(); ++k)
      vector_of(u[k]) = solution.displacement.segment(problem.first_dof(k),
                                                      problem.dof_count(k));
    solved.nodes =
        nodal_results(problem.line, solved.law, system.prescribed, solution);
    put(stack, problem, solved);
    report_solution(named_.verbosity_level(stack), problem, solution,
                    CPUtime() - start);
    report_friction(named_.verbosity_level(stack), problem, solved);
    contact.last_states = solution.state;
    contact.last_abscissa = problem.abscissa;
    contact.solved = std::move(solved);
    return contact.solved->solution.iterations;
  }

  ElasticSystem system_of(Stack stack, const ContactProblem& problem,
                          const std::vector<KN<double>*>& u) const {
    std::vector<ElasticSystem> systems;
    VectorXd load(problem.first_dof(problem.body_count()));
    for (int k = 0; k < problem.body_count(); ++k) {
      const RowMatrix A = matrix_of_body(stack, problem, k, matrix_[k]);
      const VectorXd b = vector_of(value_of<KN<double>*>(stack, load_[k]));
      problem.require_dofs("b", k, b.size());
      load.segment(problem.first_dof(k), problem.dof_count(k)) = b;
      systems.push_back(elastic_system(A, b));
    }
    require_order(problem.mesh, load, joined_displacement(problem, u));
    return joined(std::move(systems));
  }

  ContactLaw law_of(Stack stack, const Contact& contact) const {
    ContactLaw law = contact.problem->law;
    law.multiplier = multiplier_of(stack, named_);
    if (!named_.flag(stack, "loadstep")) return law;
    if (contact.solved)
      law.previous = contact_components(contact.problem->line,
                                        contact.solved->solution.displacement)
                         .row(1);
    else if (!contact.last_states.empty() && law.previous.size() == 0)
      refuse(
          "loadstep=true, but the contact was stated anew since its last "
          "solution: state it with previous=");
    return law;
  }

  ContactSettings settings_of(Stack stack, const Contact& contact,
                              const ElasticSystem& system) const {
    ContactSettings settings;
    settings.solver =
        named_.choice(stack, "solver", settings.solver,
                      {{"newton", ContactSolver::newton},
                       {"fixedpoint", ContactSolver::fixed_point}});
    settings.max_iterations = static_cast<int>(
        named_.integer(stack, "maxit", settings.max_iterations));
    settings.tolerance = named_.number(stack, "tol", settings.tolerance);
    if (!(settings.tolerance > 0))
      refuse("tol must be positive, got ", settings.tolerance);
    ContactLine stated = contact.problem->line;
    stated.abscissa = contact.problem->abscissa;
    settings.initial_state =
        states_at(stated, contact.last_abscissa, contact.last_states);
    if (named_.given("initial")) settings.initial_state.clear();
    for (long number : named_.integers(stack, "initial"))
      settings.initial_state.push_back(state_of_number(number));
    if (contact.solved && is_same(*contact.solved->system, system))
      settings.stiffness = contact.solved->solution.stiffness;
    return settings;
  }

  void put(Stack stack, const ContactProblem& problem,
           const SolvedContact& solved) const {
    const ContactSolution& solution = solved.solution;
    const NodalResults& nodes = solved.nodes;
    const Counts counts = counted(solution.state);
    named_.put(stack, "pn", nodes.pn);
    named_.put(stack, "pt", nodes.pt);
    named_.put(stack, "fn", nodes.fn);
    named_.put(stack, "ft", nodes.ft);
    named_.put(stack, "gap", nodes.gap);
    named_.put(stack, "slip", nodes.slip);
    named_.put_integers(stack, "node", problem.own_vertex);
    named_.put(stack, "abscissa", problem.abscissa);
    named_.put_integers(stack, "state", nodes.state);
    named_.put(stack, "violation", solution.complementarity);
    named_.put(stack, "status", static_cast<long>(solution.status));
    named_.put(stack, "history", packed(solution.history));
    named_.put(stack, "opennodes", counts.open);
    named_.put(stack, "sticknodes", counts.stick);
    named_.put(stack, "slipnodes", counts.slip);
  }

  NamedArguments named_;
  Expression contact_;
  std::vector<Expression> matrix_, load_, displacement_;
};

}  // namespace

void register_contact_functions() {
  Global.Add("contactsolve", "(", new OneOperatorCode<ContactSolve>());
}

}  // namespace ffcontact::plugin
