// SPDX-License-Identifier: GPL-3.0-or-later
// What FreeFEM's language lacks for ffcontact.idp and its examples.
#include "freefem/freefem.hpp"
#include "freefem/stopwatch.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// contactstop("function: what was wrong") stops the script with that sentence, exit code
/// 8.
long contactstop(string* const& sentence) {
  ExecError(sentence->c_str());
  return 0;
}

/// contactversion() is the version of ffcontact, "0.1.0"; FreeFEM copies it and frees
/// nothing.
string* contactversion() {
  static string version(FFCONTACT_VERSION);
  return &version;
}

}  // namespace

void register_script_functions() {
  Global.Add("contactstop", "(", new OneOperator1_<long, string*>(contactstop));
  Global.Add("contactversion", "(", new OneOperator0<string*>(contactversion));
  Global.Add("wallclock", "(", new OneOperator0<double>(wallclock));
}

}  // namespace ffcontact::plugin
