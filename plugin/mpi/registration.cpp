// SPDX-License-Identifier: GPL-3.0-or-later
// The module ffcontact_mpi: what comm= of a contact needs, for FreeFem++-mpi.
#include <dlfcn.h>

#include "mpi_processes.hpp"
//
#include "freefem/freefem.hpp"

namespace {

/// ffcontact.so beside this module, where it is loaded.
void* loaded_plugin() {
  Dl_info own;
  static const char here = 0;
  if (dladdr(&here, &own) == 0) return nullptr;
  const std::string path = own.dli_fname;
  const std::string folder = path.substr(0, path.find_last_of('/') + 1);
  return dlopen((folder + "ffcontact.so").c_str(), RTLD_LAZY | RTLD_NOLOAD);
}

void register_processes() {
  void* plugin = loaded_plugin();
  void* use = plugin ? dlsym(plugin, "ffcontact_use_processes") : nullptr;
  if (!use) ExecError("ffcontact_mpi: load \"ffcontact\" first");
  reinterpret_cast<decltype(&ffcontact_use_processes)>(use)(
      ffcontact::plugin::mpi_processes);
}

}  // namespace

LOADFUNC(register_processes)
