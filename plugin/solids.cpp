// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids.hpp"

#include <dlfcn.h>

#include <string>

#include "ffcontact/base/require.hpp"
//
#include "freefem/guard.hpp"

namespace ffcontact::plugin {

namespace {

/// Of the folder that ffcontact.so was loaded from.
std::string path_of_module() {
  static const char here = 0;
  Dl_info own{};
  dladdr(&here, &own);
  const std::string path = own.dli_fname ? own.dli_fname : "";
  return path.substr(0, path.find_last_of('/') + 1) + "ffcontact_solids.so";
}

const Solids* loaded_module() {
  const std::string path = path_of_module();
  void* module = dlopen(path.c_str(), RTLD_LAZY);
  if (!module)
    refuse(
        "a mesh3, and comm=, need the module ffcontact_solids beside "
        "ffcontact.so; cmake --build builds it, and bash edp/run for a script "
        "with a mesh3: ",
        dlerror());
  void* entry = dlsym(module, "ffcontact_solids");
  if (!entry) refuse(path, " is not of this ffcontact.so");
  return reinterpret_cast<decltype(&ffcontact_solids)>(entry)();
}

}  // namespace

const Solids& solids() {
  static const Solids* const module = loaded_module();
  return *module;
}

}  // namespace ffcontact::plugin

void ffcontact_use_processes(ffcontact::plugin::MakeProcesses make) {
  using namespace ffcontact::plugin;
  guarded("ffcontact_mpi", [make] { solids().use_processes(make); });
}
