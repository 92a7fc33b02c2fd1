// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/gmsh_program.hpp"

#include <array>
#include <fstream>

#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/edges.hpp"
//
#include "freefem/text_file.hpp"
#include "gmsh/gmsh_run.hpp"

namespace ffcontact::plugin {

namespace {

using std::filesystem::path;

std::string quoted_for_gmsh(const path& file) {
  const std::string name = std::filesystem::absolute(file).string();
  if (name.find_first_of("\"\n") != std::string::npos)
    refuse("gmsh cannot open a file with a quotation mark in its name: ", name);
  return '"' + name + '"';
}

void require_readable(const path& file) {
  if (!std::ifstream(file) || std::filesystem::is_directory(file))
    refuse("the file ", file.string(), " cannot be read");
}

bool is_mesh_file(const path& file) { return file.extension() == ".msh"; }

/// What gmsh makes of `input`.
path made_by_gmsh(const std::string& dimension, const path& input,
                  const path& what, const TemporaryFolder& folder) {
  const path output = folder / "mesh.msh";
  run_gmsh(dimension, input, output, what.string(), folder / "log");
  return output;
}

/// Unit outward directions at the vertices of the boundary; 0 elsewhere.
Matrix2Xd outward_directions(const Mesh& mesh, const Edges& edges) {
  Matrix2Xd direction = Matrix2Xd::Zero(2, mesh.vertices.cols());
  for (int e = 0; e < edges.count(); ++e)
    if (edges.on_boundary(e))
      for (int end = 0; end < 2; ++end)
        direction.col(edges.vertices(end, e)) += edge_normal(mesh, edges, e);
  direction.colwise().normalize();
  return direction;
}

/// One triangle of a view, with the values at its corners.
void write_triangle(const std::array<Vector2d, 3>& x,
                    const std::array<double, 3>& h, TextFile& view) {
  view << "ST(";
  for (int k = 0; k < 3; ++k)
    view << (k > 0 ? "," : "") << x[k].x() << ',' << x[k].y() << ",0";
  view << "){" << h[0] << ',' << h[1] << ',' << h[2] << "};\n";
}

void write_triangles(const Mesh& mesh, const Ref<const VectorXd>& size,
                     TextFile& view) {
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Vector3i v = mesh.cells.col(t);
    write_triangle({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)},
                   {size[v[0]], size[v[1]], size[v[2]]}, view);
  }
}

/// Where gmsh follows a curved boundary it asks for sizes outside the polygon too.
void write_strip_around(const Mesh& mesh, const Ref<const VectorXd>& size,
                        TextFile& view) {
  // of the edge, as the rise of an arc of 120 degrees
  constexpr double strip_width = 0.3;
  const Edges edges = edges_of(mesh);
  const Matrix2Xd outward = outward_directions(mesh, edges);
  for (int e = 0; e < edges.count(); ++e) {
    if (!edges.on_boundary(e)) continue;
    const int i = edges.vertices(0, e), j = edges.vertices(1, e);
    const double width = strip_width * edge_vector(mesh, edges, e).norm();
    const Vector2d a = mesh.vertices.col(i), b = mesh.vertices.col(j);
    const Vector2d c = a + width * outward.col(i),
                   d = b + width * outward.col(j);
    write_triangle({a, c, b}, {size[i], size[i], size[j]}, view);
    write_triangle({b, c, d}, {size[j], size[i], size[j]}, view);
  }
}

/// A view whose field is the size, linear in the triangles of the mesh.
void write_size_view(const path& file, const Mesh& mesh,
                     const Ref<const VectorXd>& size) {
  TextFile view(file);
  view << "View \"size\" {\n";
  write_triangles(mesh, size, view);
  write_strip_around(mesh, size, view);
  view << "};\n";
  view.close();
}

/// The geometry with the view as the only source of sizes. gmsh's edges are 4 % shorter
/// than asked on average (measured), so sizes are raised by as much; with that the number
/// of triangles is as predicted within 5 %.
void write_sized_geometry(const path& file, const path& geometry,
                          const path& view) {
  TextFile stream(file);
  stream << "Merge " << quoted_for_gmsh(geometry) << ";\nMerge "
         << quoted_for_gmsh(view) << R"(;
ffcontact_sizes = newf;
Field[ffcontact_sizes] = PostView;
Field[ffcontact_sizes].ViewIndex = PostProcessing.NbViews - 1;
Background Field = ffcontact_sizes;
Mesh.MeshSizeFactor = 1.04;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeMin = 0;
Mesh.MeshSizeMax = 1e22;
)";
  stream.close();
}

}  // namespace

path readable_msh(const path& file, int dim, const TemporaryFolder& folder) {
  require_readable(file);
  if (!is_mesh_file(file))
    return made_by_gmsh("-" + std::to_string(dim), file, file, folder);
  return is_readable_format(file) ? file
                                  : made_by_gmsh("-0", file, file, folder);
}

GmshMesh<2> gmsh_mesh(const path& file) {
  const TemporaryFolder folder;
  return read_gmsh_mesh(readable_msh(file, 2, folder), file.string());
}

GmshMesh<2> gmsh_mesh(const path& geometry, const Mesh& background,
                      const Ref<const VectorXd>& size) {
  require_readable(geometry);
  if (is_mesh_file(geometry))
    refuse(
        geometry.string(),
        " is a mesh; to mesh anew gmsh needs the geometry (.geo, .step, ...)");
  require_size("size", size.size(), background.vertex_count());
  require_finite("size", size);
  if (size.minCoeff() <= 0)
    refuse("sizes must be positive, but one is ", size.minCoeff());
  const TemporaryFolder folder;
  write_size_view(folder / "size.pos", background, size);
  write_sized_geometry(folder / "sized.geo", geometry, folder / "size.pos");
  return read_gmsh_mesh(
      made_by_gmsh("-2", folder / "sized.geo", geometry, folder),
      geometry.string());
}

int gmsh_label(const path& file, const std::string& name) {
  require_readable(file);
  if (is_mesh_file(file)) return physical_tag(file, name, file.string());
  const TemporaryFolder folder;
  run_gmsh("-0", file, folder / "names.msh", file.string(), folder / "log");
  return physical_tag(folder / "names.msh", name, file.string());
}

}  // namespace ffcontact::plugin
