// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/msh_file.hpp"

#include <fstream>
#include <unordered_map>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

namespace {

class MshReader {
 public:
  MshReader(const std::filesystem::path& file, const std::string& shown,
            int dim)
      : shown_(shown), dim_(dim), stream_(file) {
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
    constexpr int line = 1, triangle = 2, tetrahedron = 4, point = 15;
    long number;
    int type, tag_count;
    stream_ >> number >> type >> tag_count;
    MshElement element{{0, 0}, {}};
    for (int k = 0, ignored; k < tag_count; ++k)
      stream_ >> (k < 2 ? element.tags[k] : ignored);
    if (type == point) {
      read_nodes_of(number, 1, element);
    } else if (type == line) {
      read_nodes_of(number, 2, element);
      result_.lines.push_back(element);
    } else if (type == triangle) {
      read_nodes_of(number, 3, element);
      result_.triangles.push_back(element);
    } else if (type == tetrahedron && dim_ == 3) {
      read_nodes_of(number, 4, element);
      result_.tetrahedra.push_back(element);
    } else {
      refuse("element ", number, " of ", shown_, " has gmsh's type ", type,
             dim_ == 2 ? "; only lines of two and triangles of three nodes are "
                         "understood"
                       : "; only simplices of linear edges are understood");
    }
  }

  int index_of(long node, long element) const {
    const auto found = index_.find(node);
    if (found == index_.end())
      refuse("element ", element, " of ", shown_, " names the node ", node,
             ", which is not there");
    return found->second;
  }

  void read_nodes_of(long number, int count, MshElement& element) {
    for (int k = 0; k < count; ++k) {
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

UsedNodes used_nodes(const MshFile& file,
                     const std::vector<MshElement>& elements, int corners) {
  UsedNodes used;
  used.vertex.assign(file.nodes.size(), -1);
  for (const MshElement& element : elements)
    for (int k = 0; k < corners; ++k) used.vertex[element.nodes[k]] = 0;
  for (int node = 0; node < count_of(file.nodes); ++node)
    if (used.vertex[node] == 0) {
      used.vertex[node] = count_of(used.node);
      used.node.push_back(node);
    }
  return used;
}

}  // namespace ffcontact::plugin
