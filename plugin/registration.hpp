// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ffcontact::plugin {

void register_contact_type();          ///< contact
void register_contact_members();       ///< C.pn, ...; after the type
void register_contact_functions();     ///< contactsolve
void register_multiplier_functions();  ///< contactproject, conecorrection
void register_estimate_functions();    ///< contacterror
void register_bounds_functions();      ///< contactbounds
void register_uniqueness_functions();  ///< criticalfriction
void register_picture_functions();     ///< contactpicture
void register_sizing_functions();      ///< optimalsize
void register_gmsh_functions();        ///< gmshmesh, gmshmesh3, gmshlabel
void register_remesh_functions();  ///< contactmeshbodies, -parts, -moved, ...
void register_mesh_functions();    ///< contactmeshsolid, meshquality
void register_script_functions();  ///< contactstop, wallclock

}  // namespace ffcontact::plugin
