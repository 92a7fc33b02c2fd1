// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <vector>

#include "freefem.hpp"

namespace ffcontact::plugin {

/// Positional arguments of these types, any number of them.
class ArgumentTypes : public ArrayOfaType {
 public:
  explicit ArgumentTypes(const std::vector<aType>& types) : ArrayOfaType(false) {
    n = static_cast<int>(types.size());
    t = new aType[n];  // deleted by the base
    std::copy(types.begin(), types.end(), t);
  }
};

template <class T>
T value_of(Stack stack, Expression expression) {
  return GetAny<T>((*expression)(stack));
}

/// The values of several expressions, as T or as what it converts to.
template <class T, class As = T>
std::vector<As> values_of(Stack stack, const std::vector<Expression>& expressions) {
  std::vector<As> values;
  for (Expression expression : expressions) values.push_back(value_of<T>(stack, expression));
  return values;
}

/// The named parameters of one call of a script function, decoded by name.
///
/// A table names the parameters and their FreeFEM types. A parameter of type KN_<long> also takes one integer or a literal list
/// [1, 2]. Expressions are kept unevaluated, so that they can be taken at points of the mesh.
class NamedArguments {
 public:
  using Table = std::vector<basicAC_F0::name_and_type>;

  /// Runs when the script is parsed.
  NamedArguments(const basicAC_F0& arguments, Table table);

  bool given(const char* name) const { return expression(name) != nullptr; }
  Expression expression(const char* name) const { return values_[place(name)]; }
  /// Component of a literal list like [fx, fy], or null where the parameter is not given.
  /// @throws CompileError  if the list has not `size` components
  Expression component(const char* name, int k, int size) const;

  double number(Stack stack, const char* name, double otherwise) const;
  long integer(Stack stack, const char* name, long otherwise) const;
  std::string text(Stack stack, const char* name, const char* otherwise) const;
  std::vector<int> integers(Stack stack, const char* name) const;
  long verbosity_level(Stack stack) const { return integer(stack, "verbosity", verbosity); }

  /// Outputs: written where the script asked for them, otherwise dropped. Arrays are resized.
  void put(Stack stack, const char* name, const Eigen::Ref<const Eigen::VectorXd>& values) const;
  void put_integers(Stack stack, const char* name, const std::vector<long>& values) const;
  void put(Stack stack, const char* name, double value) const;
  void put(Stack stack, const char* name, long value) const;
  void put(Stack stack, const char* name, bool value) const;

 private:
  std::size_t place(const char* name) const;

  Table table_;
  std::vector<Expression> values_;
  std::vector<std::vector<Expression>> components_;  ///< of literal lists of expressions
  std::vector<char> list_kind_;  ///< 'a' array, 'l' literal list, 'i' one integer, for parameters of type KN_<long>
};

}  // namespace ffcontact::plugin
