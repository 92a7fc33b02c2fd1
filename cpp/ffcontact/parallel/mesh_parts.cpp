// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/mesh_parts.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// The numbers of vertices that are the same where their coordinates are.
template <int dim>
class VerticesByPlace {
 public:
  std::vector<int> numbers_of(const SimplexMesh<dim>& part) {
    std::vector<int> numbers;
    std::map<int, int> own;  // the vertex of each number
    for (int v = 0; v < part.vertex_count(); ++v) {
      numbers.push_back(number_at(part.vertices.col(v)));
      const auto [met, is_new] = own.emplace(numbers.back(), v);
      if (!is_new)
        refuse("vertices ", met->second, " and ", v,
               " of a part are at one place: say with vertexnumbers= and "
               "cellnumbers= which those of the whole mesh are");
    }
    return numbers;
  }

 private:
  /// + 0.0 makes of -0.0 what it is equal to.
  int number_at(const typename SimplexMesh<dim>::Point& x) {
    std::array<double, dim> place;
    for (int c = 0; c < dim; ++c) place[c] = x[c] + 0.0;
    return number_.try_emplace(place, count_of(number_)).first->second;
  }

  std::map<std::array<double, dim>, int> number_;
};

bool are_stated(const std::vector<PartNumbers>& numbers) {
  const auto unknown =
      std::count_if(numbers.begin(), numbers.end(),
                    [](const PartNumbers& part) { return part.empty(); });
  if (unknown > 0 && unknown < count_of(numbers))
    refuse("vertexnumbers= and cellnumbers= are given on some processes only");
  return unknown == 0;
}

void require_numbers(const std::vector<int>& numbers, const char* name,
                     int count) {
  require_size(name, count_of(numbers), count);
  for (int number : numbers)
    if (number < 0) refuse(name, " must not be negative, got ", number);
}

/// Of cells that follow each other.
std::vector<int> consecutive(int first, int count) {
  std::vector<int> numbers(count);
  for (int k = 0; k < count; ++k) numbers[k] = first + k;
  return numbers;
}

template <int dim>
void number_by_place(const std::vector<SimplexMesh<dim>>& meshes,
                     MeshParts<dim>& parts) {
  VerticesByPlace<dim> places;
  int cells = 0;
  for (const SimplexMesh<dim>& mesh : meshes) {
    parts.vertex.push_back(places.numbers_of(mesh));
    parts.cell.push_back(consecutive(cells, mesh.cell_count()));
    cells += mesh.cell_count();
  }
}

template <int dim>
void number_as_stated(const std::vector<SimplexMesh<dim>>& meshes,
                      const std::vector<PartNumbers>& numbers,
                      MeshParts<dim>& parts) {
  for (std::size_t r = 0; r < meshes.size(); ++r) {
    require_numbers(numbers[r].vertex, "vertexnumbers",
                    meshes[r].vertex_count());
    require_numbers(numbers[r].cell, "cellnumbers", meshes[r].cell_count());
    parts.vertex.push_back(numbers[r].vertex);
    parts.cell.push_back(numbers[r].cell);
  }
}

/// Every number below the highest one must be somebody's, those of cells one part's only.
void require_all(const std::vector<std::vector<int>>& numbers, int end,
                 const char* what, bool once) {
  std::vector<int> met(end, 0);
  for (const std::vector<int>& of_part : numbers)
    for (int number : of_part) ++met[number];
  for (int k = 0; k < end; ++k)
    if (met[k] == 0 || (once && met[k] > 1))
      refuse(what, " ", k, " of the whole mesh is in ", met[k], " parts");
}

template <int dim>
void put_vertices(const SimplexMesh<dim>& mesh, const std::vector<int>& number,
                  Flags& known, SimplexMesh<dim>& whole) {
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    auto x = whole.vertices.col(number[v]);
    if (known[number[v]] && x != mesh.vertices.col(v))
      refuse("vertex ", number[v],
             " of the whole mesh is at different places in two parts");
    x = mesh.vertices.col(v);
    known[number[v]] = 1;
  }
}

