// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <stdexcept>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Messages between processes that work together, numbered from 0.
class Messages {
 public:
  using Bytes = std::vector<char>;

  virtual ~Messages() = default;
  virtual int rank() const = 0;
  virtual int count() const = 0;
  /// May wait until the other one receives.
  virtual void send(int rank, const Bytes& bytes) const = 0;
  virtual Bytes receive(int rank) const = 0;
};

/// A dense matrix of numbers.
template <class Numbers>
void send_numbers(const Messages& messages, int rank, const Numbers& numbers) {
  using Number = typename Numbers::Scalar;
  Messages::Bytes bytes(sizeof(Number) * numbers.size());
  if (numbers.size() > 0)
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
  messages.send(rank, bytes);
}

/// @param numbers  of the size that they are sent with
template <class Numbers>
void receive_numbers(const Messages& messages, int rank, Numbers& numbers) {
  const Messages::Bytes bytes = messages.receive(rank);
  if (bytes.size() != sizeof(typename Numbers::Scalar) * numbers.size())
    throw std::logic_error("a message between processes has another size");
  if (numbers.size() > 0)
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
}

}  // namespace ffcontact
