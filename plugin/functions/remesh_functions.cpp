// SPDX-License-Identifier: GPL-3.0-or-later
// What contactmesh in ffcontact.idp needs around adaptmesh: bodies one by one, labels that
// keep corners, and vertices put back on lines and curves.
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "ffcontact/mesh/remeshing/moved_onto_parts.hpp"
#include "ffcontact/mesh/self_touch.hpp"
#include "ffcontact/mesh/separate_bodies.hpp"
//
#include "freefem/guard.hpp"
#include "freefem/new_mesh.hpp"
#include "freefem/read_mesh.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

constexpr double degree = M_PI / 180;

VectorXi regions_of(const Fem2D::Mesh& Th) {
  VectorXi regions(Th.nt);
  for (int t = 0; t < Th.nt; ++t) regions[t] = Th[t].lab;
  return regions;
}

/// count = contactmeshbodies(Th): of bodies that share no vertex
long contactmeshbodies(Stack, pmesh const& Th) {
  return GetAny<long>(guarded("contactmesh", [&] {
    return SetAny<long>(count_of(separate_bodies(mesh_of(Th))));
  }));
}

/// Tb = contactmeshbody(Th, k, vertices): body k from 0 on, and the numbers that its
/// vertices have in Th
pmesh contactmeshbody(Stack stack, pmesh const& Th, const long& k,
                      KN<long>* const& vertices) {
  return GetAny<pmesh>(guarded("contactmesh", [&] {
    const std::vector<SeparateBody> bodies = separate_bodies(mesh_of(Th));
    if (k < 0 || k >= count_of(bodies)) refuse("there is no body ", k);
    const SeparateBody& body = bodies[k];
    vertices->resize(count_of(body.vertex));
    std::copy(body.vertex.begin(), body.vertex.end(),
              static_cast<long*>(*vertices));
    return SetAny<pmesh>(
        fem_mesh_of(stack, body.mesh, regions_of(*Th)(body.cell)));
  }));
}

/// Tj = contactmeshjoined(T1, T2): both bodies, whose vertices stay apart
pmesh contactmeshjoined(Stack stack, pmesh const& T1, pmesh const& T2) {
  return GetAny<pmesh>(guarded("contactmesh", [&] {
    const std::vector<Mesh> bodies = {mesh_of(T1), mesh_of(T2)};
    Mesh joined = joined_mesh(bodies).mesh;
    joined.vertices.colwise() += joined.origin;
    joined.boundary_label << bodies[0].boundary_label, bodies[1].boundary_label;
    VectorXi regions(joined.cell_count());
    regions << regions_of(*T1), regions_of(*T2);
    return SetAny<pmesh>(fem_mesh_of(stack, joined, regions));
  }));
}

/// adaptmesh ends FreeFEM where it finds two of its vertices at one place.
void require_no_touch(const Mesh& mesh) {
  if (const auto vertex = self_touch(mesh))
    refuse("the body touches itself at ", in_words(mesh.place(*vertex)),
           ", which adaptmesh cannot keep apart: mesh it by gmsh, "
           "gmshmesh(\"x.geo\", Th, h[])");
}

/// A mesh and its lines and curves.
struct Parted {
  Mesh mesh;
  std::vector<BoundaryPart> parts;

  Parted(pmesh Th, double corner)
      : mesh(mesh_of(Th)), parts(boundary_parts(mesh, corner * degree)) {}
};

/// Tl = contactmeshparts(Th, corner): every straight line and every smooth curve has a
/// label of its own
pmesh contactmeshparts(Stack stack, pmesh const& Th, const double& corner) {
  return GetAny<pmesh>(guarded("contactmesh", [&] {
    Parted parted(Th, corner);
    require_no_touch(parted.mesh);
    parted.mesh.boundary_label = labelled_by_parts(parted.mesh, parted.parts);
    return SetAny<pmesh>(fem_mesh_of(stack, parted.mesh, regions_of(*Th)));
  }));
}

/// angle = contactmeshangle(Th, corner): thetamax for adaptmesh [degrees]
double contactmeshangle(Stack, pmesh const& Th, const double& corner) {
  return GetAny<double>(guarded("contactmesh", [&] {
    const Parted parted(Th, corner);
    return SetAny<double>(
        smallest_corner(parted.mesh, parted.parts, corner * degree) / degree);
  }));
}

/// Tm = contactmeshmoved(Tl, Th, corner): a mesh made of contactmeshparts(Th, corner),
/// its vertices on the parts of Th
pmesh contactmeshmoved(Stack stack, pmesh const& fine, pmesh const& Th,
                       const double& corner) {
  return GetAny<pmesh>(guarded("contactmesh", [&] {
    const Parted parted(Th, corner);
    return SetAny<pmesh>(fem_mesh_of(
        stack, moved_onto_parts(mesh_of(fine), parted.mesh, parted.parts),
        regions_of(*fine)));
  }));
}

/// Tn = contactmeshlabelled(Tm, Th, corner): with the labels of Th again
pmesh contactmeshlabelled(Stack stack, pmesh const& fine, pmesh const& Th,
                          const double& corner) {
  return GetAny<pmesh>(guarded("contactmesh", [&] {
    const Parted parted(Th, corner);
    Mesh mesh = mesh_of(fine);
    const int first = part_label(parted.mesh, 0),
              count = count_of(parted.parts);
    for (int& label : mesh.boundary_label)
      if (label >= first && label < first + count)
        label = parted.parts[label - first].label;
    return SetAny<pmesh>(fem_mesh_of(stack, mesh, regions_of(*fine)));
  }));
}

}  // namespace

void register_remesh_functions() {
  Global.Add("contactmeshbodies", "(",
             new OneOperator1s_<long, pmesh>(contactmeshbodies));
  Global.Add(
      "contactmeshbody", "(",
      new OneOperator3s_<pmesh, pmesh, long, KN<long>*>(contactmeshbody));
  Global.Add("contactmeshjoined", "(",
             new OneOperator2s_<pmesh, pmesh, pmesh>(contactmeshjoined));
  Global.Add("contactmeshparts", "(",
             new OneOperator2s_<pmesh, pmesh, double>(contactmeshparts));
  Global.Add("contactmeshangle", "(",
             new OneOperator2s_<double, pmesh, double>(contactmeshangle));
  Global.Add("contactmeshmoved", "(",
             new OneOperator3s_<pmesh, pmesh, pmesh, double>(contactmeshmoved));
  Global.Add(
      "contactmeshlabelled", "(",
      new OneOperator3s_<pmesh, pmesh, pmesh, double>(contactmeshlabelled));
}

}  // namespace ffcontact::plugin