template <int dim>
void put_cells(const std::vector<SimplexMesh<dim>>& meshes,
               MeshParts<dim>& parts) {
  SimplexMesh<dim>& whole = parts.whole;
  const int vertices = count_in_whole(parts.vertex),
            cells = count_in_whole(parts.cell);
  require_all(parts.vertex, vertices, "vertex", false);
  require_all(parts.cell, cells, MeshWords<dim>::cell, true);
  whole.vertices.resize(dim, vertices);
  whole.cells.resize(dim + 1, cells);
  Flags known(vertices, 0);
  for (std::size_t r = 0; r < meshes.size(); ++r) {
    put_vertices(meshes[r], parts.vertex[r], known, whole);
    for (int t = 0; t < meshes[r].cell_count(); ++t)
      for (int k = 0; k <= dim; ++k)
        whole.cells(k, parts.cell[r][t]) =
            parts.vertex[r][meshes[r].cells(k, t)];
  }
}

/// The vertices of a facet, whatever their order.
template <int dim>
std::array<int, dim> key_of(const Matrix<int, dim, 1>& vertices) {
  std::array<int, dim> key;
  std::copy(vertices.begin(), vertices.end(), key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

/// Column e of a part's boundary in numbers of the whole.
template <int dim>
Matrix<int, dim, 1> facet_of_whole(const SimplexMesh<dim>& mesh,
                                   const std::vector<int>& number, int e) {
  Matrix<int, dim, 1> facet;
  for (int k = 0; k < dim; ++k) facet[k] = number[mesh.boundary(k, e)];
  return facet;
}

/// In how many parts each labelled facet is.
template <int dim>
std::map<std::array<int, dim>, int> shares_of_facets(
    const std::vector<SimplexMesh<dim>>& meshes, const MeshParts<dim>& parts) {
  std::map<std::array<int, dim>, std::pair<int, int>> last;  // part, parts
  for (int r = 0; r < parts.part_count(); ++r)
    for (int e = 0; e < meshes[r].boundary.cols(); ++e) {
      auto& [part, count] =
          last.try_emplace(
                  key_of<dim>(facet_of_whole(meshes[r], parts.vertex[r], e)),
                  -1, 0)
              .first->second;
      count += part != r;
      part = r;
    }
  std::map<std::array<int, dim>, int> shares;
  for (const auto& [facet, met] : last) shares[facet] = met.second;
  return shares;
}

template <int dim>
void put_boundary(const std::vector<SimplexMesh<dim>>& meshes,
                  MeshParts<dim>& parts) {
  const auto shares = shares_of_facets(meshes, parts);
  std::vector<Matrix<int, dim, 1>> facets;
  std::vector<int> labels;
  for (int r = 0; r < parts.part_count(); ++r) {
    std::vector<int> column;
    for (int e = 0; e < meshes[r].boundary.cols(); ++e) {
      const auto facet = facet_of_whole(meshes[r], parts.vertex[r], e);
      const bool is_cut =
          entry_of(shares, key_of<dim>(facet), "count of a facet") > 1;
      column.push_back(is_cut ? -1 : count_of(facets));
      if (is_cut) continue;
      facets.push_back(facet);
      labels.push_back(meshes[r].boundary_label[e]);
    }
    parts.boundary.push_back(std::move(column));
  }
  parts.whole.boundary = packed(facets);
  parts.whole.boundary_label = packed(labels);
}

}  // namespace

int count_in_whole(const std::vector<std::vector<int>>& numbers) {
  int end = 0;
  for (const std::vector<int>& of_part : numbers)
    for (int number : of_part) end = std::max(end, number + 1);
  return end;
}

template <int dim>
MeshParts<dim> joined_parts(const std::vector<SimplexMesh<dim>>& parts,
                            const std::vector<PartNumbers>& numbers) {
  MeshParts<dim> joined;
  if (are_stated(numbers))
    number_as_stated(parts, numbers, joined);
  else
    number_by_place(parts, joined);
  put_cells(parts, joined);
  put_boundary(parts, joined);
  require_valid(joined.whole);
  return joined;
}

template MeshParts<2> joined_parts(const std::vector<Mesh>&,
                                   const std::vector<PartNumbers>&);
template MeshParts<3> joined_parts(const std::vector<SolidMesh>&,
                                   const std::vector<PartNumbers>&);

MatrixXd of_whole(const std::vector<MatrixXd>& parts,
                  const std::vector<std::vector<int>>& number) {
  const Index rows = parts.empty() ? 0 : parts.front().rows();
  MatrixXd whole = MatrixXd::Zero(rows, count_in_whole(number));
  for (std::size_t r = parts.size(); r-- > 0;)
    for (std::size_t k = 0; k < number[r].size(); ++k)
      if (number[r][k] >= 0)
        whole.col(number[r][k]) = parts[r].col(static_cast<Index>(k));
  return whole;
}

}  // namespace ffcontact
