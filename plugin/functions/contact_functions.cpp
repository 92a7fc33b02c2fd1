// SPDX-License-Identifier: GPL-3.0-or-later
#include <typeinfo>

#include "freefem/guard.hpp"
#include "registration.hpp"
#include "solids.hpp"
#include "solve/contact_solve.hpp"

namespace ffcontact::plugin {

namespace {

/// iterations = contactsolve(C, A, b, u, ...), with matrix, load and displacement of each
/// body.
class ContactSolve : public E_F0mps {
 public:
  using Result = long;

  explicit ContactSolve(const basicAC_F0& arguments)
      : named_(arguments, table()),
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
  static NamedArguments::Table table() {
    NamedArguments::Table table = {
        {"multiplier", &typeid(string*)},   {"solver", &typeid(string*)},
        {"maxit", &typeid(long)},           {"tol", &typeid(double)},
        {"initial", &typeid(KN_<long>)},    {"loadstep", &typeid(bool)},
        {"verbosity", &typeid(long)},       {"node", &typeid(KN<long>*)},
        {"abscissa", &typeid(KN<double>*)}, {"state", &typeid(KN<long>*)},
        {"violation", &typeid(double*)},    {"push", &typeid(E_Array)},
        {"moment", &typeid(double)},        {"about", &typeid(E_Array)},
        {"guide", &typeid(E_Array)},        {"tool", &typeid(KN<double>*)},
        {"status", &typeid(long*)},         {"history", &typeid(KN<double>*)},
        {"opennodes", &typeid(long*)},      {"sticknodes", &typeid(long*)},
        {"slipnodes", &typeid(long*)}};
    const std::type_info* const array = &typeid(KN<double>*);
    for (const char* name : all_nodal_names()) table.push_back({name, array});
    return table;
  }

  long run(Stack stack) const {
    const Stopwatch watch;
    Contact& contact = contact_of_processes(stack, contact_);
    const SolveCall call{stack,
                         named_,
                         matrix_,
                         load_,
                         values_of<KN<double>*>(stack, displacement_),
                         watch};
    return contact.shared || contact.solid ? solids().solve(call, contact)
                                           : solve_here<2>(call, contact);
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
