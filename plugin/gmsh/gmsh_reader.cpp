// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/gmsh_reader.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iomanip>
#include <map>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
//
#include "gmsh/msh_file.hpp"

namespace ffcontact::plugin {

namespace {

using std::filesystem::path;

/// Makes a plane mesh of a file.
class PlaneMesh {
 public:
  PlaneMesh(const path& file, const std::string& shown)
      : shown_(shown), file_(read_msh(file, shown, 2)) {
    if (file_.triangles.empty())
      refuse(shown_, " has no triangles",
             file_.lines.empty()
                 ? ""
                 : ": does the geometry have physical curves but no "
                   "physical surface?");
    take_each_triangle_once();
    used_ = used_nodes(file_, file_.triangles, 3);
  }

  GmshMesh mesh() {
    require_plane();
    GmshMesh result;
    Mesh& mesh = result.mesh;
    mesh.vertices.resize(2, count_of(used_.node));
    for (int v = 0; v < count_of(used_.node); ++v)
      mesh.vertices.col(v) = file_.nodes[used_.node[v]].head<2>();
    set_triangles(result);
    set_boundary(mesh);
    require_valid(mesh);
    return result;
  }

 private:
  void set_triangles(GmshMesh& result) const {
    Mesh& mesh = result.mesh;
    const int surface_tag = tag_to_use(file_.triangles),
              count = count_of(file_.triangles);
    mesh.cells.resize(3, count);
    result.regions.resize(count);
    for (int t = 0; t < count; ++t) {
      const MshElement& triangle = file_.triangles[t];
      for (int k = 0; k < 3; ++k)
        mesh.cells(k, t) = used_.vertex[triangle.nodes[k]];
      if (signed_area(mesh, t) < 0)
        std::swap(mesh.cells(1, t), mesh.cells(2, t));
      result.regions[t] = triangle.tags[surface_tag];
    }
  }

  /// gmsh writes an element of several physical groups once for each.
  void take_each_triangle_once() {
    const int tag = tag_to_use(file_.triangles);
    std::map<std::array<int, 4>, int> region;
    const auto is_repeated = [&](const MshElement& triangle) {
      std::array<int, 4> sorted = triangle.nodes;
      std::sort(sorted.begin(), sorted.end());
      const auto [seen, is_new] =
          region.try_emplace(sorted, triangle.tags[tag]);
      if (seen->second != triangle.tags[tag])
        refuse_groups(triangle, 3, seen->second, triangle.tags[tag]);
      return !is_new;
    };
    std::vector<MshElement>& all = file_.triangles;
    all.erase(std::remove_if(all.begin(), all.end(), is_repeated), all.end());
  }

  /// Which of several groups of an element should count? Their order says nothing.
  [[noreturn]] void refuse_groups(const MshElement& element, int corners,
                                  int one, int other) const {
    Vector2d middle = Vector2d::Zero();
    for (int k = 0; k < corners; ++k)
      middle += file_.nodes[element.nodes[k]].head<2>() / corners;
    const bool is_line = corners == 2;
    refuse("the ", is_line ? "edge" : "triangle", " at ",
           in_words(middle, digits_of_figures), " of ", shown_,
           " is in two physical ", is_line ? "curves, " : "surfaces, ", one,
           " and ", other, ", but has one ", is_line ? "label" : "region",
           ": put it into one of them");
  }

  /// 0, physical tags, if one element has one; otherwise 1, elementary tags.
  static int tag_to_use(const std::vector<MshElement>& elements) {
    return std::any_of(elements.begin(), elements.end(),
                       [](const auto& e) { return e.tags[0] != 0; })
               ? 0
               : 1;
  }

