// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh_reader.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iomanip>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

namespace {

using std::filesystem::path;

/// Reads MSH 2.2 in text, section by section.
class Version2Reader {
 public:
  Version2Reader(const path& file, const std::string& shown)
      : shown_(shown), stream_(file) {
    std::string word;
    while (stream_ >> word) {
      if (word == "$Nodes") read_nodes();
      if (word == "$Elements") read_elements();
    }
    if (triangles_.empty())
      refuse(shown_, " has no triangles",
             lines_.empty() ? ""
                            : ": does the geometry have physical curves but no "
                              "physical surface?");
  }

  GmshMesh mesh() {
    number_used_nodes();
    GmshMesh result;
    Mesh& mesh = result.mesh;
    mesh.vertices.resize(2, count_of(used_));
    for (std::size_t v = 0; v < used_.size(); ++v)
      mesh.vertices.col(v) = nodes_[used_[v]].head<2>();
    require_plane();

    const int surface_tag = tag_to_use(triangles_);
    mesh.cells.resize(3, count_of(triangles_));
    result.regions.resize(count_of(triangles_));
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (int k = 0; k < 3; ++k)
        mesh.cells(k, t) = vertex_[triangles_[t].nodes[k]];
      if (signed_area(mesh, static_cast<int>(t)) < 0)
        std::swap(mesh.cells(1, t), mesh.cells(2, t));
      result.regions[t] = triangles_[t].tags[surface_tag];
    }
    set_boundary(mesh);
    require_valid(mesh);
    return result;
  }

 private:
  template <int nodes_per_element>
  struct Element {
    std::array<int, 2> tags;  ///< physical, elementary
    std::array<int, nodes_per_element> nodes;
  };

  void require_read(const char* what) const {
    if (!stream_) refuse(shown_, " ends or is spoilt among its ", what);
  }

  void read_nodes() {
    std::size_t count = 0;
    stream_ >> count;
    for (std::size_t i = 0; i < count && stream_; ++i) {
      long number;
      Vector3d x;
      stream_ >> number >> x[0] >> x[1] >> x[2];
      index_[number] = count_of(nodes_);
      nodes_.push_back(x);
    }
    require_read("nodes");
  }

  void read_elements() {
    constexpr int line = 1, triangle = 2, point = 15;
    // an element of several physical groups is written once for each
    std::set<std::array<int, 3>> seen_triangles;
    std::size_t count = 0;
    stream_ >> count;
    for (std::size_t i = 0; i < count && stream_; ++i) {
      long number;
      int type, tag_count;
      stream_ >> number >> type >> tag_count;
      std::array<int, 2> tags{0, 0};
      for (int k = 0, ignored; k < tag_count; ++k)
        stream_ >> (k < 2 ? tags[k] : ignored);
      if (type == point) {
        read_element_nodes<1>(number);
      } else if (type == line) {
        lines_.push_back({tags, read_element_nodes<2>(number)});
      } else if (type == triangle) {
        const std::array<int, 3> nodes = read_element_nodes<3>(number);
        std::array<int, 3> sorted = nodes;
        std::sort(sorted.begin(), sorted.end());
        if (seen_triangles.insert(sorted).second)
          triangles_.push_back({tags, nodes});
      } else {
        refuse(
            "element ", number, " of ", shown_, " has gmsh's type ", type,
            "; only lines of two and triangles of three nodes are understood");
      }
    }
    require_read("elements");
  }

  template <int count>
  std::array<int, count> read_element_nodes(long element) {
    std::array<int, count> nodes{};
    for (int& node : nodes) {
      long number = 0;
      stream_ >> number;
      const auto found = index_.find(number);
      if (found == index_.end())
        refuse("element ", element, " of ", shown_, " names the node ", number,
               ", which is not there");
      node = found->second;
    }
    return nodes;
  }

  /// 0, physical tags, if one element has one; otherwise 1, elementary tags.
  template <class Elements>
  static int tag_to_use(const Elements& elements) {
    return std::any_of(elements.begin(), elements.end(),
                       [](const auto& e) { return e.tags[0] != 0; })
               ? 0
               : 1;
  }

  /// Vertices are the nodes of triangles, in the order of the file.
  void number_used_nodes() {
    vertex_.assign(nodes_.size(), -1);
    for (const auto& triangle : triangles_)
      for (const int node : triangle.nodes) vertex_[node] = 0;
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      if (vertex_[node] == 0) {
        vertex_[node] = count_of(used_);
        used_.push_back(static_cast<int>(node));
      }
  }

  void require_plane() const {
    double extent = 0;
    for (const int node : used_)
      extent =
          std::max(extent, nodes_[node].head<2>().lpNorm<Eigen::Infinity>());
    for (const int node : used_)
      if (std::abs(nodes_[node].z() - nodes_[used_[0]].z()) > 1e-9 * extent)
        refuse(shown_, " is not plane: z is ", nodes_[used_[0]].z(), " and ",
               nodes_[node].z(), " at two of its nodes");
  }

  /// Labelled lines that are edges of triangles, then the boundary edges that no line
  /// labels.
  void set_boundary(Mesh& mesh) const {
    struct Use {
      int first, second, triangles;  // as in the first triangle
      bool labelled;
    };
    std::map<std::pair<int, int>, Use> edges;
    for (int t = 0; t < mesh.cell_count(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int i = mesh.cells(k, t), j = mesh.cells((k + 1) % 3, t);
        ++edges.try_emplace(std::minmax(i, j), Use{i, j, 0, false})
              .first->second.triangles;
      }

    std::vector<std::array<int, 3>> boundary;
    const int curve_tag = tag_to_use(lines_);
    for (const auto& line : lines_) {
      const auto edge = edges.find(
          std::minmax(vertex_[line.nodes[0]], vertex_[line.nodes[1]]));
      if (edge == edges.end() || edge->second.labelled) continue;
      edge->second.labelled = true;
      boundary.push_back(
          {edge->second.first, edge->second.second, line.tags[curve_tag]});
    }
    for (const auto& [ends, use] : edges)
      if (use.triangles == 1 && !use.labelled)
        boundary.push_back({use.first, use.second, 0});

    mesh.boundary.resize(2, count_of(boundary));
    mesh.boundary_label.resize(count_of(boundary));
    for (std::size_t e = 0; e < boundary.size(); ++e) {
      mesh.boundary.col(e) << boundary[e][0], boundary[e][1];
      mesh.boundary_label[e] = boundary[e][2];
    }
  }

  std::string shown_;  ///< what the user calls the file
  std::ifstream stream_;
  std::vector<Vector3d> nodes_;
  std::unordered_map<long, int> index_;  ///< of a node's number
  std::vector<Element<2>> lines_;
  std::vector<Element<3>> triangles_;
  std::vector<int> used_,
      vertex_;  ///< nodes that triangles use; the vertex of a node
};

}  // namespace

GmshMesh read_gmsh_mesh(const path& file, const std::string& shown) {
  return Version2Reader(file, shown).mesh();
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
