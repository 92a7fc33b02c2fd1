// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>

#include "ffcontact/base/require.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

/// The sentence that a script stops with: FreeFEM's own, or ours.
inline std::string sentence_for_script(const std::exception& error) {
  return dynamic_cast<const Error*>(&error) ? error.what() : sentence_of(error);
}

/// Runs the body of a script function; what it throws becomes FreeFEM's ExecError, one
/// sentence "function: what", exit code 8. FreeFEM loses the message of any other
/// exception.
template <class Body>
auto guarded(const char* function, Body&& body) -> decltype(body()) {
  std::string sentence;
  try {
    return body();
  } catch (Error&) {  // FreeFEM's own, raised while an argument was evaluated
    throw;
  } catch (const std::exception& error) {
    sentence = sentence_of(error);
  }
  ExecError(std::string(function) + ": " + sentence);
  std::terminate();  // ExecError throws
}

}  // namespace ffcontact::plugin