  void require_plane() const {
    double extent = 0;
    for (const int node : used_.node)
      extent = std::max(extent,
                        file_.nodes[node].head<2>().lpNorm<Eigen::Infinity>());
    const double z = file_.nodes[used_.node[0]].z();
    for (const int node : used_.node)
      if (std::abs(file_.nodes[node].z() - z) > 1e-9 * extent)
        refuse(shown_, " is not plane: z is ", z, " and ",
               file_.nodes[node].z(), " at two of its nodes");
  }

  /// Labelled lines that are edges of triangles, then the boundary edges that no line
  /// labels.
  void set_boundary(Mesh& mesh) const {
    UsedEdges edges = used_edges(mesh);
    std::vector<BoundaryEdge> boundary;
    add_lines(edges, boundary);
    for (const auto& [ends, use] : edges)
      if (use.triangles == 1 && !use.labelled)
        boundary.push_back({use.vertices, 0});
    mesh.boundary.resize(2, count_of(boundary));
    mesh.boundary_label.resize(count_of(boundary));
    for (int e = 0; e < count_of(boundary); ++e) {
      mesh.boundary.col(e) = boundary[e].vertices;
      mesh.boundary_label[e] = boundary[e].label;
    }
  }

  struct BoundaryEdge {
    Vector2i vertices;
    int label;
  };
  struct UseOfEdge {
    Vector2i vertices;  ///< as in the first triangle
    int triangles = 0;
    bool labelled = false;
    int label = 0;
  };
  using UsedEdges = std::map<std::pair<int, int>, UseOfEdge>;

  static UsedEdges used_edges(const Mesh& mesh) {
    UsedEdges edges;
    for (int t = 0; t < mesh.cell_count(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int i = mesh.cells(k, t), j = mesh.cells((k + 1) % 3, t);
        const auto edge =
            edges.try_emplace(std::minmax(i, j), UseOfEdge{{i, j}}).first;
        ++edge->second.triangles;
      }
    return edges;
  }

  /// The labelled lines, each edge once.
  void add_lines(UsedEdges& edges, std::vector<BoundaryEdge>& boundary) const {
    const int curve_tag = tag_to_use(file_.lines);
    for (const MshElement& line : file_.lines) {
      const auto edge = edges.find(std::minmax(used_.vertex[line.nodes[0]],
                                               used_.vertex[line.nodes[1]]));
      if (edge == edges.end()) continue;
      UseOfEdge& use = edge->second;
      const int label = line.tags[curve_tag];
      if (use.labelled && use.label != label)
        refuse_groups(line, 2, use.label, label);
      if (use.labelled) continue;
      use.labelled = true;
      use.label = label;
      boundary.push_back({use.vertices, label});
    }
  }

  std::string shown_;  ///< what the user calls the file
  MshFile file_;
  UsedNodes used_;  ///< by triangles
};

}  // namespace

GmshMesh read_gmsh_mesh(const path& file, const std::string& shown) {
  return PlaneMesh(file, shown).mesh();
}

bool is_readable_format(const path& file) {
  std::ifstream stream(file);
  std::string section;
  double version = 0;
  int binary = 0;
  if (!(stream >> section >> version >> binary) || section != "$MeshFormat")
    refuse(file.string(),
           " is not a mesh of gmsh: it does not start with $MeshFormat");
  return version >= 2 && version < 3 && binary == 0;
}

int physical_tag(const path& file, const std::string& name,
                 const std::string& shown) {
  std::ifstream stream(file);
  std::string word, names;
  while (stream >> word && word != "$PhysicalNames") {
  }
  int count = 0, surface = 0;
  stream >> count;
  for (int i = 0, dimension, tag;
       i < count && stream >> dimension >> tag >> std::quoted(word); ++i) {
    if (dimension == 1 && word == name) return tag;
    if (dimension == 2 && word == name) surface = tag;
    names += (names.empty() ? "" : ", ") + word;
  }
  if (surface != 0) return surface;
  refuse(shown, " has no physical curve or surface \"", name, "\"; ",
         names.empty() ? "it names none" : "its names are " + names);
}

}  // namespace ffcontact::plugin
