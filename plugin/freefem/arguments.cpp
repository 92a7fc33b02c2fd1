// SPDX-License-Identifier: GPL-3.0-or-later
#include "freefem/arguments.hpp"

#include <cstring>
#include <set>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"

namespace ffcontact::plugin {

namespace {

/// The number that a name has after that of a parameter; -1 if it is another name.
int number_after(const char* parameter, const char* name) {
  const std::size_t size = std::strlen(parameter);
  if (std::strncmp(parameter, name, size) != 0 || name[size] == 0) return -1;
  constexpr int most = 1000;
  const int number = whole_number(name + size).value_or(-1);
  return number <= most ? number : -1;
}

/// The same name as long as the plugin is loaded.
const char* kept(const std::string& name) {
  static std::set<std::string> names;
  return names.insert(name).first->c_str();
}

int integer_of(Stack stack, Expression expression) {
  return static_cast<int>(GetAny<long>((*expression)(stack)));
}

std::vector<int> integers_of(Stack stack, const E_Array& list) {
  std::vector<int> integers;
  for (int i = 0; i < list.size(); ++i)
    integers.push_back(integer_of(stack, CastTo<long>(list[i])));
  return integers;
}

std::vector<int> integers_of(const KN_<long>& array) {
  std::vector<int> integers;
  for (int i = 0; i < array.N(); ++i)
    integers.push_back(static_cast<int>(array[i]));
  return integers;
}

/// Values in an array of the script, which is resized.
template <class Value, class Values>
void fill(Stack stack, Expression target, const Values& values) {
  auto* array = GetAny<KN<Value>*>((*target)(stack));
  array->resize(static_cast<long>(values.size()));
  for (long k = 0; k < array->N(); ++k) (*array)[k] = values[k];
}

/// "a", "b" or "c", in quotation marks.
std::string quoted_list(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back('"' + word + '"');
  return listed(quoted, " or ");
}

}  // namespace

NamedArguments::NamedArguments(const basicAC_F0& arguments, Table table)
    : table_(std::move(table)),
      values_(table_.size(), nullptr),
      list_kind_(table_.size(), 'a') {
  Table adapted = table_;
  for (std::size_t k = 0; k < adapted.size(); ++k) {
    if (*adapted[k].type != typeid(KN_<long>)) continue;
    const C_F0 value = arguments.find(adapted[k].name);
    if (!value.LeftValue()) continue;
    if (value.left() == atype<E_Array>()) {
      list_kind_[k] = 'l';
      adapted[k].type = &typeid(E_Array);
    } else if (atype<long>()->CastingFrom(value.left())) {
      list_kind_[k] = 'i';
      adapted[k].type = &typeid(long);
    }
  }
  arguments.SetNameParam(count_of(adapted), adapted.data(), values_.data());
  for (std::size_t k = 0; k < table_.size(); ++k) {
    components_.emplace_back();
    if (!values_[k] || *table_[k].type != typeid(E_Array)) continue;
    const auto* list = dynamic_cast<const E_Array*>(values_[k]);
    for (int i = 0; list && i < list->size(); ++i)
      components_.back().push_back(CastTo<double>((*list)[i]));
  }
}

std::size_t NamedArguments::place(const std::string& name) const {
  for (std::size_t k = 0; k < table_.size(); ++k)
    if (name == table_[k].name) return k;
  return nowhere;
}

Expression NamedArguments::expression(const std::string& name) const {
  const std::size_t k = place(name);
  return k == nowhere ? nullptr : values_[k];
}

Expression NamedArguments::component(const std::string& name, int k,
                                     int size) const {
  if (!given(name)) return nullptr;
  const std::vector<Expression>& components = components_[place(name)];
  if (count_of(components) != size)
    refuse(name, " must be a list of ", size, " expressions");
  return components[k];
}

int NamedArguments::component_count(const std::string& name) const {
  return given(name) ? count_of(components_[place(name)]) : 0;
}

std::vector<int> NamedArguments::numbers_after(const char* name) const {
  std::vector<int> numbers;
  for (std::size_t k = 0; k < table_.size(); ++k)
    if (values_[k] && number_after(name, table_[k].name) >= 0)
      numbers.push_back(number_after(name, table_[k].name));
  return numbers;
}

double NamedArguments::number(Stack stack, const std::string& name,
                              double otherwise) const {
  const Expression value = expression(name);
  return value ? GetAny<double>((*value)(stack)) : otherwise;
}

long NamedArguments::integer(Stack stack, const std::string& name,
                             long otherwise) const {
  const Expression value = expression(name);
  return value ? GetAny<long>((*value)(stack)) : otherwise;
}

std::size_t NamedArguments::place_of_word(
    Stack stack, const std::string& name,
    const std::vector<std::string>& words) const {
  const std::string given = *value_of<string*>(stack, expression(name));
  const auto found = std::find(words.begin(), words.end(), given);
  if (found == words.end())
    refuse(name, " must be ", quoted_list(words), ", got \"", given, "\"");
  return found - words.begin();
}

bool NamedArguments::flag(Stack stack, const std::string& name) const {
  const Expression value = expression(name);
  return value && GetAny<bool>((*value)(stack));
}

std::vector<int> NamedArguments::integers(Stack stack,
                                          const std::string& name) const {
  if (!given(name)) return {};
  const std::size_t k = place(name);
  const Expression value = values_[k];
  if (list_kind_[k] == 'i') return {integer_of(stack, value)};
  if (list_kind_[k] == 'l')
    return integers_of(stack, dynamic_cast<const E_Array&>(*value));
  return integers_of(GetAny<KN_<long>>((*value)(stack)));
}

std::vector<std::vector<int>> NamedArguments::lists_of_integers(
    Stack stack, const std::string& name) const {
  if (!given(name)) return {};
  const std::size_t k = place(name);
  const auto* all = dynamic_cast<const E_Array*>(values_[k]);
  std::vector<std::vector<int>> lists;
  for (int i = 0; all && i < all->size(); ++i) {
    const C_F0 entry = (*all)[i];
    if (entry.left() != atype<E_Array>()) break;
    lists.push_back(
        integers_of(stack, dynamic_cast<const E_Array&>(*entry.LeftValue())));
  }
  if (!all || count_of(lists) < all->size())
    refuse(name, " must be a list of lists, as [[1, 2], [1, 3]]");
  return lists;
}

void NamedArguments::put(Stack stack, const std::string& name,
                         const Ref<const VectorXd>& values) const {
  const Expression target = expression(name);
  if (target && diverted_)
    diverted_->arrays[name] = values;
  else if (target)
    fill<double>(stack, target, values);
}

void NamedArguments::put_integers(Stack stack, const std::string& name,
                                  const std::vector<long>& values) const {
  const Expression target = expression(name);
  if (target && diverted_)
    diverted_->integers[name] = values;
  else if (target)
    fill<long>(stack, target, values);
}

void NamedArguments::put(Stack stack, const std::string& name,
                         double value) const {
  const Expression target = expression(name);
  if (target)
    (diverted_ ? diverted_->numbers[name]
               : *GetAny<double*>((*target)(stack))) = value;
}

void NamedArguments::put(Stack stack, const std::string& name,
                         long value) const {
  const Expression target = expression(name);
  if (target)
    (diverted_ ? diverted_->counts[name] : *GetAny<long*>((*target)(stack))) =
        value;
}

void NamedArguments::put(Stack stack, const std::string& name,
                         bool value) const {
  const Expression target = expression(name);
  if (target)
    (diverted_ ? diverted_->flags[name] : *GetAny<bool*>((*target)(stack))) =
        value;
}

void NamedArguments::put(Stack stack, const Outputs& outputs) const {
  for (const auto& [name, value] : outputs.arrays) put(stack, name, value);
  for (const auto& [name, value] : outputs.integers)
    put_integers(stack, name, value);
  for (const auto& [name, value] : outputs.numbers) put(stack, name, value);
  for (const auto& [name, value] : outputs.counts) put(stack, name, value);
  for (const auto& [name, value] : outputs.flags) put(stack, name, value);
}

NamedArguments::Key NamedArguments::key_of(Expression expression) const {
  for (std::size_t k = 0; k < values_.size(); ++k) {
    if (values_[k] == expression) return {static_cast<int>(k), -1};
    for (std::size_t c = 0; c < components_[k].size(); ++c)
      if (components_[k][c] == expression)
        return {static_cast<int>(k), static_cast<int>(c)};
  }
  throw std::logic_error("the expression is no parameter of the call");
}

Expression NamedArguments::expression_of(const Key& key) const {
  const bool known = key.parameter < count_of(values_) &&
                     key.component < count_of(components_[key.parameter]);
  if (!known)
    refuse(
        "another process calls it with more parameters: do all run the "
        "same script?");
  return key.component < 0 ? values_[key.parameter]
                           : components_[key.parameter][key.component];
}

void put_by_bodies(Stack stack, const NamedArguments& named,
                   const std::vector<int>& first_cell, const char* name,
                   const VectorXd& values) {
  const Index each = values.size() / first_cell.back();
  const int bodies = count_of(first_cell) - 1;
  for (int k = 0; k < bodies; ++k)
    named.put(stack, name_of_body(name, k, bodies),
              values.segment(each * first_cell[k],
                             each * (first_cell[k + 1] - first_cell[k])));
}

std::string name_of_body(const char* name, int body, int bodies) {
  return bodies == 1 ? name : name + std::to_string(body + 1);
}

NamedArguments::Table for_bodies(const NamedArguments::Table& parameters,
                                 const basicAC_F0& arguments) {
  NamedArguments::Table table;
  for (const auto& parameter : parameters) {
    int largest = 2;
    if (arguments.named_parameter)
      for (const auto& given : *arguments.named_parameter)
        largest = std::max(largest, number_after(parameter.name, given.first));
    table.push_back(parameter);
    for (int k = 0; k < largest; ++k)
      table.push_back(
          {kept(name_of_body(parameter.name, k, 2)), parameter.type});
  }
  return table;
}

void require_names_of_bodies(const NamedArguments& named,
                             const NamedArguments::Table& parameters,
                             int bodies) {
  for (const auto& parameter : parameters) {
    const std::string own = parameter.name;
    if (bodies > 1 && named.given(own))
      refuse(own, "= is given, but the contact has ", bodies, " bodies: give ",
             own, "1=, ", own, "2=, ...");
    for (int number : named.numbers_after(parameter.name))
      if (bodies == 1)
        refuse(own, number, "= is given, but the contact has one body: give ",
               own, "=");
      else if (number < 1 || number > bodies)
        refuse(own, number, "= is given, but the contact has ", bodies,
               " bodies");
  }
}

}  // namespace ffcontact::plugin
