// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
#include "gmsh/gmsh_program.hpp"
//
#include "freefem/guard.hpp"
#include "freefem/new_mesh.hpp"
#include "freefem/views.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

void report(const string& file, const GmshMesh& gmsh) {
  if (verbosity > 0 && mpirank == 0)
    cout << "gmshmesh: " << file << ", " << gmsh.mesh.cell_count()
         << " triangles, " << gmsh.mesh.vertex_count() << " vertices" << endl;
}

AnyType reported(Stack stack, const string& file, const GmshMesh& gmsh) {
  report(file, gmsh);
  return SetAny<pmesh>(fem_mesh_of(stack, gmsh.mesh, gmsh.regions));
}

/// Th = gmshmesh("part.geo"), or gmshmesh("part.msh")
pmesh gmshmesh(Stack stack, string* const& file) {
  return GetAny<pmesh>(guarded(
      "gmshmesh", [&] { return reported(stack, *file, gmsh_mesh(*file)); }));
}

/// Th = gmshmesh("part.geo", Th, size): edges of the lengths `size`, one value a vertex
/// of Th
pmesh gmshmesh_sized(Stack stack, string* const& geometry,
                     pmesh const& background, KN<double>* const& size) {
  return GetAny<pmesh>(guarded("gmshmesh", [&] {
    return reported(stack, *geometry,
                    gmsh_mesh(*geometry, mesh_of(background), vector_of(size)));
  }));
}

/// label = gmshlabel("part.geo", "contact")
long gmshlabel(Stack, string* const& file, string* const& name) {
  return GetAny<long>(guarded(
      "gmshlabel", [&] { return SetAny<long>(gmsh_label(*file, *name)); }));
}

}  // namespace

void register_gmsh_functions() {
  Global.Add("gmshmesh", "(", new OneOperator1s_<pmesh, string*>(gmshmesh));
  Global.Add(
      "gmshmesh", "(",
      new OneOperator3s_<pmesh, string*, pmesh, KN<double>*>(gmshmesh_sized));
  Global.Add("gmshlabel", "(",
             new OneOperator2s_<long, string*, string*>(gmshlabel));
}

}  // namespace ffcontact::plugin
