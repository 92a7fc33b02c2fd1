// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/displacement/jump_on_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/displacement/following_faces.hpp"
#include "ffcontact/estimate/error/facet_oscillation.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// Parts of an edge below this are rounding.
constexpr double no_part_of_edge = 1e-9;

/// The local vertices of the edges of a cell, and of the sides of a face.
constexpr std::array<std::array<int, 2>, 6> edges_of_cell{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<int, 2>, 3> sides_of_face{
    {{1, 2}, {2, 0}, {0, 1}}};

/// An edge by its vertices, the lower one first, and h at places on it by its second
/// coordinate.
using Edge = std::pair<int, int>;
using JumpsAlong = std::vector<std::pair<double, Vector3d>>;

Edge edge_between(int a, int b) { return std::minmax(a, b); }

/// int C eps(v) : eps(v) of a linear displacement of a cell, by its values at the vertices.
double energy(const SolidMesh& mesh, const HookeTensors<3>& hooke, int cell,
              const Matrix<double, 3, 4>& values) {
  const Matrix3d gradient = values * hat_gradients(mesh, cell).transpose();
  VoigtVector<3> strain;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      strain[voigt_place<3>[i][j]] =
          i == j ? gradient(i, i) : gradient(i, j) + gradient(j, i);
  return signed_volume(mesh, cell) * strain.dot(hooke[cell] * strain);
}

/// From 0 at one end to 0 at the other.
JumpsAlong sorted(JumpsAlong along) {
  along.emplace_back(0, Vector3d::Zero());
  along.emplace_back(1, Vector3d::Zero());
  std::stable_sort(
      along.begin(), along.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
  return along;
}

Vector3d jump_at(const JumpsAlong& along, double place) {
  std::size_t k = 1;
  while (k + 1 < along.size() && along[k].first < place) ++k;
  const auto& [s, h] = along[k - 1];
  const double length = along[k].first - s;
  if (length < no_part_of_edge) return h;
  return h + (place - s) / length * (along[k].second - h);
}

/// How far the jumps along an edge by one of its faces are from those by the other.
double disagreement(const JumpsAlong& some, const JumpsAlong& others) {
  double largest = 0;
  for (const auto& [place, h] : some)
    largest = std::max(largest, (h - jump_at(others, place)).norm());
  return largest;
}

class Jump {
 public:
  Jump(const Topology<3>& topology, const ContactSurface& surface,
       const HookeTensors<3>& hooke, const Flags& prescribed,
       const Ref<const VectorXd>& displacement, Flags slides)
      : mesh_(topology.mesh),
        faces_(topology.facets),
        surface_(surface),
        hooke_(hooke),
        prescribed_(prescribed),
        slides_(std::move(slides)),
        u_(displacement),
        parts_(following_parts(faces_, surface)),
        follows_(faces_.count(), 0) {
    slides_.resize(faces_.count(), 0);
  }

  BondedJump found() && {
    if (!surface_.against_a_body()) leave_at_nodes();
    for (const FollowingPart& part : parts_) add(part);
    compare_by_faces();
    for (const FollowingPart& part : parts_) leave_on_followed(part);
    add_faces();
    add_edges();
    result_.norm = norm_.norm();
    return result_;
  }

 private:
  void leave(double jump, int vertex) {
    if (jump <= result_.left.depth) return;
    Index node;
    (mesh_.vertices(Eigen::all, surface_.vertex).colwise() -
     mesh_.vertices.col(vertex))
        .colwise()
        .squaredNorm()
        .minCoeff(&node);
    result_.left = {jump, static_cast<int>(node)};
  }

  /// On a rigid foundation, where nothing jumps between the nodes that does not at them.
  void leave_at_nodes() {
    for (const int v : surface_.vertex) leave(vector_at<3>(u_, v).norm(), v);
  }

  void add(const FollowingPart& part) {
    const Matrix3d jumps = part.jumps(faces_, u_);
    const auto vertices = faces_.vertices.col(part.face);
    follows_[part.face] = part.is_covered;
    if (part.is_covered)  // also where nothing jumps between the ends
      for (const auto& [a, b] : sides_of_face)
        along_[edge_between(vertices[a], vertices[b])][part.face];
    for (Index corner = 0; corner < part.place.cols(); ++corner) {
      const Vector3d place = part.place.col(corner), h = jumps * place;
      const int across = part.vertex_across(corner);
      if (!part.is_covered || part.vertex_at(corner) >= 0)
        leave(h.norm(), vertices[0]);
      else if (across >= 0)
        add_on_side(part.face, across, place, h);
    }
  }

  void add_on_side(int face, int across, const Vector3d& place,
                   const Vector3d& h) {
    const auto vertices = faces_.vertices.col(face);
    auto [a, b] = sides_of_face[across];
    if (vertices[a] > vertices[b]) std::swap(a, b);
    along_[{vertices[a], vertices[b]}][face].emplace_back(place[b], h);
  }

  /// Along an edge where the surface turns its faces may face different places.
  void compare_by_faces() {
    for (auto& [edge, by_face] : along_) {
      for (auto& [face, along] : by_face) along = sorted(std::move(along));
      const JumpsAlong &first = by_face.begin()->second,
                       &last = by_face.rbegin()->second;
      leave(disagreement(first, last), edge.first);
      leave(disagreement(last, first), edge.first);
    }
  }

  /// What is followed must not move by a w of its own.
  void leave_on_followed(const FollowingPart& part) {
    const auto vertices = faces_.vertices.col(part.followed);
    for (const auto& [a, b] : sides_of_face) {
      const auto along = along_.find(edge_between(vertices[a], vertices[b]));
      if (along == along_.end()) continue;
      for (const auto& [place, h] : along->second.begin()->second)
        leave(h.norm(), vertices[a]);
    }
  }

  /// w of the cells with a face that follows.
  void add_faces() {
    std::map<int, double> squares;
    for (const FollowingPart& part : parts_) {
      if (!part.is_covered) continue;
      const int cell = faces_.cells(0, part.face);
      const Matrix3d jumps = part.jumps(faces_, u_);
      Matrix<double, 3, 4> values = Matrix<double, 3, 4>::Zero();
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 3; ++l)
          if (mesh_.cells(k, cell) == faces_.vertices(l, part.face))
            values.col(k) = jumps.col(l);
      squares[part.face] +=
          share_of(part.place) * energy(mesh_, hooke_, cell, values);
    }
    for (const auto& [face, square] : squares)
      norm_.add(faces_.cells(0, face), square);
  }

  /// w of the other cells around edges of these faces.
  void add_edges() {
    Flags is_end(mesh_.vertex_count(), 0);
    for (const auto& [edge, by_face] : along_)
      is_end[edge.first] = is_end[edge.second] = 1;
    for (int t = 0; t < mesh_.cell_count(); ++t)
      for (const auto& [a, b] : edges_of_cell)
        if (is_end[mesh_.cells(a, t)] && is_end[mesh_.cells(b, t)])
          add_edge(t, a, b);
  }

  /// By the faces on both sides of it a cell has it once or twice.
  void add_edge(int cell, int a, int b) {
    if (mesh_.cells(a, cell) > mesh_.cells(b, cell)) std::swap(a, b);
    const auto found =
        along_.find({mesh_.cells(a, cell), mesh_.cells(b, cell)});
    if (found == along_.end()) return;
    const JumpsAlong& along = found->second.begin()->second;
    int times = -1;
    for (int k = 0; k < 4; ++k) {
      if (k == a || k == b) continue;
      const int face = faces_.of_cell(k, cell);
      times += follows_[face];
      if (!follows_[face]) leave_on_support(face, along);
    }
    if (times != 0) norm_.add(cell, times * times * square(along, cell, a, b));
  }

  /// What supports hold on all of a face beside an edge does not follow, nor does what slides.
  void leave_on_support(int face, const JumpsAlong& along) {
    if (!faces_.on_boundary(face)) return;
    const auto vertices = faces_.vertices.col(face);
    if (slides_[face])
      for (const auto& [place, h] : along) leave(h.norm(), vertices[0]);
    for (int c = 0; c < 3; ++c) {
      bool is_held = true;
      for (const int v : vertices)
        is_held = is_held && prescribed_[dof_of<3>(v, c)];
      if (is_held)
        for (const auto& [place, h] : along) leave(std::abs(h[c]), vertices[0]);
    }
  }

  double square(const JumpsAlong& along, int cell, int a, int b) const {
    double sum = 0;
    for (std::size_t k = 1; k < along.size(); ++k) {
      const auto& [s, h] = along[k - 1];
      const double length = along[k].first - s;
      if (length < no_part_of_edge) continue;
      const Vector3d slope = (along[k].second - h) / length;
      Matrix<double, 3, 4> values = Matrix<double, 3, 4>::Zero();
      values.col(a) = h - s * slope;
      values.col(b) = values.col(a) + slope;
      sum += length * energy(mesh_, hooke_, cell, values);
    }
    return sum;
  }

  const SolidMesh& mesh_;
  const Facets<3>& faces_;
  const ContactSurface& surface_;
  const HookeTensors<3>& hooke_;
  const Flags& prescribed_;
  Flags slides_;  ///< of each facet of the mesh
  const VectorXd u_;
  std::vector<FollowingPart> parts_;
  Flags follows_;  ///< of each facet of the mesh
  std::map<Edge, std::map<int, JumpsAlong>> along_;  ///< by its faces
  OscillationSum norm_;
  BondedJump result_;
};

}  // namespace

BondedJump bonded_jump(const Topology<3>& topology,
                       const ContactSurface& surface,
                       const HookeTensors<3>& hooke, const Flags& prescribed,
                       const Ref<const VectorXd>& displacement,
                       const Flags& slides) {
  return Jump(topology, surface, hooke, prescribed, displacement, slides)
      .found();
}

}  // namespace ffcontact
