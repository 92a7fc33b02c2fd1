// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <sstream>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/cone_correction.hpp"
#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/contact/multiplier_projection.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"
//
#include "contact_arguments.hpp"
#include "guard.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

ContactSolver solver_named(const std::string& name) {
  if (name == "newton") return ContactSolver::newton;
  if (name == "fixedpoint") return ContactSolver::fixed_point;
  refuse("solver must be \"newton\" or \"fixedpoint\", got \"", name, "\"");
}

struct Counts {
  long open = 0, stick = 0, slip = 0;
};

Counts counted(const std::vector<ContactState>& states) {
  Counts counts;
  for (ContactState state : states)
    ++(state == ContactState::open ? counts.open : state == ContactState::stick ? counts.stick : counts.slip);
  return counts;
}

/// 0 open, 1 stick, 2 slip along t, -2 slip against t.
std::vector<long> state_numbers(const std::vector<ContactState>& states) {
  std::vector<long> numbers;
  for (ContactState state : states) numbers.push_back(state == ContactState::stick ? 1 : 2 * slip_sign(state));
  return numbers;
}

ContactState state_of_number(long number) {
  switch (number) {
    case 0: return ContactState::open;
    case 1: return ContactState::stick;
    case 2: return ContactState::slip_forward;
    case -2: return ContactState::slip_backward;
    default: refuse("an initial state must be 0 (open), 1 (stick), 2 or -2 (slip), got ", number);
  }
}

/// What the script can do about a solve that failed.
const char* remedy(ContactStatus status) {
  switch (status) {
    case ContactStatus::not_converged: return "; raise maxit=";
    case ContactStatus::cycled: return "; lower friction=, or bring the load in steps with previous= and initial=";
    case ContactStatus::singular: return "; prescribe displacements or give friction= that hold the body";
    default: return "; raise tol= if this is accurate enough";
  }
}

/// Does no free dof of the node's vertex move it along its normal?
bool is_held_along_normal(const ContactLine& line, const ElasticSystem& system, int node) {
  constexpr double tangential = 1e-3;
  for (int c = 0; c < 2; ++c)
    if (!system.prescribed[2 * line.vertex[node] + c] && std::abs(line.normal(c, node)) > tangential) return false;
  return true;
}

/// Part of a sentence that names the vertices of the line whose normal dof is prescribed, the first ones of many.
std::string held_vertices(const ContactArguments& contact, const ElasticSystem& system) {
  constexpr int most = 8;
  std::ostringstream names;
  int count = 0;
  for (int i = 0; i < contact.line.node_count(); ++i)
    if (is_held_along_normal(contact.line, system, i) && ++count <= most)
      names << (count > 1 ? ", " : "") << contact.own_vertex[i];
  if (count == 0) return "";
  return "; on() prescribes the normal displacement on the contact line at vertex " + names.str() +
         (count > most ? ", ..." : "") + ": leave it free there, or take these edges out of label=";
}

/// iterations = contactsolve(Th, A, b, u, label=, friction=, ...), or with mesh, matrix, load and displacement of each of
/// several bodies.
template <int bodies>
class ContactSolve : public E_F0mps {
 public:
  using Result = long;

  explicit ContactSolve(const basicAC_F0& arguments)
      : named_(arguments,
               ContactArguments::table({{"multiplier", &typeid(string*)},   {"solver", &typeid(string*)},
                                        {"maxit", &typeid(long)},           {"tol", &typeid(double)},
                                        {"initial", &typeid(KN_<long>)},    {"initialabscissa", &typeid(KN<double>*)},
                                        {"verbosity", &typeid(long)},       {"pn", &typeid(KN<double>*)},
                                        {"pt", &typeid(KN<double>*)},       {"fn", &typeid(KN<double>*)},
                                        {"ft", &typeid(KN<double>*)},       {"node", &typeid(KN<long>*)},
                                        {"abscissa", &typeid(KN<double>*)}, {"state", &typeid(KN<long>*)},
                                        {"violation", &typeid(double*)},    {"status", &typeid(long*)},
                                        {"history", &typeid(KN<double>*)},  {"open", &typeid(long*)},
                                        {"stick", &typeid(long*)},          {"slip", &typeid(long*)}},
                                       bodies)) {
    for (int k = 0; k < bodies; ++k) {
      mesh_.push_back(to<pmesh>(arguments[4 * k]));
      matrix_.push_back(to<Matrice_Creuse<double>*>(arguments[4 * k + 1]));
      load_.push_back(to<KN<double>*>(arguments[4 * k + 2]));
      displacement_.push_back(to<KN<double>*>(arguments[4 * k + 3]));
    }
  }

