// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/bounds/quantity_bounds.hpp"
//
#include "estimate/goal.hpp"
#include "estimate/judged.hpp"
#include "estimate/material_and_loads.hpp"
#include "freefem/guard.hpp"
#include "freefem/stopwatch.hpp"
#include "problem/systems.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// What is given for each body.
const NamedArguments::Table quantities_of_bodies = {
    {"lambda", &typeid(double)},         {"G", &typeid(double)},
    {"hooke", &typeid(E_Array)},         {"traction", &typeid(E_Array)},
    {"bodyforce", &typeid(E_Array)},     {"initialstrain", &typeid(E_Array)},
    {"initialstress", &typeid(E_Array)}, {"spring", &typeid(E_Array)},
    {"rest", &typeid(E_Array)},          {"goaltraction", &typeid(E_Array)},
    {"goalbodyforce", &typeid(E_Array)}, {"goalstress", &typeid(E_Array)},
    {"eps", &typeid(KN<double>*)}};

/// width = contactbounds(C, q, lambda=, G=, traction=, goaltraction=, lower=, upper=, ...):
/// strict bounds of a linear quantity of the solution that contactsolve found; q, one array
/// a body, may be left out.
class ContactBounds : public E_F0mps {
 public:
  using Result = double;

  explicit ContactBounds(const basicAC_F0& arguments)
      : named_(arguments, table(arguments)),
        contact_(to<ContactVariable*>(arguments[0])) {
    for (int k = 1; k < arguments.size(); ++k)
      q_.push_back(to<KN<double>*>(arguments[k]));
  }

  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<ContactVariable*>(), true);
  }
  static E_F0* f(const basicAC_F0& arguments) {
    return new ContactBounds(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("contactbounds", [&] { return SetAny<double>(run(stack)); });
  }

 private:
  static NamedArguments::Table table(const basicAC_F0& arguments) {
    NamedArguments::Table table = for_bodies(quantities_of_bodies, arguments);
    table.insert(table.end(), {{"goalconstant", &typeid(double)},
                               {"lower", &typeid(double*)},
                               {"upper", &typeid(double*)},
                               {"value", &typeid(double*)},
                               {"midpoint", &typeid(double*)},
                               {"step", &typeid(double*)},
                               {"steps", &typeid(long)},
                               {"turns", &typeid(long)},
                               {"sweeps", &typeid(long)},
                               {"verbosity", &typeid(long)}});
    return table;
  }

  int count(Stack stack, const char* name, int otherwise) const {
    return static_cast<int>(named_.integer(stack, name, otherwise));
  }
  BoundSettings settings(Stack stack) const {
    BoundSettings settings;
    settings.steps = count(stack, "steps", settings.steps);
    settings.turns = count(stack, "turns", settings.turns);
    settings.relaxation.steps =
        count(stack, "sweeps", *settings.relaxation.steps);
    return settings;
  }

  static void require_exact(const Oscillation& data, const SolvedBody<2>& body,
                            const Estimate<2>& first) {
    constexpr double rounding = 1e-9;
    const double forces = body.body_loads.cwiseAbs().sum(),
                 size =
                     first.relative > 0 ? first.e / first.relative : infinity;
    if (data.force > rounding * forces || data.strain > rounding * size)
      refuse(
          "bounds are strict for body forces that are constant in each "
          "triangle, and initial strains and stresses that are linear: give "
          "bodyforce= and the varf such ones");
  }

  Quantity<2> goal(Stack stack, const ContactProblem& problem,
                   const Hooke& hooke) const {
    Quantity<2> goal = read_goal(stack, named_, problem, hooke);
    if (q_.empty()) return goal;
    problem.require_bodies("q", q_.size());
    for (std::size_t k = 0; k < q_.size(); ++k)
      problem.require_dofs("q", static_cast<int>(k),
                           value_of<KN<double>*>(stack, q_[k])->N());
    require_goal(
        problem, goal,
        joined_displacement(problem, values_of<KN<double>*>(stack, q_)));
    return goal;
  }

  double run(Stack stack) const {
    const Stopwatch watch;
    const Contact& contact = stated_contact(stack, contact_);
    const ContactProblem& problem = plane_problem(contact);
    require_names_of_bodies(named_, quantities_of_bodies, problem.body_count());
    Judged judged = judged_of(solved_contact(contact));
    require_linear_tractions(stack, named_, problem);
    const Oscillation data =
        read_material_and_loads(stack, named_, problem, judged.body);
    const SolvedProblem<2> solved{problem.topology(), problem.line,
                                  *judged.system, judged.body};
    const Estimate<2> first = estimate_error<2>(solved.topology, solved.contact,
                                                solved.system, solved.body);
    require_exact(data, judged.body, first);
    const QuantityBounds bounds =
        quantity_bounds(solved, first, goal(stack, problem, judged.body.hooke),
                        settings(stack));
    put(stack, problem, bounds);
    if (reports(stack)) report(bounds, watch.seconds());
    return bounds.relative_width();
  }

  void put(Stack stack, const ContactProblem& problem,
           const QuantityBounds& bounds) const {
    const double midpoint = bounds.found() ? bounds.midpoint() : bounds.value;
    named_.put(stack, "lower", bounds.lower);
    named_.put(stack, "upper", bounds.upper);
    named_.put(stack, "value", bounds.value);
    named_.put(stack, "midpoint", midpoint);
    named_.put(stack, "step", bounds.step);
    VectorXd squares = VectorXd::Zero(problem.mesh.cell_count());
    if (bounds.found() && midpoint != 0)
      squares = bounds.local.cwiseMax(0) / std::abs(midpoint);
    put_by_bodies(stack, named_, problem.joined.first_cell, "eps",
                  squares.cwiseSqrt());
  }

  bool reports(Stack stack) const {
    return named_.verbosity_level(stack) >= 1 && mpirank == 0;
  }

  static void report(const QuantityBounds& bounds, double seconds) {
    cout << "contactbounds: ";
    if (bounds.found())
      cout << bounds.lower << " to " << bounds.upper << ", "
           << 100 * bounds.relative_width() << " % wide, u_h has "
           << bounds.value;
    else
      cout << "none, as " << bounds.reason;
    cout << ", " << seconds << " s" << endl;
  }

  NamedArguments named_;
  Expression contact_;
  std::vector<Expression> q_;
};

}  // namespace

void register_bounds_functions() {
  Global.Add("contactbounds", "(", new OneOperatorCode<ContactBounds>());
}

}  // namespace ffcontact::plugin
