// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/solid_remesh.hpp"

#include <cmath>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/near_origin.hpp"
#include "ffcontact/mesh/remeshing/surface_curvature.hpp"
//
#include "freefem/vertex_sizes.hpp"
#include "gmsh/gmsh_model.hpp"
#include "gmsh/gmsh_run.hpp"

namespace ffcontact::plugin {

namespace {

/// The power of 2 that makes a body about 100 large: gmsh's tolerances are lengths.
double scale_to_hundred(const SolidMesh& mesh) {
  const double extent = box_sides(mesh.vertices).maxCoeff();
  return std::exp2(std::round(std::log2(100 / extent)));
}

/// Sizes with which smooth surfaces turn by less than they may.
VectorXd followed_size(const Ref<const VectorXd>& size,
                       const VectorXd& curvature) {
  constexpr double largest_turn = 0.4;  // of an edge, 23 degrees
  return (curvature.array() > 0)
      .select(size.array().min(largest_turn / curvature.array()), size.array());
}

ModelMesh made_by_gmsh(const SolidMesh& mesh, const Facets<3>& faces,
                       const SurfaceModel& model,
                       const Ref<const VectorXd>& size) {
  const double scale = scale_to_hundred(mesh);
  const TemporaryFolder folder;
  write_gmsh_model(folder / "model.msh", mesh, faces, model, scale);
  write_gmsh_sizes(folder / "sizes.pos", mesh, size, scale);
  write_gmsh_volumes(folder / "model.geo", model);
  run_gmsh("-3", folder / "model.geo", folder / "new.msh",
           "the surface of this mesh", folder / "log",
           "; or include \"ffcontact_tetgen.idp\" and take "
           "contactmeshtetgen(Th, h[]), which divides the mesh by FreeFEM's "
           "tetgen");
  if (const std::string error = first_line(folder / "log"); !error.empty())
    refuse("gmsh cannot mesh this body anew: ", error);
  return read_gmsh_model(folder / "new.msh", 1 / scale);
}

/// The faces that had labels, with them.
void put_labels(const ModelMesh& fine, const SolidMesh& old,
                const SurfaceModel& model, SolidMesh& mesh) {
  std::vector<int> column(model.patches.patch_count(), -1);
  for (int k = 0; k < model.dividing.count(); ++k)
    column[model.patches.patch[k]] = model.dividing.boundary[k];
  std::vector<Vector3i> faces;
  std::vector<int> labels;
  for (Index e = 0; e < fine.mesh.boundary.cols(); ++e) {
    const int of = column[fine.patch[e]];
    if (of < 0) continue;
    faces.push_back(fine.mesh.boundary.col(e));
    labels.push_back(old.boundary_label[of]);
  }
  mesh.boundary = packed(faces);
  mesh.boundary_label = packed(labels);
}

}  // namespace

Solid remeshed(Solid solid, const Ref<const VectorXd>& size, double corner) {
  SolidMesh& mesh = solid.mesh;
  require_vertex_sizes(size, mesh.vertex_count());
  take_from_near_origin(mesh);
  const Facets<3> faces = facets_of(mesh);
  const SurfaceModel model = surface_model(mesh, faces, solid.regions, corner);
  const ModelMesh fine =
      made_by_gmsh(mesh, faces, model,
                   followed_size(size, surface_curvature(mesh, faces, model)));
  Solid result;
  result.mesh = moved_onto_surfaces(fine, mesh, faces, model);
  put_labels(fine, mesh, model, result.mesh);
  result.regions.resize(result.mesh.cells.cols());
  for (Index t = 0; t < result.regions.size(); ++t)
    result.regions[t] = model.dividing.region[fine.part[t]];
  result.mesh.vertices.colwise() += mesh.origin;
  return result;
}

}  // namespace ffcontact::plugin
