// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <unordered_map>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
//
#include "gmsh_model.hpp"

namespace ffcontact::plugin {

namespace {

/// Reads MSH 2.2 in text, section by section.
class ModelReader {
 public:
  ModelReader(const std::filesystem::path& file, double scale)
      : stream_(file), scale_(scale) {
    std::string word;
    while (stream_ >> word) {
      if (word == "$Nodes") read_nodes();
      if (word == "$Elements") read_elements();
    }
    if (tetrahedra_.empty()) refuse("gmsh has filled the body with nothing");
  }

  ModelMesh mesh() {
    number_vertices();
    ModelMesh result;
    result.mesh.vertices.resize(3, count_of(used_));
    for (int v = 0; v < count_of(used_); ++v)
      result.mesh.vertices.col(v) = nodes_[used_[v]];
    result.mesh.cells = vertices_of(tetrahedra_);
    turn_outside_out(result.mesh);
    result.mesh.boundary = vertices_of(triangles_);
    result.lines = vertices_of(lines_);
    result.part = tags_of(tetrahedra_);
    result.patch = tags_of(triangles_);
    result.curve = tags_of(lines_);
    return result;
  }

 private:
  template <int size>
  struct Element {
    int tag;
    Matrix<int, size, 1> nodes;
  };

  void require_read() const {
    if (!stream_) refuse("the mesh of gmsh ends too early or is spoilt");
  }

  void read_nodes() {
    std::size_t count = 0;
    stream_ >> count;
    for (std::size_t i = 0; i < count && stream_; ++i) {
      long number;
      Vector3d x;
      stream_ >> number >> x[0] >> x[1] >> x[2];
      index_[number] = count_of(nodes_);
      nodes_.push_back(scale_ * x);
    }
    require_read();
  }

  void read_elements() {
    constexpr int line = 1, triangle = 2, tetrahedron = 4, point = 15;
    std::size_t count = 0;
    stream_ >> count;
    for (std::size_t i = 0; i < count && stream_; ++i) {
      long number;
      int type, tag_count, tag = 0;
      stream_ >> number >> type >> tag_count;
      for (int k = 0; k < tag_count; ++k) {
        int value;
        stream_ >> value;
        if (k == 1) tag = value;  // the elementary entity
      }
      if (type == line)
        lines_.push_back({tag - 1, nodes<2>()});
      else if (type == triangle)
        triangles_.push_back({tag - 1, nodes<3>()});
      else if (type == tetrahedron)
        tetrahedra_.push_back({tag - 1, nodes<4>()});
      else if (type == point)
        nodes<1>();
      else
        refuse("gmsh has made an element of type ", type);
    }
    require_read();
  }

  template <int size>
  Matrix<int, size, 1> nodes() {
    Matrix<int, size, 1> result;
    for (int& node : result) {
      long number = 0;
      stream_ >> number;
      const auto found = index_.find(number);
      if (found == index_.end())
        refuse("an element of gmsh's mesh names the node ", number,
               ", which is not there");
      node = found->second;
    }
    return result;
  }

  /// Vertices are the nodes of tetrahedra, in the order of the file.
  void number_vertices() {
    vertex_.assign(nodes_.size(), -1);
    for (const auto& element : tetrahedra_)
      for (const int node : element.nodes) vertex_[node] = 0;
    for (int node = 0; node < count_of(nodes_); ++node)
      if (vertex_[node] == 0) {
        vertex_[node] = count_of(used_);
        used_.push_back(node);
      }
  }

  template <int size>
  Matrix<int, size, Dynamic> vertices_of(
      const std::vector<Element<size>>& elements) const {
    Matrix<int, size, Dynamic> result(size, count_of(elements));
    for (int e = 0; e < count_of(elements); ++e)
      for (int k = 0; k < size; ++k) {
        result(k, e) = vertex_[elements[e].nodes[k]];
        if (result(k, e) < 0)
          refuse("gmsh has left a part of the surface without tetrahedra");
      }
    return result;
  }

  template <int size>
  static std::vector<int> tags_of(const std::vector<Element<size>>& elements) {
    std::vector<int> tags;
    for (const auto& element : elements) tags.push_back(element.tag);
    return tags;
  }

  static void turn_outside_out(SolidMesh& mesh) {
    for (int t = 0; t < mesh.cell_count(); ++t)
      if (signed_volume(mesh, t) < 0)
        std::swap(mesh.cells(2, t), mesh.cells(3, t));
  }

  std::ifstream stream_;
  double scale_;
  std::vector<Vector3d> nodes_;
  std::unordered_map<long, int> index_;  ///< of a node's number
  std::vector<Element<2>> lines_;
  std::vector<Element<3>> triangles_;
  std::vector<Element<4>> tetrahedra_;
  std::vector<int> used_,
      vertex_;  ///< nodes of tetrahedra; the vertex of a node
};

}  // namespace

ModelMesh read_gmsh_model(const std::filesystem::path& file, double scale) {
  return ModelReader(file, scale).mesh();
}

}  // namespace ffcontact::plugin
