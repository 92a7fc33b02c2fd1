// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "ffcontact/base/require.hpp"
//
#include "contact_type.hpp"
#include "guard.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

using Problem = std::shared_ptr<ContactProblem>;

/// The value of contact(Th, ...), for an assignment.
struct ContactStatement {
  Problem problem;
};

/// The meshes and named parameters of a statement, from its first mesh on.
class StatementArguments {
 public:
  StatementArguments(const basicAC_F0& arguments, int first_mesh)
      : named_(arguments, ContactProblem::table(arguments)) {
    for (int k = first_mesh; k < arguments.size(); ++k)
      meshes_.push_back(to<pmesh>(arguments[k]));
  }

  Problem problem(Stack stack) const {
    return std::make_shared<ContactProblem>(stack, named_,
                                            values_of<pmesh>(stack, meshes_));
  }

 private:
  NamedArguments named_;
  std::vector<Expression> meshes_;
};

/// All contacts of the script by their numbers.
std::map<long, Contact>& contacts() {
  static std::map<long, Contact> all;
  return all;
}

/// A new problem in a variable: the last states stay, to start from.
void state(ContactVariable* variable, Problem problem) {
  Contact& contact = contact_of(*variable);
  contact.solved.reset();
  contact.problem = std::move(problem);
}

/// contact C(Th, label=, friction=, ...);   contact C(T1, T2, label1=, label2=, friction=, ...);
class StateContact : public E_F0mps {
 public:
  using Result = ContactVariable*;

  explicit StateContact(const basicAC_F0& arguments)
      : variable_(to<ContactVariable*>(arguments[0])),
        arguments_(arguments, 1) {}
  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<ContactVariable*>(), atype<pmesh>(), true);
  }
  static E_F0* f(const basicAC_F0& arguments) {
    return new StateContact(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("contact", [&] {
      auto* variable = value_of<ContactVariable*>(stack, variable_);
      variable->init();  // FreeFEM does it where nothing is stated
      state(variable, arguments_.problem(stack));
      return SetAny<ContactVariable*>(variable);
    });
  }

 private:
  Expression variable_;
  StatementArguments arguments_;
};

/// contact(Th, label=, ...), in C = contact(Th, label=, ...)
class MakeStatement : public E_F0mps {
 public:
  using Result = ContactStatement*;

  explicit MakeStatement(const basicAC_F0& arguments)
      : arguments_(arguments, 0) {}
  static ArrayOfaType typeargs() { return ArrayOfaType(atype<pmesh>(), true); }
  static E_F0* f(const basicAC_F0& arguments) {
    return new MakeStatement(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("contact", [&] {
      return SetAny<ContactStatement*>(Add2StackOfPtr2Free(
          stack, new ContactStatement{arguments_.problem(stack)}));
    });
  }

 private:
  StatementArguments arguments_;
};

ContactVariable* initialize(ContactVariable* const& variable,
                            ContactStatement* const& statement) {
  variable->init();
  state(variable, statement->problem);
  return variable;
}

ContactVariable* assign(ContactVariable* const& variable,
                        ContactStatement* const& statement) {
  state(variable, statement->problem);
  return variable;
}

const ContactProblem& problem_of(const Contact& contact) {
  if (!contact.problem)
    refuse("the contact is not stated: contact C(Th, label=, friction=)");
  return *contact.problem;
}

/// Arrays that members give are the script's own until the statement ends.
template <class Value, class Values>
KN<Value>* array_of(Stack stack, const Values& values) {
  auto* array = new KN<Value>(static_cast<long>(values.size()));
  std::copy(values.begin(), values.end(), static_cast<Value*>(*array));
  return Add2StackOfPtr2Free(stack, array);
}

template <VectorXd NodalResults::*values>
KN<double>* nodal_values(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    return array_of<double>(
        stack, solved_contact(contact_of(*variable)).nodes.*values);
  });
}

KN<long>* states(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    return array_of<long>(stack,
                          solved_contact(contact_of(*variable)).nodes.state);
  });
}

KN<long>* nodes(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    return array_of<long>(stack, problem_of(contact_of(*variable)).own_vertex);
  });
}

KN<double>* abscissae(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    return array_of<double>(stack, problem_of(contact_of(*variable)).abscissa);
  });
}

KN<long>* sides(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    return array_of<long>(stack, problem_of(contact_of(*variable)).side);
  });
}

template <class Result>
void add_member(const char* name,
                Result (*value)(Stack, ContactVariable* const&)) {
  Add<ContactVariable*>(name, ".",
                        new OneOperator1s_<Result, ContactVariable*>(value));
}

}  // namespace

void ContactVariable::init() {
  static long last = 0;
  number = ++last;
  contacts()[number];
}

void ContactVariable::destroy() const { contacts().erase(number); }

Contact& contact_of(const ContactVariable& variable) {
  const auto found = contacts().find(variable.number);
  if (found == contacts().end())
    refuse(
        "the contact is gone: a function that takes one must take contact & C");
  return found->second;
}

Contact& stated_contact(Stack stack, Expression variable) {
  Contact& contact = contact_of(*value_of<ContactVariable*>(stack, variable));
  problem_of(contact);
  return contact;
}

const SolvedContact& solved_contact(const Contact& contact) {
  if (!contact.solved)
    refuse("the contact is not solved: call contactsolve first");
  return *contact.solved;
}

void register_contact_type() {
  Dcl_Type<ContactVariable*>(InitP<ContactVariable>, Destroy<ContactVariable>);
  Dcl_Type<ContactStatement*>();
  zzzfff->Add("contact", atype<ContactVariable*>());
  TheOperators->Add(
      "<-", new OneOperatorCode<StateContact>(),
      new OneOperator2_<ContactVariable*, ContactVariable*, ContactStatement*>(
          initialize));
  TheOperators->Add(
      "=",
      new OneOperator2_<ContactVariable*, ContactVariable*, ContactStatement*>(
          assign));
  atype<ContactVariable*>()->Add("<--", "(",
                                 new OneOperatorCode<MakeStatement>());
  add_member("pn", nodal_values<&NodalResults::pn>);
  add_member("pt", nodal_values<&NodalResults::pt>);
  add_member("fn", nodal_values<&NodalResults::fn>);
  add_member("ft", nodal_values<&NodalResults::ft>);
  add_member("gap", nodal_values<&NodalResults::gap>);
  add_member("slip", nodal_values<&NodalResults::slip>);
  add_member("state", states);
  add_member("node", nodes);
  add_member("abscissa", abscissae);
  add_member("side", sides);
}

}  // namespace ffcontact::plugin
