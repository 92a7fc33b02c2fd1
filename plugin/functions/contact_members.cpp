// SPDX-License-Identifier: GPL-3.0-or-later
// What the script reads of a contact: C.pn, C.node, ...
#include <algorithm>
#include <utility>

#include "freefem/guard.hpp"
#include "parallel/shared_contact.hpp"
#include "problem/contact_type.hpp"
#include "problem/result_names.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// Arrays that members give are the script's own until the statement ends.
template <class Value, class Values>
KN<Value>* array_of(Stack stack, const Values& values) {
  auto* array = new KN<Value>(static_cast<long>(values.size()));
  std::copy(values.begin(), values.end(), static_cast<Value*>(*array));
  return Add2StackOfPtr2Free(stack, array);
}

const Contact& stated_contact_of(const ContactVariable& variable) {
  const Contact& contact = contact_of(variable);
  require_stated(contact);
  return contact;
}

bool is_solid(const Contact& contact) {
  return contact.solid || (contact.shared && contact.shared->solid);
}

const NodalResults& results_of(const Contact& contact) {
  if (contact.shared) {
    if (!contact.shared->shown.solved) refuse_unsolved();
    return *contact.shared->shown.solved;
  }
  return contact.solid ? solved_contact(*contact.solid).nodes
                       : solved_contact<2>(contact).nodes;
}

template <std::size_t k>
KN<double>* nodal_values(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    const Contact& contact = stated_contact_of(*variable);
    const int dimension = is_solid(contact) ? 3 : 2,
              column = nodal_column(dimension, all_nodal_names()[k]);
    if (column < 0) refuse_result_of_others(dimension);
    return array_of<double>(stack, results_of(contact).values.col(column));
  });
}

KN<long>* states(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    return array_of<long>(stack,
                          results_of(stated_contact_of(*variable)).state);
  });
}

/// One column a node.
MatrixXd normals_of(const Contact& contact) {
  if (contact.shared) return contact.shared->shown.normal;
  return contact.solid ? MatrixXd(contact.solid->problem->own_normals())
                       : MatrixXd(contact.problem->own_normals());
}

template <int component>
KN<double>* normals(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    const Contact& contact = stated_contact_of(*variable);
    if (component == 2 && !is_solid(contact)) refuse_result_of_others(2);
    const VectorXd values = normals_of(contact).row(component);
    return array_of<double>(stack, values);
  });
}

KN<double>* abscissae(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    const Contact& contact = stated_contact_of(*variable);
    if (is_solid(contact)) refuse_result_of_others(3);
    return array_of<double>(stack, contact.shared
                                       ? contact.shared->shown.abscissa
                                       : contact.problem->abscissa);
  });
}

/// Numbers that plane bodies and solids have, and what a process shows of them.
template <auto shown, auto plane, auto solid>
KN<long>* numbers(Stack stack, ContactVariable* const& variable) {
  return guarded("contact", [&] {
    const Contact& contact = stated_contact_of(*variable);
    if (contact.shared)
      return array_of<long>(stack, contact.shared->shown.*shown);
    return array_of<long>(stack, contact.problem
                                     ? *contact.problem.*plane
                                     : *contact.solid->problem.*solid);
  });
}

template <class Result>
void add_member(const char* name,
                Result (*value)(Stack, ContactVariable* const&)) {
  Add<ContactVariable*>(name, ".",
                        new OneOperator1s_<Result, ContactVariable*>(value));
}

template <std::size_t... k>
void add_nodal_values(std::index_sequence<k...>) {
  (add_member(all_nodal_names()[k], nodal_values<k>), ...);
}

}  // namespace

void register_contact_members() {
  add_nodal_values(std::make_index_sequence<nodal_names<3>.size() + 3>());
  add_member("nx", normals<0>);
  add_member("ny", normals<1>);
  add_member("nz", normals<2>);
  add_member("state", states);
  add_member("node",
             numbers<&ShownNodes::own_vertex, &ContactProblem<2>::own_vertex,
                     &ContactProblem<3>::own_vertex>);
  add_member("abscissa", abscissae);
  add_member("first",
             numbers<&ShownNodes::first_node, &ContactProblem<2>::first_node,
                     &ContactProblem<3>::first_node>);
  add_member("side", numbers<&ShownNodes::side, &ContactProblem<2>::side,
                             &ContactProblem<3>::side>);
}

}  // namespace ffcontact::plugin
