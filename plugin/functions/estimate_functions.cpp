// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
//
#include "estimate/contact_error.hpp"
#include "estimate/material_and_loads.hpp"
#include "freefem/guard.hpp"
#include "parallel/shared_contact.hpp"
#include "problem/systems.hpp"
#include "registration.hpp"
#include "solids.hpp"

namespace ffcontact::plugin {

namespace {

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
    Contact& contact = contact_of_processes(stack, contact_);
    if (contact.shared)
      require_own_solution(
          "one of several processes, which contacterror judges by what "
          "contactsolve found: contacterror(C, lambda=, G=, ...)");
    else if (contact.solid)
      require_own_solution(
          "that of a mesh3, which contacterror judges by what contactsolve "
          "found: contacterror(C, lambda=, G=, ...)");
    require_names_of_bodies(named_, estimates_of_bodies, body_count(contact));
    const JudgePlane judge = [&](const ReadBodies<2>& read) {
      return plane_run(stack, contact, read);
    };
    return contact.shared || contact.solid
               ? solids().error(stack, named_, contact, judge)
               : judge(reader_of<2>(stack, named_));
  }

  static int body_count(const Contact& contact) {
    if (contact.shared) return contact.shared->body_count();
    return contact.problem ? contact.problem->body_count()
                           : contact.solid->problem->body_count();
  }

  void require_own_solution(const char* kind) const {
    if (!matrix_.empty()) refuse("the contact is ", kind);
  }

  double plane_run(Stack stack, ContactOf<2>& contact,
                   const ReadBodies<2>& read) const {
    if (matrix_.empty()) {
      require_no_multiplier();
      return contact_error<2>(stack, named_, contact, read);
    }
    return contact_error<2>(
               stack, named_, *contact.problem,
               [&] { return given_solution(stack, *contact.problem); }, read)
        .estimate.relative;
  }

  void require_no_multiplier() const {
    if (named_.given("multiplier"))
      refuse(
          "multiplier= is given, but pn and pt are not: it is known from "
          "contactsolve");
  }

  Judged<2> given_solution(Stack stack,
                           const ContactProblem<2>& problem) const {
    problem.require_bodies("A, u", matrix_.size());
    std::vector<ElasticSystem> systems;
    for (int k = 0; k < problem.body_count(); ++k) {
      RowMatrix A = matrix_of_body(stack, problem, k, matrix_[k], problem.mesh);
      const VectorXd none = VectorXd::Zero(A.rows());
      systems.push_back(elastic_system(std::move(A), none));
    }
    const Matrix2Xd pressures =
        pressures_of(problem, value_of<KN<double>*>(stack, normal_),
                     value_of<KN<double>*>(stack, tangential_));
    Judged<2> judged =
        judged_of(problem, joined(std::move(systems)),
                  joined_displacement(
                      problem, values_of<KN<double>*>(stack, displacement_)),
                  multiplier_of(stack, named_), pressures);
    // for the estimate, too
    if (wants_bound(named_)) factorise(problem.contact, judged);
    return judged;
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
