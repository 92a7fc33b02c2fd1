// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/bounds_call.hpp"
#include "freefem/guard.hpp"
#include "problem/contact_type.hpp"
#include "registration.hpp"
#include "solids.hpp"

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
    {"goalforce", &typeid(E_Array)},     {"eps", &typeid(KN<double>*)}};

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
                               {"solves", &typeid(long*)},
                               {"estimates", &typeid(long*)},
                               {"steps", &typeid(long)},
                               {"turns", &typeid(long)},
                               {"sweeps", &typeid(long)},
                               {"coulomb", &typeid(bool)},
                               {"stick", &typeid(string*)},
                               {"verbosity", &typeid(long)}});
    return table;
  }

  double run(Stack stack) const {
    const Contact& contact = stated_contact_of_any(stack, contact_);
    const int bodies = contact.solid ? contact.solid->problem->body_count()
                                     : contact.problem->body_count();
    require_names_of_bodies(named_, quantities_of_bodies, bodies);
    const BoundsCall call{stack, named_, q_};
    return contact.solid ? solids().bounds(call, *contact.solid)
                         : plane_bounds(call, contact);
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
