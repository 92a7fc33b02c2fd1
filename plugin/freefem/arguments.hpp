// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "freefem/freefem.hpp"
#include "freefem/outputs.hpp"

namespace ffcontact::plugin {

template <class T>
T value_of(Stack stack, Expression expression) {
  return GetAny<T>((*expression)(stack));
}

/// The values of several expressions.
template <class T>
std::vector<T> values_of(Stack stack,
                         const std::vector<Expression>& expressions) {
  std::vector<T> values;
  for (Expression expression : expressions)
    values.push_back(value_of<T>(stack, expression));
  return values;
}

/// The named parameters of one call of a script function, decoded by name.
///
/// A table names the parameters and their FreeFEM types. A parameter of type KN_<long>
/// also takes one integer or a literal list [1, 2]. Expressions are kept unevaluated, so
/// that they can be taken at points of the mesh.
class NamedArguments {
 public:
  using Table = std::vector<basicAC_F0::name_and_type>;

  /// Runs when the script is parsed.
  NamedArguments(const basicAC_F0& arguments, Table table);

  bool given(const std::string& name) const {
    return expression(name) != nullptr;
  }
  /// Null where the parameter is not given.
  Expression expression(const std::string& name) const;
  /// Component of a literal list like [fx, fy], or null where the parameter is not given.
  /// @throws std::invalid_argument  if the list has not `size` components
  Expression component(const std::string& name, int k, int size) const;

  /// How many components a literal list has, 0 where the parameter is not given.
  int component_count(const std::string& name) const;

  /// The k of the given parameters that are called name followed by k.
  std::vector<int> numbers_after(const char* name) const;
  /// Is a parameter given that there may be one of for each body?
  bool given_of_bodies(const char* name) const {
    return given(name) || !numbers_after(name).empty();
  }

  double number(Stack stack, const std::string& name, double otherwise) const;
  long integer(Stack stack, const std::string& name, long otherwise) const;
  /// What the word that the script gives stands for.
  /// @throws std::invalid_argument  listing the words, if it is none of them
  template <class T>
  T choice(Stack stack, const std::string& name, T otherwise,
           const std::vector<std::pair<std::string, T>>& words) const {
    if (!given(name)) return otherwise;
    std::vector<std::string> known;
    for (const auto& [word, meaning] : words) known.push_back(word);
    return words[place_of_word(stack, name, known)].second;
  }
  std::vector<int> integers(Stack stack, const std::string& name) const;
  /// Of a literal list of lists, [[1, 2], [1, 3]].
  /// @throws std::invalid_argument  if it is none
  std::vector<std::vector<int>> lists_of_integers(
      Stack stack, const std::string& name) const;
  bool flag(Stack stack, const std::string& name) const;
  long verbosity_level(Stack stack) const {
    return integer(stack, "verbosity", verbosity);
  }

  /// A parameter or a component of one, as another process that runs the same script
  /// knows it.
  struct Key {
    int parameter, component;  ///< -1: the parameter itself
  };
  /// @param expression  one that this gave
  Key key_of(Expression expression) const;
  Expression expression_of(const Key& key) const;

  /// While it lives the outputs of a call go to it instead of the script.
  class Diverted : public Outputs {
   public:
    explicit Diverted(const NamedArguments& named) : named_(named) {
      named_.diverted_ = this;
    }
    ~Diverted() { named_.diverted_ = nullptr; }
    Diverted(const Diverted&) = delete;
    Diverted& operator=(const Diverted&) = delete;

   private:
    const NamedArguments& named_;
  };
  void put(Stack stack, const Outputs& outputs) const;

  /// Outputs: written where the script asked for them, otherwise dropped. Arrays are
  /// resized.
  void put(Stack stack, const std::string& name,
           const Ref<const VectorXd>& values) const;
  void put_integers(Stack stack, const std::string& name,
                    const std::vector<long>& values) const;
  void put(Stack stack, const std::string& name, double value) const;
  void put(Stack stack, const std::string& name, long value) const;
  void put(Stack stack, const std::string& name, bool value) const;

 private:
  std::size_t place_of_word(Stack stack, const std::string& name,
                            const std::vector<std::string>& words) const;

  static constexpr std::size_t nowhere = -1;
  std::size_t place(const std::string& name) const;

  Table table_;
  mutable Outputs* diverted_ = nullptr;
  std::vector<Expression> values_;
  std::vector<std::vector<Expression>>
      components_;  ///< of literal lists of expressions
  /// 'a' array, 'l' literal list, 'i' one integer, for parameters of type KN_<long>
  Flags list_kind_;
};

/// The name of a parameter that each body has: itself where there is one body, otherwise
/// followed by the body's number from 1.
std::string name_of_body(const char* name, int body, int bodies);

/// Puts what is one array for the joined bodies into name= of one body, name1=, name2=,
/// ... of several.
/// @param first_cell  of each body, and the end (JoinedMesh)
/// @param values      the same number of each cell
void put_by_bodies(Stack stack, const NamedArguments& named,
                   const std::vector<int>& first_cell, const char* name,
                   const VectorXd& values);

/// Rows for parameters that each body has, for one body and for as many as the call
/// names: the number of bodies is not known yet when the script is parsed.
NamedArguments::Table for_bodies(const NamedArguments::Table& parameters,
                                 const basicAC_F0& arguments);

/// @throws std::invalid_argument  if such a parameter is given without its number, or
///                                with the number of no body
void require_names_of_bodies(const NamedArguments& named,
                             const NamedArguments::Table& parameters,
                             int bodies);

}  // namespace ffcontact::plugin
