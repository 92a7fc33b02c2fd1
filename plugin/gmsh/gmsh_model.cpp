// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/gmsh_model.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ffcontact/base/packed.hpp"
//
#include "freefem/text_file.hpp"

namespace ffcontact::plugin {

namespace {

/// gmsh fills a volume with 0.64 times as many tetrahedra as regular ones of the size
/// asked for would (measured); sizes are multiplied by the cubic root of it.
constexpr double size_factor = 0.86;

/// What gmsh calls an entity: dimension, and number from 1 on.
using Entity = std::pair<int, int>;

/// Writes the entities of a model in the order of their dimensions.
class ModelWriter {
 public:
  ModelWriter(const std::filesystem::path& file, const SolidMesh& mesh,
              const Facets<3>& faces, const SurfaceModel& model, double scale)
      : file_(file),
        mesh_(mesh),
        curves_(model.curves.curves),
        corners_(model.curves.corners),
        triangles_(model.patches.patch_count()),
        points_(mesh.vertices * scale) {
    for (int k = 0; k < model.dividing.count(); ++k)
      triangles_[model.patches.patch[k]].push_back(
          faces.vertices.col(model.dividing.face[k]));
    for (int i = 0; i < count_of(corners_); ++i) number_[corners_[i]] = i + 1;
    place_vertices();
  }

  void write() {
    file_ << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_entities();
    write_nodes();
    write_elements();
    file_.close();
  }

 private:
  /// Each vertex is a node of the entity of least dimension.
  void place_vertices() {
    std::map<int, Entity> entity;
    for (int p = 0; p < count_of(triangles_); ++p)
      for (const Vector3i& triangle : triangles_[p])
        for (const int v : triangle) entity[v] = {2, p + 1};
    for (int c = 0; c < count_of(curves_); ++c)
      for (const int v : curves_[c].vertices) entity[v] = {1, c + 1};
    for (const auto& [v, number] : number_) entity[v] = {0, number};
    for (const auto& [v, of] : entity) nodes_[of].push_back(v);
    node_count_ = count_of(entity);
  }

  void write_point(int v) {
    for (const double x : points_.col(v)) file_ << x << " ";
  }

  template <class Vertices>
  void write_box(const Vertices& vertices) {
    const Matrix3Xd x = points_(Eigen::all, vertices);
    const Vector3d low = x.rowwise().minCoeff(), high = x.rowwise().maxCoeff();
    for (const Vector3d& corner : {low, high})
      for (const double value : corner) file_ << value << " ";
  }

  void write_entities() {
    file_ << "$Entities\n"
          << corners_.size() << " " << curves_.size() << " "
          << triangles_.size() << " 0\n";
    for (const int v : corners_) {
      file_ << number_[v] << " ";
      write_point(v);
      file_ << "0\n";
    }
    for (int c = 0; c < count_of(curves_); ++c) {
      const std::vector<int>& chain = curves_[c].vertices;
      file_ << c + 1 << " ";
      write_box(chain);
      file_ << "0 2 " << number_[chain.front()] << " " << -number_[chain.back()]
            << "\n";
    }
    for (int p = 0; p < count_of(triangles_); ++p) write_surface(p);
    file_ << "$EndEntities\n";
  }

  void write_surface(int p) {
    std::vector<int> vertices, rim;
    for (const Vector3i& triangle : triangles_[p])
      vertices.insert(vertices.end(), triangle.begin(), triangle.end());
    for (int c = 0; c < count_of(curves_); ++c)
      for (const int patch : curves_[c].patches)
        if (patch == p && (rim.empty() || rim.back() != c + 1))
          rim.push_back(c + 1);
    file_ << p + 1 << " ";
    write_box(vertices);
    file_ << "0 " << rim.size();
    for (const int c : rim) file_ << " " << c;
    file_ << "\n";
  }

  void write_nodes() {
    file_ << "$Nodes\n"
          << nodes_.size() << " " << node_count_ << " 1 "
          << mesh_.vertex_count() << "\n";
    for (const auto& [entity, vertices] : nodes_) {
      file_ << entity.first << " " << entity.second << " 0 " << vertices.size()
            << "\n";
      for (const int v : vertices) file_ << v + 1 << "\n";
      for (const int v : vertices) {
        write_point(v);
        file_ << "\n";
      }
    }
    file_ << "$EndNodes\n";
  }

