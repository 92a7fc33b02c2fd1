// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/msh_file.hpp"

#include <algorithm>
#include <fstream>
#include <unordered_map>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

namespace {

constexpr std::array<MshType, 8> types{{{15, "point", "points", 0, 1},
                                        {1, "edge", "edges", 1, 2},
                                        {2, "triangle", "triangles", 2, 3},
                                        {3, "quadrangle", "quadrangles", 2, 4},
                                        {4, "tetrahedron", "tetrahedra", 3, 4},
                                        {5, "hexahedron", "hexahedra", 3, 8},
                                        {6, "prism", "prisms", 3, 6},
                                        {7, "pyramid", "pyramids", 3, 5}}};

class MshReader {
 public:
  MshReader(const std::filesystem::path& file, const std::string& shown,
            int dim)
      : shown_(shown), dim_(dim), stream_(file) {
    result_.dim = dim;
    std::string word;
    while (stream_ >> word) {
      if (word == "$Nodes") read_section("nodes", [this] { read_node(); });
      if (word == "$Elements")
        read_section("elements", [this] { read_element(); });
    }
  }

  MshFile take() { return std::move(result_); }

 private:
  template <class ReadOne>
  void read_section(const char* name, const ReadOne& read_one) {
    std::size_t count = 0;
    stream_ >> count;
    for (std::size_t i = 0; i < count && stream_; ++i) read_one();
    if (!stream_) refuse(shown_, " ends or is spoilt among its ", name);
  }

  void read_node() {
    long number;
    Vector3d x;
    stream_ >> number >> x[0] >> x[1] >> x[2];
    index_[number] = count_of(result_.nodes);
    result_.nodes.push_back(x);
  }

  void read_element() {
    long number;
    int type, tag_count;
    stream_ >> number >> type >> tag_count;
    MshElement element{&type_of(type, number), {0, 0}, {}};
    for (int k = 0, ignored; k < tag_count; ++k)
      stream_ >> (k < 2 ? element.tags[k] : ignored);
    read_nodes_of(number, element);
    if (element.type->dimension > 0)
      result_.elements[element.type->dimension].push_back(element);
  }

  const MshType& type_of(int type, long element) const {
    const auto* found = std::find_if(
        types.begin(), types.end(),
        [=](const MshType& known) { return known.number == type; });
    if (found == types.end())
      refuse("element ", element, " of ", shown_, " has gmsh's type ", type,
             "; only elements with straight edges are understood: mesh it with "
             "Mesh.ElementOrder = 1");
    if (found->dimension > dim_)
      refuse("element ", element, " of ", shown_, " is a ", found->name,
             ": meshes of solids are read by gmshmesh3");
    return *found;
  }

  int index_of(long node, long element) const {
    const auto found = index_.find(node);
    if (found == index_.end())
      refuse("element ", element, " of ", shown_, " names the node ", node,
             ", which is not there");
    return found->second;
  }

  void read_nodes_of(long number, MshElement& element) {
    element.nodes.fill(-1);
    for (int k = 0; k < element.type->corners; ++k) {
      long node = 0;
      stream_ >> node;
      element.nodes[k] = index_of(node, number);
    }
  }

  std::string shown_;
  int dim_;
  std::ifstream stream_;
  std::unordered_map<long, int> index_;  ///< of a node's number
  MshFile result_;
};

}  // namespace

MshFile read_msh(const std::filesystem::path& file, const std::string& shown,
                 int dim) {
  return MshReader(file, shown, dim).take();
}

const MshType& simplex_type(int dimension) {
  return *std::find_if(types.begin(), types.end(), [=](const MshType& type) {
    return type.dimension == dimension && type.corners == dimension + 1;
  });
}

Vector3d centre_of(const MshElement& element, const MshFile& file) {
  Vector3d centre = Vector3d::Zero();
  for (int k = 0; k < element.type->corners; ++k)
    centre += file.nodes[element.nodes[k]];
  return centre / element.type->corners;
}

std::string place_of(const MshElement& element, const MshFile& file) {
  return in_words(centre_of(element, file).head(file.dim), digits_of_figures);
}

UsedNodes used_nodes(const MshFile& file,
                     const std::vector<MshElement>& elements) {
  UsedNodes used;
  used.vertex.assign(file.nodes.size(), -1);
  for (const MshElement& element : elements)
    for (int k = 0; k < element.type->corners; ++k)
      used.vertex[element.nodes[k]] = 0;
  for (int node = 0; node < count_of(file.nodes); ++node)
    if (used.vertex[node] == 0) {
      used.vertex[node] = count_of(used.node);
      used.node.push_back(node);
    }
  return used;
}

}  // namespace ffcontact::plugin
