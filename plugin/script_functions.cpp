// SPDX-License-Identifier: GPL-3.0-or-later
// What FreeFEM's language lacks for ffcontact.idp and its examples.
#include <chrono>

#include "freefem.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// contactstop("function: what was wrong") stops the script with that sentence, exit code
/// 8.
long contactstop(string* const& sentence) {
  ExecError(sentence->c_str());
  return 0;
}

/// Seconds on a wall clock, with fractions: FreeFEM's time() counts whole seconds, its
/// clock() those of all threads together.
double wallclock() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

void register_script_functions() {
  Global.Add("contactstop", "(", new OneOperator1_<long, string*>(contactstop));
  Global.Add("wallclock", "(", new OneOperator0<double>(wallclock));
}

}  // namespace ffcontact::plugin
