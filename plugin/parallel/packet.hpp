// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// Values on their way to another process, which takes them out in the order in which
/// they were put in.
class Packet {
 public:
  using Bytes = std::vector<char>;

  Packet() = default;
  explicit Packet(Bytes bytes) : bytes_(std::move(bytes)) {}
  const Bytes& bytes() const { return bytes_; }

  template <class Value>
  Packet& put(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    append(&value, sizeof value);
    return *this;
  }
  template <class Value>
  Packet& put(const std::vector<Value>& values) {
    return put_all(values.data(), values.size());
  }
  Packet& put(const std::string& text) {
    return put_all(text.data(), text.size());
  }
  template <class Number, int rows, int columns>
  Packet& put(const Matrix<Number, rows, columns>& matrix) {
    return put_dense(matrix);
  }
  template <class Number, int rows, int columns>
  Packet& put(const Eigen::Array<Number, rows, columns>& array) {
    return put_dense(array);
  }
  Packet& put(const std::vector<std::vector<int>>& lists) {
    put(lists.size());
    for (const std::vector<int>& list : lists) put(list);
    return *this;
  }
  template <class Value>
  Packet& put(const std::map<std::string, Value>& values) {
    put(values.size());
    for (const auto& [name, value] : values) put(name).put(value);
    return *this;
  }

  /// All of another packet, behind what there is.
  Packet& put_packet(const Packet& other) {
    append(other.bytes_.data(), other.bytes_.size());
    return *this;
  }

  template <class Value>
  Value take() {
    Value value;
    take(value);
    return value;
  }
  template <class Value>
  Packet& take_to(Value& value) {
    take(value);
    return *this;
  }

 private:
  void append(const void* data, std::size_t size) {
    const std::size_t before = bytes_.size();
    bytes_.resize(before + size);
    if (size > 0) std::memcpy(bytes_.data() + before, data, size);
  }
  template <class Dense>
  Packet& put_dense(const Dense& dense) {
    put(dense.rows()).put(dense.cols());
    return put_all(dense.data(), static_cast<std::size_t>(dense.size()));
  }
  template <class Value>
  Packet& put_all(const Value* values, std::size_t count) {
    put(count);
    append(values, count * sizeof(Value));
    return *this;
  }

  void cut(void* data, std::size_t size) {
    if (bytes_.size() - taken_ < size)
      throw std::logic_error("a message between processes is too short");
    if (size > 0) std::memcpy(data, bytes_.data() + taken_, size);
    taken_ += size;
  }
  template <class Value>
  void take(Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    cut(&value, sizeof value);
  }
  template <class Value>
  void take(std::vector<Value>& values) {
    values.resize(take<std::size_t>());
    cut(values.data(), values.size() * sizeof(Value));
  }
  void take(std::string& text) {
    text.resize(take<std::size_t>());
    cut(text.data(), text.size());
  }
  void take(std::vector<std::vector<int>>& lists) {
    lists.resize(take<std::size_t>());
    for (std::vector<int>& list : lists) take(list);
  }
  template <class Number, int rows, int columns>
  void take(Matrix<Number, rows, columns>& matrix) {
    take_dense(matrix);
  }
  template <class Number, int rows, int columns>
  void take(Eigen::Array<Number, rows, columns>& array) {
    take_dense(array);
  }
  template <class Dense>
  void take_dense(Dense& dense) {
    const auto rows = take<Index>(), columns = take<Index>();
    dense.resize(rows, columns);
    cut(dense.data(), take<std::size_t>() * sizeof(typename Dense::Scalar));
  }
  template <class Value>
  void take(std::map<std::string, Value>& values) {
    for (auto left = take<std::size_t>(); left > 0; --left) {
      const auto name = take<std::string>();
      values[name] = take<Value>();
    }
  }

  Bytes bytes_;
  std::size_t taken_ = 0;
};

}  // namespace ffcontact::plugin
