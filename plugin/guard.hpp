// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <new>
#include <string>

#include "freefem.hpp"

namespace ffcontact::plugin {

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
  } catch (const std::bad_alloc&) {
    sentence = "out of memory";
  } catch (const std::exception& error) {
    sentence = error.what();
  }
  ExecError(std::string(function) + ": " + sentence);
  std::terminate();  // ExecError throws
}

}  // namespace ffcontact::plugin
