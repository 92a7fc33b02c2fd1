// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/splitting/solid_cell_split.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/mesh/splitting/quadrangle_triangles.hpp"

namespace ffcontact {

namespace {

using CornerList = std::vector<int>;
using TetrahedronList = std::vector<Vector4i>;
/// The triangles of a face, which run counter-clockwise seen from outside.
using CutFace = std::vector<Vector3i>;
using CutSurface = std::vector<CutFace>;

/// CornerList of the faces, counter-clockwise seen from outside.
const std::vector<CornerList> pyramid_faces = {
    {0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
const std::vector<CornerList> prism_faces = {
    {0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
const std::vector<CornerList> hexahedron_faces = {{0, 3, 2, 1}, {4, 5, 6, 7},
                                                  {0, 1, 5, 4}, {1, 2, 6, 5},
                                                  {2, 3, 7, 6}, {3, 0, 4, 7}};

/// A hexahedron turned so that each diagonal of each pair of opposite faces is once 0-2
/// of the lower face.
const std::vector<CornerList> turned_hexahedra = {
    {0, 1, 2, 3, 4, 5, 6, 7}, {1, 2, 3, 0, 5, 6, 7, 4},
    {0, 4, 5, 1, 3, 7, 6, 2}, {4, 5, 1, 0, 7, 6, 2, 3},
    {0, 3, 7, 4, 1, 2, 6, 5}, {3, 7, 4, 0, 2, 6, 5, 1}};

const std::vector<CornerList>& faces_of(const CornerList& cell) {
  return cell.size() == 5   ? pyramid_faces
         : cell.size() == 6 ? prism_faces
                            : hexahedron_faces;
}

CornerList picked(const CornerList& from, const CornerList& places) {
  CornerList result;
  for (const int place : places) result.push_back(from[place]);
  return result;
}

bool has_corner(const Vector3i& triangle, int corner) {
  return (triangle.array() == corner).any();
}

/// Whether all triangles of the faces at a corner have it.
bool meet_in(int corner, const CutSurface& surface) {
  const auto has = [&](const Vector3i& t) { return has_corner(t, corner); };
  return std::all_of(surface.begin(), surface.end(), [&](const CutFace& face) {
    return std::all_of(face.begin(), face.end(), has) ||
           std::none_of(face.begin(), face.end(), has);
  });
}

/// An apex and the triangles of the surface without it.
TetrahedronList cone(int apex, const CutSurface& surface) {
  TetrahedronList tetrahedra;
  for (const CutFace& face : surface)
    for (const Vector3i& t : face)
      if (!has_corner(t, apex)) tetrahedra.emplace_back(apex, t[0], t[1], t[2]);
  return tetrahedra;
}

class SplitOfCell {
 public:
  SplitOfCell(const Matrix3Xd& corners, const VectorXi& numbers)
      : x_(3, corners.cols() + 1), numbers_(numbers), cell_(corners.cols()) {
    std::iota(cell_.begin(), cell_.end(), 0);
    x_ << corners, corners.rowwise().mean();
    const Vector3d box =
        corners.rowwise().maxCoeff() - corners.rowwise().minCoeff();
    flat_ = flat_body * std::pow(box.norm(), 3);
  }

  SolidCellSplit split() {
    const CutSurface surface = surface_of(cell_);
    if (surface.empty()) return {};
    set_orientation(surface);
    TetrahedronList best = from_corner(cell_);
    if (best.empty() && cell_.size() == 8) best = by_prisms();
    const bool has_middle = best.empty();
    if (has_middle) take_better(cone(middle(), surface), best);
    if (mirrored_)
      for (Vector4i& tetrahedron : best)
        std::swap(tetrahedron[2], tetrahedron[3]);
    return {best, has_middle && !best.empty()};
  }

 private:
  int middle() const { return count_of(cell_); }

  /// Empty where a quadrangle has no diagonal inside.
  CutSurface surface_of(const CornerList& cell) const {
    CutSurface surface;
    for (const CornerList& places : faces_of(cell)) {
      const CutFace face = cut(picked(cell, places));
      if (face.empty()) return {};
      surface.push_back(face);
    }
    return surface;
  }

  CutFace cut(const CornerList& face) const {
    if (face.size() == 3) return {{face[0], face[1], face[2]}};
    const auto halves =
        quadrangle_triangles(x_(Eigen::all, face), numbers_(face));
    if (!halves) return {};
    CutFace triangles;
    for (const Vector3i& t : *halves)
      triangles.emplace_back(face[t[0]], face[t[1]], face[t[2]]);
    return triangles;
  }

  double signed_volume_of(const Vector4i& t) const {
    const Vector3d a = x_.col(t[1]) - x_.col(t[0]),
                   b = x_.col(t[2]) - x_.col(t[0]),
                   c = x_.col(t[3]) - x_.col(t[0]);
    return (mirrored_ ? -1 : 1) * a.cross(b).dot(c) / 6;
  }

  void set_orientation(const CutSurface& surface) {
    double volume = 0;
    for (const Vector4i& t : cone(middle(), surface))
      volume += signed_volume_of(t);
    mirrored_ = volume < 0;
  }

  /// Volume of the smallest tetrahedron, 0 where there is none.
  double smallest(const TetrahedronList& tetrahedra) const {
    double volume = 0;
    for (const Vector4i& t : tetrahedra)
      volume = &t == tetrahedra.data() ? signed_volume_of(t)
                                       : std::min(volume, signed_volume_of(t));
    return volume;
  }

  /// The candidate if all of it is larger than flat and than the best so far.
  void take_better(const TetrahedronList& candidate,
                   TetrahedronList& best) const {
    constexpr double rounding = 1e-9;
    const double wanted = std::max(flat_, (1 + rounding) * smallest(best));
    if (smallest(candidate) > wanted) best = candidate;
  }

  /// Step 1 of the header; empty where there is no such corner.
  TetrahedronList from_corner(const CornerList& cell) const {
    TetrahedronList best;
    const CutSurface surface = surface_of(cell);
    for (const int corner : cell)
      if (!surface.empty() && meet_in(corner, surface))
        take_better(cone(corner, surface), best);
    return best;
  }

  bool has_diagonal(const CornerList& face, int from, int to) const {
    const CutFace triangles = cut(face);
    return std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
      return has_corner(t, from) && has_corner(t, to);
    });
  }

  /// Step 2; empty where no two diagonals are parallel, or a prism has none of step 1.
  /// The quadrangle between the prisms is cut as all others are: where both need it they
  /// agree.
  TetrahedronList by_prisms() const {
    TetrahedronList best;
    for (const CornerList& c : turned_hexahedra) {
      if (!has_diagonal(picked(c, {0, 1, 2, 3}), c[0], c[2]) ||
          !has_diagonal(picked(c, {4, 5, 6, 7}), c[4], c[6]))
        continue;
      TetrahedronList both = from_corner(picked(c, {0, 1, 2, 4, 5, 6}));
      const TetrahedronList other = from_corner(picked(c, {0, 2, 3, 4, 6, 7}));
      if (both.empty() || other.empty()) continue;
      both.insert(both.end(), other.begin(), other.end());
      take_better(both, best);
    }
    return best;
  }

  Matrix3Xd x_;  ///< corners, and the middle
  const VectorXi& numbers_;
  CornerList cell_;
  double flat_;            ///< volume below which a tetrahedron is flat
  bool mirrored_ = false;  ///< with respect to gmsh's order
};

}  // namespace

SolidCellSplit solid_cell_split(const Matrix3Xd& corners,
                                const VectorXi& numbers) {
  return SplitOfCell(corners, numbers).split();
}

}  // namespace ffcontact
