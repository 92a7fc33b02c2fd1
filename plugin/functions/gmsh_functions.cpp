// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
#include "gmsh/gmsh_program.hpp"
//
#include "freefem/guard.hpp"
#include "freefem/new_mesh.hpp"
#include "freefem/read_mesh.hpp"
#include "freefem/views.hpp"
#include "registration.hpp"
#include "solids.hpp"

namespace ffcontact::plugin {

namespace {

template <int dim>
void report(const string& function, const string& file,
            const GmshMesh<dim>& gmsh) {
  if (verbosity <= 0 || mpirank != 0) return;
  cout << function << ": " << file << ", " << gmsh.mesh.cell_count() << " "
       << MeshWords<dim>::cells << ", " << gmsh.mesh.vertex_count()
       << " vertices" << endl;
  if (!gmsh.splitting.empty())
    cout << function << ": " << gmsh.splitting << endl;
}

AnyType reported(Stack stack, const string& file, const GmshMesh<2>& gmsh) {
  report("gmshmesh", file, gmsh);
  return SetAny<pmesh>(fem_mesh_of(stack, gmsh.mesh, gmsh.regions));
}

/// Th = gmshmesh("part.geo"), or gmshmesh("part.msh")
pmesh gmshmesh(Stack stack, string* const& file) {
  return GetAny<pmesh>(guarded(
      "gmshmesh", [&] { return reported(stack, *file, gmsh_mesh(*file)); }));
}

/// Ts = gmshmesh3("part.geo"), or gmshmesh3("part.msh")
pmesh3 gmshmesh3(Stack stack, string* const& file) {
  return guarded("gmshmesh3", [&] {
    const GmshMesh<3> gmsh = solids().gmsh_solid(*file);
    report("gmshmesh3", *file, gmsh);
    return fem_mesh_of(stack, gmsh.mesh, gmsh.regions);
  });
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
  Global.Add("gmshmesh3", "(", new OneOperator1s_<pmesh3, string*>(gmshmesh3));
  Global.Add(
      "gmshmesh", "(",
      new OneOperator3s_<pmesh, string*, pmesh, KN<double>*>(gmshmesh_sized));
  Global.Add("gmshlabel", "(",
             new OneOperator2s_<long, string*, string*>(gmshlabel));
}

}  // namespace ffcontact::plugin
