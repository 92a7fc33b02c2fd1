// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration.hpp"

#include "freefem/freefem.hpp"

namespace {

void register_all() {
  ffcontact::plugin::register_contact_type();
  ffcontact::plugin::register_contact_functions();
  ffcontact::plugin::register_multiplier_functions();
  ffcontact::plugin::register_estimate_functions();
  ffcontact::plugin::register_bounds_functions();
  ffcontact::plugin::register_uniqueness_functions();
  ffcontact::plugin::register_picture_functions();
  ffcontact::plugin::register_sizing_functions();
  ffcontact::plugin::register_gmsh_functions();
  ffcontact::plugin::register_remesh_functions();
  ffcontact::plugin::register_mesh_functions();
  ffcontact::plugin::register_script_functions();
}

}  // namespace

LOADFUNC(register_all)
