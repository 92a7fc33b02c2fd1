// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/cone_correction.hpp"
#include "ffcontact/contact/contact_solution.hpp"
//
#include "contact_arguments.hpp"
#include "guard.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

Multiplier multiplier_named(const std::string& name) {
  if (name == "pressure") return Multiplier::pressure;
  if (name == "force") return Multiplier::force;
  refuse("multiplier must be \"pressure\" or \"force\", got \"", name, "\"");
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

/// iterations = contactsolve(Th, A, b, u, label=, friction=, ...)
class ContactSolve : public E_F0mps {
 public:
  using Result = long;

  explicit ContactSolve(const basicAC_F0& arguments)
      : named_(arguments, ContactArguments::table({{"multiplier", &typeid(string*)},
                                                   {"maxit", &typeid(long)},
                                                   {"tol", &typeid(double)},
                                                   {"verbosity", &typeid(long)},
                                                   {"pn", &typeid(KN<double>*)},
                                                   {"pt", &typeid(KN<double>*)},
                                                   {"fn", &typeid(KN<double>*)},
                                                   {"ft", &typeid(KN<double>*)},
                                                   {"node", &typeid(KN<long>*)},
                                                   {"abscissa", &typeid(KN<double>*)},
                                                   {"state", &typeid(KN<long>*)},
                                                   {"violation", &typeid(double*)},
                                                   {"open", &typeid(long*)},
                                                   {"stick", &typeid(long*)},
                                                   {"slip", &typeid(long*)}})),
        mesh_(to<pmesh>(arguments[0])),
        matrix_(to<Matrice_Creuse<double>*>(arguments[1])),
        load_(to<KN<double>*>(arguments[2])),
        displacement_(to<KN<double>*>(arguments[3])) {}

  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<pmesh>(), atype<Matrice_Creuse<double>*>(), atype<KN<double>*>(), atype<KN<double>*>());
  }
  static E_F0* f(const basicAC_F0& arguments) { return new ContactSolve(arguments); }

  AnyType operator()(Stack stack) const override {
    return guarded("contactsolve", [&] { return SetAny<long>(run(stack)); });
  }

 private:
  long run(Stack stack) const {
    const double start = CPUtime();
    const ContactArguments contact(stack, named_, GetAny<pmesh>((*mesh_)(stack)));
    KN<double>* u = GetAny<KN<double>*>((*displacement_)(stack));
    const RowMatrix A = matrix_of(GetAny<Matrice_Creuse<double>*>((*matrix_)(stack)));
    contact.require_dofs("A", A.rows());
    contact.require_dofs("u", u->N());

    ContactLaw law = contact.law;
    law.multiplier = multiplier_named(named_.text(stack, "multiplier", "force"));
    ContactSettings settings;
    settings.max_iterations = static_cast<int>(named_.integer(stack, "maxit", settings.max_iterations));
    settings.tolerance = named_.number(stack, "tol", settings.tolerance);
    if (!(settings.tolerance > 0)) refuse("tol must be positive, got ", settings.tolerance);

    const ElasticSystem system = elastic_system(A, vector_of(GetAny<KN<double>*>((*load_)(stack))));
    const ContactSolution solution = solve_contact(contact.mesh, contact.line, law, system, settings);
    if (!solution.accepted(settings))
      refuse("no solution after ", solution.iterations, " iterations (", in_words(solution.status),
             "), largest violation ", solution.complementarity, ", residual ", solution.residual);

    vector_of(u) = solution.displacement;
    put(stack, contact.line, solution);
    report(stack, contact, solution, CPUtime() - start);
    return solution.iterations;
  }

  void put(Stack stack, const ContactLine& line, const ContactSolution& solution) const {
    const Counts counts = counted(solution.state);
    named_.put(stack, "pn", Eigen::VectorXd(solution.pressure.row(0)));
    named_.put(stack, "pt", Eigen::VectorXd(solution.pressure.row(1)));
    named_.put(stack, "fn", Eigen::VectorXd(solution.force.row(0)));
    named_.put(stack, "ft", Eigen::VectorXd(solution.force.row(1)));
    named_.put_integers(stack, "node", {line.vertex.data(), line.vertex.data() + line.vertex.size()});
    named_.put(stack, "abscissa", line.abscissa);
    named_.put_integers(stack, "state", state_numbers(solution.state));
    named_.put(stack, "violation", solution.complementarity);
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
         << " stick, " << counts.slip << " slip, " << seconds << " s" << endl;
    if (level > 1)
      cout << "contactsolve: violation " << solution.complementarity << ", residual " << solution.residual << endl;
  }

  NamedArguments named_;
  Expression mesh_, matrix_, load_, displacement_;
};

/// edges that (4.1) cannot mend = conecorrection(Th, pn, pt, label=, friction=, ...)
class ConeCorrectionFunction : public E_F0mps {
 public:
  using Result = long;

  explicit ConeCorrectionFunction(const basicAC_F0& arguments)
      : named_(arguments, ContactArguments::table({{"verbosity", &typeid(long)},
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
    const ContactArguments contact(stack, named_, GetAny<pmesh>((*mesh_)(stack)));
    const Eigen::Matrix2Xd pressure = contact.pressures(GetAny<KN<double>*>((*normal_)(stack)),
                                                        GetAny<KN<double>*>((*tangential_)(stack)));
    const ConeCorrection correction = correct_to_cone(contact.line, contact.law, edge_densities(contact.line, pressure));
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

  NamedArguments named_;
  Expression mesh_, normal_, tangential_;
};

}  // namespace

void register_contact_functions() {
  Global.Add("contactsolve", "(", new OneOperatorCode<ContactSolve>());
  Global.Add("conecorrection", "(", new OneOperatorCode<ConeCorrectionFunction>());
}

}  // namespace ffcontact::plugin
