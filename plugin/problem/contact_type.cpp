// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/contact_type.hpp"

#include <map>

#include "ffcontact/base/require.hpp"
//
#include "freefem/arguments.hpp"

namespace ffcontact::plugin {

namespace {

/// All contacts of the script by their numbers.
std::map<long, Contact>& contacts() {
  static std::map<long, Contact> all;
  return all;
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

Contact& contact_of_processes(Stack stack, Expression variable) {
  Contact& contact = contact_of(*value_of<ContactVariable*>(stack, variable));
  require_stated(contact);
  return contact;
}

Contact& stated_contact_of_any(Stack stack, Expression variable) {
  Contact& contact = contact_of_processes(stack, variable);
  if (contact.shared)
    refuse(
        "the contact is one of several processes (comm=), but this is for one "
        "so far");
  return contact;
}

Contact& stated_contact(Stack stack, Expression variable) {
  Contact& contact = stated_contact_of_any(stack, variable);
  plane_problem(contact);
  return contact;
}

void require_stated(const Contact& contact) {
  if (!contact.problem && !contact.solid && !contact.shared)
    refuse("the contact is not stated: contact C(Th, label=, friction=)");
}

const ContactProblem<2>& plane_problem(const Contact& contact) {
  if (contact.solid)
    refuse(
        "the contact is that of a mesh3, but this is for plane bodies so far");
  require_stated(contact);
  return *contact.problem;
}

}  // namespace ffcontact::plugin
