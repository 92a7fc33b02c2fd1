// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.hpp"

#include <cassert>
#include <cstring>

namespace ffcontact::plugin {

NamedArguments::NamedArguments(const basicAC_F0& arguments, Table table)
    : table_(std::move(table)), values_(table_.size(), nullptr), list_kind_(table_.size(), 'a') {
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
  arguments.SetNameParam(static_cast<int>(adapted.size()), adapted.data(), values_.data());
  for (std::size_t k = 0; k < table_.size(); ++k) {
    components_.emplace_back();
    if (!values_[k] || *table_[k].type != typeid(E_Array)) continue;
    const auto* list = dynamic_cast<const E_Array*>(values_[k]);
    for (int i = 0; list && i < list->size(); ++i) components_.back().push_back(CastTo<double>((*list)[i]));
  }
}

std::size_t NamedArguments::place(const char* name) const {
  for (std::size_t k = 0; k < table_.size(); ++k)
    if (std::strcmp(table_[k].name, name) == 0) return k;
  assert(false && "a parameter that the table does not name");
  return 0;
}

Expression NamedArguments::component(const char* name, int k, int size) const {
  if (!given(name)) return nullptr;
  const std::vector<Expression>& components = components_[place(name)];
  if (static_cast<int>(components.size()) != size)
    CompileError(std::string(name) + " must be a list of " + std::to_string(size) + " expressions");
  return components[k];
}

double NamedArguments::number(Stack stack, const char* name, double otherwise) const {
  const Expression value = expression(name);
  return value ? GetAny<double>((*value)(stack)) : otherwise;
}

long NamedArguments::integer(Stack stack, const char* name, long otherwise) const {
  const Expression value = expression(name);
  return value ? GetAny<long>((*value)(stack)) : otherwise;
}

std::string NamedArguments::text(Stack stack, const char* name, const char* otherwise) const {
  const Expression value = expression(name);
  return value ? *GetAny<string*>((*value)(stack)) : otherwise;
}

std::vector<int> NamedArguments::integers(Stack stack, const char* name) const {
  const std::size_t k = place(name);
  const Expression value = values_[k];
  std::vector<int> result;
  if (!value) return result;
  if (list_kind_[k] == 'i') {
    result.push_back(static_cast<int>(GetAny<long>((*value)(stack))));
  } else if (list_kind_[k] == 'l') {
    const auto* list = dynamic_cast<const E_Array*>(value);
    for (int i = 0; i < list->size(); ++i)
      result.push_back(static_cast<int>(GetAny<long>((*CastTo<long>((*list)[i]))(stack))));
  } else {
    const KN_<long> array = GetAny<KN_<long>>((*value)(stack));
    for (int i = 0; i < array.N(); ++i) result.push_back(static_cast<int>(array[i]));
  }
  return result;
}

void NamedArguments::put(Stack stack, const char* name, const Eigen::Ref<const Eigen::VectorXd>& values) const {
  const Expression target = expression(name);
  if (!target) return;
  KN<double>* array = GetAny<KN<double>*>((*target)(stack));
  array->resize(static_cast<long>(values.size()));
  for (long k = 0; k < array->N(); ++k) (*array)[k] = values[k];
}

void NamedArguments::put_integers(Stack stack, const char* name, const std::vector<long>& values) const {
  const Expression target = expression(name);
  if (!target) return;
  KN<long>* array = GetAny<KN<long>*>((*target)(stack));
  array->resize(static_cast<long>(values.size()));
  for (long k = 0; k < array->N(); ++k) (*array)[k] = values[k];
}

void NamedArguments::put(Stack stack, const char* name, double value) const {
  if (const Expression target = expression(name)) *GetAny<double*>((*target)(stack)) = value;
}

void NamedArguments::put(Stack stack, const char* name, long value) const {
  if (const Expression target = expression(name)) *GetAny<long*>((*target)(stack)) = value;
}

void NamedArguments::put(Stack stack, const char* name, bool value) const {
  if (const Expression target = expression(name)) *GetAny<bool*>((*target)(stack)) = value;
}

}  // namespace ffcontact::plugin