  static ArrayOfaType typeargs() {
    std::vector<aType> types;
    for (int k = 0; k < bodies; ++k)
      types.insert(types.end(),
                   {atype<pmesh>(), atype<Matrice_Creuse<double>*>(), atype<KN<double>*>(), atype<KN<double>*>()});
    return ArgumentTypes(types);
  }
  static E_F0* f(const basicAC_F0& arguments) { return new ContactSolve(arguments); }

  AnyType operator()(Stack stack) const override {
    return guarded("contactsolve", [&] { return SetAny<long>(run(stack)); });
  }

 private:
  long run(Stack stack) const {
    const double start = CPUtime();
    const ContactArguments contact(stack, named_, values_of<pmesh, const Fem2D::Mesh*>(stack, mesh_));
    const std::vector<KN<double>*> u = values_of<KN<double>*>(stack, displacement_);
    std::vector<ElasticSystem> systems;
    for (int k = 0; k < bodies; ++k) {
      const RowMatrix A = matrix_of(value_of<Matrice_Creuse<double>*>(stack, matrix_[k]));
      contact.require_dofs("A", k, A.rows());
      contact.require_dofs("u", k, u[k]->N());
      systems.push_back(elastic_system(A, vector_of(value_of<KN<double>*>(stack, load_[k]))));
    }
    const ElasticSystem system = bodies == 1 ? std::move(systems.front()) : joined_systems(systems);

    ContactLaw law = contact.law;
    law.multiplier = multiplier_of(stack, named_);
    const ContactSettings settings = settings_of(stack, contact.line);
    const ContactSolution solution = solve_contact(contact.mesh, contact.line, law, system, settings);
    if (!solution.accepted(settings) && !named_.given("status"))
      refuse("no solution after ", solution.iterations, " iterations (", in_words(solution.status),
             "), largest violation ", solution.complementarity, ", residual ", solution.residual,
             remedy(solution.status), "; status= returns the best iterate instead", held_vertices(contact, system));

    for (int k = 0; k < bodies; ++k)
      vector_of(u[k]) = solution.displacement.segment(contact.first_dof(k), contact.dof_count(k));
    put(stack, contact, law.multiplier, system.prescribed, solution);
    report(stack, contact, solution, CPUtime() - start);
    return solution.iterations;
  }

  ContactSettings settings_of(Stack stack, const ContactLine& line) const {
    ContactSettings settings;
    settings.solver = solver_named(named_.text(stack, "solver", "newton"));
    settings.max_iterations = static_cast<int>(named_.integer(stack, "maxit", settings.max_iterations));
    settings.tolerance = named_.number(stack, "tol", settings.tolerance);
    if (!(settings.tolerance > 0)) refuse("tol must be positive, got ", settings.tolerance);
    for (long number : named_.integers(stack, "initial")) settings.initial_state.push_back(state_of_number(number));
    if (const Expression abscissa = named_.expression("initialabscissa"))
      settings.initial_state =
          states_at(line, vector_of(GetAny<KN<double>*>((*abscissa)(stack))), settings.initial_state);
    return settings;
  }

