// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/judged.hpp"
#include "freefem/guard.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// mu = criticalfriction(C, unique=): the smallest coefficient at which the solution that
/// contactsolve found is not the only one near it, and that below which it is.
class CriticalFriction : public E_F0mps {
 public:
  using Result = double;

  explicit CriticalFriction(const basicAC_F0& arguments)
      : named_(arguments, {{"stick", &typeid(string*)},
                           {"unique", &typeid(double*)},
                           {"verbosity", &typeid(long)}}),
        contact_(to<ContactVariable*>(arguments[0])) {}

  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<ContactVariable*>());
  }
  static E_F0* f(const basicAC_F0& arguments) {
    return new CriticalFriction(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("criticalfriction",
                   [&] { return SetAny<double>(run(stack)); });
  }

 private:
  double run(Stack stack) const {
    const Contact& contact = stated_contact(stack, contact_);
    const SolvedContact<2>& solved = solved_contact<2>(contact);
    const StuckNodes stuck = stuck_nodes_of(stack, named_);
    const double critical = critical_friction_of(*contact.problem, solved);
    const bool reports = named_.verbosity_level(stack) >= 1 && mpirank == 0;
    if (!reports && !named_.given("unique")) return critical;
    const CoulombConstant constant =
        coulomb_constant_of(contact.problem->contact, judged_of(solved), stuck);
    const double unique = 1 / constant.kappa;
    named_.put(stack, "unique", unique);
    if (reports)
      cout << "criticalfriction: mu " << constant.friction << ", unique below "
           << unique << " (" << stuck_in_words(stuck) << "), not unique at "
           << critical << (unique < critical ? ", unknown between" : "")
           << endl;
    return critical;
  }

  NamedArguments named_;
  Expression contact_;
};

}  // namespace

void register_uniqueness_functions() {
  Global.Add("criticalfriction", "(", new OneOperatorCode<CriticalFriction>());
}

}  // namespace ffcontact::plugin
