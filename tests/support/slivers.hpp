// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "support/solids.hpp"
#include "support/uniform.hpp"

/// Solids with nearly flat tetrahedra, and nested finer ones of any solid.
namespace ffcontact::test {

/// The smallest angle between two faces of a tetrahedron [rad].
inline double least_dihedral(const CellCorners<3>& x) {
  Matrix<double, 3, 4> n;
  for (int k = 0; k < 4; ++k) {
    Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = x.col(facet_corners<3>[k][i]);
    n.col(k) = facet_vector(corners).normalized();
  }
  double least = M_PI;
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l < k; ++l)
      least = std::min(
          least, std::acos(std::clamp(-n.col(k).dot(n.col(l)), -1.0, 1.0)));
  return least;
}

inline double least_dihedral(const SolidMesh& mesh,
                             const std::vector<int>& cells) {
  double least = M_PI;
  for (int t : cells)
    least = std::min(least, signed_volume(mesh, t) > 0
                                ? least_dihedral(corners_of(mesh, t))
                                : 0);
  return least;
}

/// Moves a vertex towards a point until a tetrahedron at it has an angle so small.
inline void flatten(SolidMesh& mesh, int vertex, const Vector3d& target,
                    const std::vector<int>& star, double angle) {
  const Vector3d start = mesh.vertices.col(vertex);
  double low = 0, high = 1;
  const auto put = [&](double s) {
    mesh.vertices.col(vertex) = (1 - s) * start + s * target;
  };
  while (high - low > 1e-6) {
    const double s = (low + high) / 2;
    put(s);
    (least_dihedral(mesh, star) > angle ? low : high) = s;
  }
  put(low);
}

/// A mesh some of whose inner vertices, no two of them neighbours, are moved towards a face
/// opposite to them until a tetrahedron there has a dihedral angle of so many degrees.
inline SolidMesh with_slivers(SolidMesh mesh, int wanted, double degrees,
                              std::mt19937& random) {
  std::vector<std::vector<int>> star(mesh.vertex_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int v : mesh.cells.col(t)) star[v].push_back(t);
  std::set<int> fixed;
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    for (int v : mesh.boundary.col(f)) fixed.insert(v);
  const Uniform part{0.1, 1};
  for (int tries = 0; wanted > 0 && tries < 1000; ++tries) {
    const int v = static_cast<int>(random() % mesh.vertex_count()),
              t = star[v][random() % star[v].size()];
    if (fixed.count(v)) continue;
    Vector3d target = Vector3d::Zero();
    double sum = 0;
    for (int w : mesh.cells.col(t))
      if (w != v) {
        const double weight = part(random);
        target += weight * mesh.vertices.col(w);
        sum += weight;
      }
    flatten(mesh, v, target / sum, star[v], degrees * M_PI / 180);
    for (int s : star[v])
      for (int w : mesh.cells.col(s)) fixed.insert(w);
    --wanted;
  }
  return mesh;
}

/// Every tetrahedron cut into eight.
struct Subdivided {
  SolidMesh mesh;
  std::vector<std::array<int, 2>>
      halved;  ///< ends of the edges with new vertices

  explicit Subdivided(const SolidMesh& coarse) : mesh(coarse) {
    const int old = coarse.vertex_count();
    std::map<std::pair<int, int>, int> number;
    const auto middle = [&](int a, int b) {
      const auto [place, is_new] = number.emplace(
          std::minmax(a, b), old + static_cast<int>(halved.size()));
      if (is_new) halved.push_back({a, b});
      return place->second;
    };
    mesh.cells.resize(4, 8 * coarse.cell_count());
    for (int t = 0; t < coarse.cell_count(); ++t) {
      const Vector4i v = coarse.cells.col(t);
      const int a = v[0], b = v[1], c = v[2], d = v[3], ab = middle(a, b),
                ac = middle(a, c), ad = middle(a, d), bc = middle(b, c),
                bd = middle(b, d), cd = middle(c, d);
      mesh.cells.middleCols<8>(8 * t) << a, ab, ac, ad, ab, ab, ac, ac,  //
          ab, b, bc, bd, ac, bc, ad, bc,                                 //
          ac, bc, c, cd, ad, ac, bd, cd,                                 //
          ad, bd, cd, d, bd, bd, cd, bd;
    }
    mesh.boundary.resize(3, 4 * coarse.boundary.cols());
    mesh.boundary_label.resize(mesh.boundary.cols());
    for (Index f = 0; f < coarse.boundary.cols(); ++f) {
      const Vector3i v = coarse.boundary.col(f);
      const int a = v[0], b = v[1], c = v[2], ab = middle(a, b),
                ac = middle(a, c), bc = middle(b, c);
      mesh.boundary.middleCols<4>(4 * f) << a, ab, ac, ab,  //
          ab, b, bc, bc,                                    //
          ac, bc, c, ac;
      mesh.boundary_label.segment<4>(4 * f).setConstant(
          coarse.boundary_label[f]);
    }
    mesh.vertices.conservativeResize(3, old + halved.size());
    for (std::size_t e = 0; e < halved.size(); ++e)
      mesh.vertices.col(old + e) =
          (mesh.vertices.col(halved[e][0]) + mesh.vertices.col(halved[e][1])) /
          2;
  }

  /// Values at its vertices of a field on the coarse mesh.
  VectorXd values(const VectorXd& coarse) const {
    VectorXd fine(3 * mesh.vertices.cols());
    fine.head(coarse.size()) = coarse;
    for (std::size_t e = 0; e < halved.size(); ++e)
      fine.segment<3>(coarse.size() + 3 * e) =
          (coarse.segment<3>(3 * halved[e][0]) +
           coarse.segment<3>(3 * halved[e][1])) /
          2;
    return fine;
  }
};

}  // namespace ffcontact::test