  void put(Stack stack, const ContactArguments& contact, Multiplier multiplier, const std::vector<char>& prescribed,
           const ContactSolution& solution) const {
    const Eigen::Matrix2Xd pressure = multiplier == Multiplier::pressure
                                          ? solution.pressure
                                          : lumped_pressures(contact.line, prescribed, solution.force);
    const Counts counts = counted(solution.state);
    named_.put(stack, "pn", Eigen::VectorXd(pressure.row(0)));
    named_.put(stack, "pt", Eigen::VectorXd(pressure.row(1)));
    named_.put(stack, "fn", Eigen::VectorXd(solution.force.row(0)));
    named_.put(stack, "ft", Eigen::VectorXd(solution.force.row(1)));
    named_.put_integers(stack, "node", contact.own_vertex);
    named_.put(stack, "abscissa", contact.line.abscissa);
    named_.put_integers(stack, "state", state_numbers(solution.state));
    named_.put(stack, "violation", solution.complementarity);
    named_.put(stack, "status", static_cast<long>(solution.status));
    named_.put(stack, "history", Eigen::Map<const Eigen::VectorXd>(solution.history.data(), solution.history.size()));
    named_.put(stack, "open", counts.open);
    named_.put(stack, "stick", counts.stick);
    named_.put(stack, "slip", counts.slip);
  }

  void report(Stack stack, const ContactArguments& contact, const ContactSolution& solution, double seconds) const {
    const long level = named_.verbosity_level(stack);
    if (level < 1 || mpirank != 0) return;
    const Counts counts = counted(solution.state);
    cout << "contactsolve: " << 2 * contact.mesh.vertex_count() << " dofs, " << contact.line.node_count()
         << " contact nodes, " << solution.iterations << " iterations, " << counts.open << " open, " << counts.stick
         << " stick, " << counts.slip << " slip, " << in_words(solution.status) << ", " << seconds << " s" << endl;
    if (level > 1 && !solution.history.empty())
      cout << "contactsolve: " << solution.history.size()
           << " steps of the fixed point, last change of the normal multipliers " << solution.history.back() << endl;
    if (level > 1)
      cout << "contactsolve: violation " << solution.complementarity << ", residual " << solution.residual << endl;
  }

  NamedArguments named_;
  std::vector<Expression> mesh_, matrix_, load_, displacement_;
};

/// nodes outside = contactproject(Th, pn, pt, label=, friction=, multiplier=, g=, ...): pn and pt are projected in place; empty
/// arrays become zeros, one value a node.
class ContactProject : public E_F0mps {
 public:
  using Result = long;

  explicit ContactProject(const basicAC_F0& arguments)
      : named_(arguments, ContactArguments::table({{"multiplier", &typeid(string*)},
                                                   {"g", &typeid(KN<double>*)},
                                                   {"node", &typeid(KN<long>*)},
                                                   {"abscissa", &typeid(KN<double>*)},
                                                   {"verbosity", &typeid(long)}})),
        mesh_(to<pmesh>(arguments[0])),
        normal_(to<KN<double>*>(arguments[1])),
        tangential_(to<KN<double>*>(arguments[2])) {}

  static ArrayOfaType typeargs() { return ArrayOfaType(atype<pmesh>(), atype<KN<double>*>(), atype<KN<double>*>()); }
  static E_F0* f(const basicAC_F0& arguments) { return new ContactProject(arguments); }

  AnyType operator()(Stack stack) const override {
    return guarded("contactproject", [&] { return SetAny<long>(run(stack)); });
  }

 private:
  long run(Stack stack) const {
    const ContactArguments contact(stack, named_, {value_of<pmesh>(stack, mesh_)});
    ContactLaw law = contact.law;
    law.multiplier = multiplier_of(stack, named_);
    KN<double>*pn = GetAny<KN<double>*>((*normal_)(stack)), *pt = GetAny<KN<double>*>((*tangential_)(stack));
    const int nodes = contact.line.node_count();
    const Eigen::Matrix2Xd pressure =
        pn->N() == 0 && pt->N() == 0 ? Eigen::Matrix2Xd(Eigen::Matrix2Xd::Zero(2, nodes)) : contact.pressures(pn, pt);
    const Expression g = named_.expression("g");
    const Eigen::VectorXd given = g ? Eigen::VectorXd(vector_of(GetAny<KN<double>*>((*g)(stack)))) : Eigen::VectorXd();
    const MultiplierProjection projection = projected_multipliers(contact.line, law, pressure, given);

    pn->resize(nodes);
    pt->resize(nodes);
    vector_of(pn) = projection.pressure.row(0);
    vector_of(pt) = projection.pressure.row(1);
    named_.put_integers(stack, "node", contact.own_vertex);
    named_.put(stack, "abscissa", contact.line.abscissa);
    if (named_.verbosity_level(stack) > 0 && mpirank == 0)
      cout << "contactproject: " << nodes << " nodes, " << projection.outside << " were outside" << endl;
    return projection.outside;
  }

