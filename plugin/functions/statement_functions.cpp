// SPDX-License-Identifier: GPL-3.0-or-later
#include "freefem/guard.hpp"
#include "problem/contact_statement.hpp"
#include "problem/contact_type.hpp"
#include "registration.hpp"
#include "solids.hpp"

namespace ffcontact::plugin {

namespace {

ContactStatement stated(Stack stack, const NamedArguments& named,
                        const std::vector<pmesh>& meshes) {
  if (named.given("comm")) return solids().stated(stack, named, meshes);
  return {std::make_shared<ContactProblem<2>>(stack, named, meshes), nullptr,
          nullptr};
}

ContactStatement stated(Stack stack, const NamedArguments& named,
                        const std::vector<pmesh3>& meshes) {
  return solids().stated(stack, named, meshes);
}

/// The meshes and named parameters of a statement, from its first mesh on.
template <class MeshPointer>
class StatementArguments {
 public:
  StatementArguments(const basicAC_F0& arguments, int first_mesh)
      : named_(arguments, statement_table(arguments)) {
    for (int k = first_mesh; k < arguments.size(); ++k)
      meshes_.push_back(to<MeshPointer>(arguments[k]));
  }

  ContactStatement statement(Stack stack) const {
    return stated(stack, named_, values_of<MeshPointer>(stack, meshes_));
  }

 private:
  NamedArguments named_;
  std::vector<Expression> meshes_;
};

/// A new problem in a variable: the last states stay, to start from.
void state(ContactVariable* variable, ContactStatement statement) {
  Contact& contact = contact_of(*variable);
  contact.state(std::move(statement.plane));
  contact.shared = std::move(statement.shared);
  if (!statement.solid) {
    contact.solid = nullptr;
    return;
  }
  if (!contact.solid) contact.solid = std::make_shared<ContactOf<3>>();
  contact.solid->state(std::move(statement.solid));
}

/// contact C(Th, label=, friction=, ...);   contact C(T1, T2, label1=, label2=, friction=, ...);
template <class MeshPointer>
class StateContact : public E_F0mps {
 public:
  using Result = ContactVariable*;

  explicit StateContact(const basicAC_F0& arguments)
      : variable_(to<ContactVariable*>(arguments[0])),
        arguments_(arguments, 1) {}
  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<ContactVariable*>(), atype<MeshPointer>(), true);
  }
  static E_F0* f(const basicAC_F0& arguments) {
    return new StateContact(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("contact", [&] {
      auto* variable = value_of<ContactVariable*>(stack, variable_);
      variable->init();  // FreeFEM does it where nothing is stated
      state(variable, arguments_.statement(stack));
      return SetAny<ContactVariable*>(variable);
    });
  }

 private:
  Expression variable_;
  StatementArguments<MeshPointer> arguments_;
};

/// contact(Th, label=, ...), in C = contact(Th, label=, ...)
template <class MeshPointer>
class MakeStatement : public E_F0mps {
 public:
  using Result = ContactStatement*;

  explicit MakeStatement(const basicAC_F0& arguments)
      : arguments_(arguments, 0) {}
  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<MeshPointer>(), true);
  }
  static E_F0* f(const basicAC_F0& arguments) {
    return new MakeStatement(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("contact", [&] {
      return SetAny<ContactStatement*>(Add2StackOfPtr2Free(
          stack, new ContactStatement(arguments_.statement(stack))));
    });
  }

 private:
  StatementArguments<MeshPointer> arguments_;
};

ContactVariable* initialize(ContactVariable* const& variable,
                            ContactStatement* const& statement) {
  variable->init();
  state(variable, *statement);
  return variable;
}

ContactVariable* assign(ContactVariable* const& variable,
                        ContactStatement* const& statement) {
  state(variable, *statement);
  return variable;
}

}  // namespace

void register_contact_type() {
  Dcl_Type<ContactVariable*>(InitP<ContactVariable>, Destroy<ContactVariable>);
  Dcl_Type<ContactStatement*>();
  zzzfff->Add("contact", atype<ContactVariable*>());
  TheOperators->Add(
      "<-", new OneOperatorCode<StateContact<pmesh>>(),
      new OneOperatorCode<StateContact<pmesh3>>(),
      new OneOperator2_<ContactVariable*, ContactVariable*, ContactStatement*>(
          initialize));
  TheOperators->Add(
      "=",
      new OneOperator2_<ContactVariable*, ContactVariable*, ContactStatement*>(
          assign));
  atype<ContactVariable*>()->Add("<--", "(",
                                 new OneOperatorCode<MakeStatement<pmesh>>(),
                                 new OneOperatorCode<MakeStatement<pmesh3>>());
  register_contact_members();
}

}  // namespace ffcontact::plugin