  void start_elements(int dimension, int entity, int type, int count) {
    file_ << dimension << " " << entity << " " << type << " " << count << "\n";
  }

  template <class Vertices>
  void write_element(const Vertices& vertices) {
    file_ << ++last_element_;
    for (const int v : vertices) file_ << " " << v + 1;
    file_ << "\n";
  }

  void write_elements() {
    constexpr int line = 1, triangle = 2, point = 15;
    int count = count_of(corners_);
    for (const PatchCurve& curve : curves_)
      count += count_of(curve.vertices) - 1;
    for (const auto& triangles : triangles_) count += count_of(triangles);
    file_ << "$Elements\n"
          << corners_.size() + curves_.size() + triangles_.size() << " "
          << count << " 1 " << count << "\n";
    for (const int v : corners_) {
      start_elements(0, number_[v], point, 1);
      write_element(std::vector<int>{v});
    }
    for (int c = 0; c < count_of(curves_); ++c) {
      const std::vector<int>& chain = curves_[c].vertices;
      start_elements(1, c + 1, line, count_of(chain) - 1);
      for (std::size_t k = 1; k < chain.size(); ++k)
        write_element(std::vector<int>{chain[k - 1], chain[k]});
    }
    for (int p = 0; p < count_of(triangles_); ++p) {
      start_elements(2, p + 1, triangle, count_of(triangles_[p]));
      for (const Vector3i& vertices : triangles_[p]) write_element(vertices);
    }
    file_ << "$EndElements\n";
  }

  TextFile file_;
  const SolidMesh& mesh_;
  const std::vector<PatchCurve>& curves_;
  const std::vector<int>& corners_;
  std::vector<std::vector<Vector3i>> triangles_;  ///< of each patch
  Matrix3Xd points_;
  std::map<int, int> number_;  ///< of each corner, from 1 on
  std::map<Entity, std::vector<int>> nodes_;
  int node_count_ = 0, last_element_ = 0;
};

/// The patches around each part of the body, as gmsh numbers them.
std::vector<std::string> shells(const SurfaceModel& model) {
  std::vector<std::map<int, int>> around(model.dividing.part_count());
  for (int k = 0; k < model.dividing.count(); ++k)
    for (const int part : model.dividing.parts.col(k))
      if (part >= 0) around[part][model.patches.patch[k]] = 1;
  std::vector<std::string> lists;
  for (const auto& patches : around) {
    std::string list;
    for (const auto& [patch, one] : patches)
      list += (list.empty() ? "" : ", ") + std::to_string(patch + 1);
    lists.push_back(list);
  }
  return lists;
}

}  // namespace

void write_gmsh_model(const std::filesystem::path& file, const SolidMesh& mesh,
                      const Facets<3>& faces, const SurfaceModel& model,
                      double scale) {
  ModelWriter(file, mesh, faces, model, scale).write();
}

void write_gmsh_sizes(const std::filesystem::path& file, const SolidMesh& mesh,
                      const Ref<const VectorXd>& size, double scale) {
  TextFile stream(file);
  stream << "View \"sizes\" {\n";
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const char* before = "SS(";
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 3; ++i) {
        stream << before << scale * mesh.vertices(i, mesh.cells(k, t));
        before = ",";
      }
    before = "){";
    for (const int v : mesh.cells.col(t)) {
      stream << before << scale * size[v];
      before = ",";
    }
    stream << "};\n";
  }
  stream << "};\n";
  stream.close();
}

void write_gmsh_volumes(const std::filesystem::path& file,
                        const SurfaceModel& model) {
  TextFile stream(file);
  stream << "Merge \"model.msh\";\nCreateGeometry;\n";
  int volume = 0;
  for (const std::string& list : shells(model)) {
    ++volume;
    stream << "Surface Loop(" << volume << ") = {" << list << "};\nVolume("
           << volume << ") = {" << volume << "};\n";
  }
  stream << "Merge \"sizes.pos\";\nMesh.MeshSizeFactor = " << size_factor
         << R"(;
Field[1] = PostView;
Field[1].ViewIndex = PostProcessing.NbViews - 1;
Background Field = 1;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.OptimizeThreshold = 0.5;
Mesh.MeshSizeMin = 0;
Mesh.MeshSizeMax = 1e22;
)";
  stream.close();
}

}  // namespace ffcontact::plugin