  NamedArguments named_;
  Expression mesh_, normal_, tangential_;
};

/// edges that (4.1) cannot mend = conecorrection(Th, pn, pt, label=, friction=, ...)
class ConeCorrectionFunction : public E_F0mps {
 public:
  using Result = long;

  explicit ConeCorrectionFunction(const basicAC_F0& arguments)
      : named_(arguments, ContactArguments::table({{"multiplier", &typeid(string*)},
                                                   {"A", &typeid(Matrice_Creuse<double>*)},
                                                   {"verbosity", &typeid(long)},
                                                   {"rn", &typeid(KN<double>*)},
                                                   {"rt", &typeid(KN<double>*)},
                                                   {"shift", &typeid(KN<double>*)},
                                                   {"corrected", &typeid(long*)},
                                                   {"cone", &typeid(double*)}})),
        mesh_(to<pmesh>(arguments[0])),
        normal_(to<KN<double>*>(arguments[1])),
        tangential_(to<KN<double>*>(arguments[2])) {}

  static ArrayOfaType typeargs() { return ArrayOfaType(atype<pmesh>(), atype<KN<double>*>(), atype<KN<double>*>()); }
  static E_F0* f(const basicAC_F0& arguments) { return new ConeCorrectionFunction(arguments); }

  AnyType operator()(Stack stack) const override {
    return guarded("conecorrection", [&] { return SetAny<long>(run(stack)); });
  }

 private:
  long run(Stack stack) const {
    const ContactArguments contact(stack, named_, {value_of<pmesh>(stack, mesh_)});
    const Eigen::Matrix2Xd given =
        contact.pressures(GetAny<KN<double>*>((*normal_)(stack)), GetAny<KN<double>*>((*tangential_)(stack)));
    const Eigen::Matrix2Xd density =
        multiplier_density(contact.line, multiplier_of(stack, named_), prescribed(stack, contact), given);
    const ConeCorrection correction = correct_to_cone(contact.line, contact.law, edge_densities(contact.line, density));
    const double cone = cone_defect(contact.line, contact.law, correction.densities);
    const auto unmended = static_cast<long>(correction.uncorrected.size());
    named_.put(stack, "rn", correction.densities.normal.reshaped());
    named_.put(stack, "rt", correction.densities.tangential.reshaped());
    named_.put(stack, "shift", correction.shift);
    named_.put(stack, "corrected", static_cast<long>(correction.corrected_count()));
    named_.put(stack, "cone", cone);
    if (named_.verbosity_level(stack) > 0 && mpirank == 0)
      cout << "conecorrection: " << contact.line.edge_count() << " edges, " << correction.corrected_count()
           << " corrected, " << unmended << " unmended, cone defect " << cone << endl;
    return unmended;
  }

  /// The prescribed dofs of A=, or none.
  std::vector<char> prescribed(Stack stack, const ContactArguments& contact) const {
    const Expression A = named_.expression("A");
    if (!A) return std::vector<char>(contact.dof_count(0), 0);
    const RowMatrix matrix = matrix_of(value_of<Matrice_Creuse<double>*>(stack, A));
    contact.require_dofs("A", 0, matrix.rows());
    return prescribed_dofs(matrix);
  }

  NamedArguments named_;
  Expression mesh_, normal_, tangential_;
};

}  // namespace

void register_contact_functions() {
  Global.Add("contactsolve", "(", new OneOperatorCode<ContactSolve<1>>());
  Global.Add("contactsolve", "(", new OneOperatorCode<ContactSolve<2>>());
  Global.Add("contactsolve", "(", new OneOperatorCode<ContactSolve<3>>());
  Global.Add("contactproject", "(", new OneOperatorCode<ContactProject>());
  Global.Add("conecorrection", "(", new OneOperatorCode<ConeCorrectionFunction>());
}

}  // namespace ffcontact::plugin
