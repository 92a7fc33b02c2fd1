// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/edge_rates.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/tractions/wrench_basis.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/sizing/cell_shape.hpp"
#include "ffcontact/sizing/energy_exponent.hpp"

namespace ffcontact {

namespace {

const double blunt = std::cos(M_PI / 6);  ///< turns by less go on
/// of the fit, in element sizes
constexpr double nearest_in_space = 1.5, farthest_in_space = 8;

/// The two boundary faces at a boundary edge.
Vector2i boundary_faces(const Topology<3>& topology, int edge) {
  std::vector<int> found;
  for (int face : topology.ridges.facets_of(edge))
    if (topology.facets.on_boundary(face)) found.push_back(face);
  return {found[0], found[1]};
}

/// Does the surface turn, or its condition change, between the faces at a boundary edge?
bool is_singular(const Topology<3>& topology, int edge,
                 const KnownComponents& known, const Flags& is_contact) {
  const auto& [mesh, faces, edges, stars] = topology;
  const Vector2i sides = boundary_faces(topology, edge);
  const int a = sides[0], b = sides[1];
  const double cosine =
      facet_normal(mesh, faces, a).dot(facet_normal(mesh, faces, b));
  return cosine < blunt || (known.col(a) != known.col(b)).any() ||
         is_contact[a] != is_contact[b];
}

std::vector<int> singular_edges(const Topology<3>& topology,
                                const KnownComponents& known,
                                const Flags& is_contact) {
  const Ridges<3>& edges = topology.ridges;
  return numbers_where(edges.count(), [&](int e) {
    return edges.on_boundary[e] && is_singular(topology, e, known, is_contact);
  });
}

Vector3d along(const Topology<3>& topology, int edge) {
  return edge_vector(topology.mesh, topology.ridges, edge);
}

/// Singular edges one after the other, each line once.
class LinesOfEdges {
 public:
  LinesOfEdges(const Topology<3>& topology, const std::vector<int>& edges)
      : topology_(topology) {
    for (int e : edges)
      for (int v : topology.ridges.vertices.col(e)) at_vertex_[v].push_back(e);
    for (int e : edges) left_[e] = true;
    for (int e : edges)
      if (left_[e]) lines.push_back(line_through(e));
  }

  std::vector<std::vector<int>> lines;

 private:
  /// The edge that goes on at a vertex, or -1.
  int next(int edge, int vertex) const {
    const std::vector<int>& around =
        entry_of(at_vertex_, vertex, "singular edge at a vertex");
    if (around.size() != 2) return -1;
    const int other = around[0] == edge ? around[1] : around[0];
    const double cosine = along(topology_, edge)
                              .normalized()
                              .dot(along(topology_, other).normalized());
    const bool same_way = topology_.ridges.vertices(0, edge) !=
                              topology_.ridges.vertices(0, other) &&
                          topology_.ridges.vertices(1, edge) !=
                              topology_.ridges.vertices(1, other);
    return (same_way ? cosine : -cosine) > blunt ? other : -1;
  }

  /// Takes the edges that go on from one of its ends.
  std::vector<int> taken_from(int edge, int vertex) {
    std::vector<int> taken;
    for (int e = next(edge, vertex); e >= 0 && left_[e]; e = next(e, vertex)) {
      left_[e] = false;
      taken.push_back(e);
      const Vector2i ends = topology_.ridges.vertices.col(e);
      vertex = ends[0] == vertex ? ends[1] : ends[0];
    }
    return taken;
  }

  std::vector<int> line_through(int edge) {
    left_[edge] = false;
    const Vector2i ends = topology_.ridges.vertices.col(edge);
    std::vector<int> line = taken_from(edge, ends[0]);
    std::reverse(line.begin(), line.end());
    line.push_back(edge);
    for (int e : taken_from(edge, ends[1])) line.push_back(e);
    return line;
  }

  const Topology<3>& topology_;
  std::map<int, std::vector<int>> at_vertex_;
  std::map<int, bool> left_;
};

/// A line, its middle half, and its length.
struct MeasuredLine {
  std::vector<int> edges;
  Flags is_inside;  ///< in the middle half
  double length = 0;

  MeasuredLine(const Topology<3>& topology, std::vector<int> line)
      : edges(std::move(line)) {
    std::vector<double> place;
    for (int e : edges) {
      const double own = along(topology, e).norm();
      place.push_back(length + own / 2);
      length += own;
    }
    for (double x : place)
      is_inside.push_back(std::abs(x - length / 2) <= length / 4);
  }
};

double distance_to(const Topology<3>& topology, int edge, const Vector3d& x) {
  const int start = topology.ridges.vertices(0, edge);
  const Vector3d from = x - topology.mesh.vertices.col(start),
                 d = along(topology, edge);
  const double place = std::clamp(from.dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (from - place * d).norm();
}

bool share_a_vertex(const Topology<3>& topology, int edge, int other) {
  for (int v : topology.ridges.vertices.col(edge))
    for (int w : topology.ridges.vertices.col(other))
      if (v == w) return true;
  return false;
}

bool touch(const Topology<3>& topology, const std::vector<int>& line,
           const std::vector<int>& other) {
  for (int e : line)
    for (int f : other)
      if (share_a_vertex(topology, e, f)) return true;
  return false;
}

/// From the middle half.
double distance_to(const Topology<3>& topology, const MeasuredLine& line,
                   const Vector3d& x) {
  double nearest = infinity;
  for (std::size_t k = 0; k < line.edges.size(); ++k)
    if (line.is_inside[k])
      nearest = std::min(nearest, distance_to(topology, line.edges[k], x));
  return nearest;
}

/// Half the way from the middle half to the next line that does not touch this one.
double room_beside(const Topology<3>& topology, const MeasuredLine& line,
                   const std::vector<std::vector<int>>& lines) {
  const auto& [mesh, faces, edges, stars] = topology;
  double nearest = infinity;
  for (const std::vector<int>& other : lines) {
    if (touch(topology, line.edges, other)) continue;
    for (int e : other)
      nearest = std::min(nearest, distance_to(topology, line,
                                              ridge_middle<3>(mesh, edges, e)));
  }
  return nearest / 2;
}

/// int sigma : C^-1 sigma, place and size of each tetrahedron.
struct TetrahedronEnergies {
  VectorXd energy, size;
  Matrix3Xd centroid;

  TetrahedronEnergies(const SolidMesh& mesh, const HookeTensors<3>& hooke,
                      const Ref<const CellStresses<3>>& stress)
      : energy(mesh.cell_count()),
        size(mesh.cell_count()),
        centroid(3, mesh.cell_count()) {
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const double volume = signed_volume(mesh, t);
      energy[t] = volume * stress.col(t).dot(hooke[t].inverse() *
                                             Vector6d(stress.col(t)));
      size[t] = size_of_volume<3>(volume);
      centroid.col(t) = corners_of(mesh, t).rowwise().mean();
    }
  }
};

std::vector<int> tetrahedra_at(const Topology<3>& topology,
                               const std::vector<int>& edges) {
  std::vector<int> found;
  const Stars& stars = topology.stars;
  for (int e : edges)
    for (int v : topology.ridges.vertices.col(e))
      for (int t : stars.cells_of(v)) found.push_back(t);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// The box around a line and what is nearer than `margin`.
Eigen::AlignedBox3d box_around(const Topology<3>& topology,
                               const std::vector<int>& line, double margin) {
  Eigen::AlignedBox3d box;
  for (int e : line)
    for (int v : topology.ridges.vertices.col(e))
      box.extend(Vector3d(topology.mesh.vertices.col(v)));
  const Vector3d around = Vector3d::Constant(margin);
  return {box.min() - around, box.max() + around};
}

/// The edge of a line that is nearest to a point, by its place in the line.
struct NearestEdge {
  std::size_t place = 0;
  double distance = infinity;
};

NearestEdge nearest_edge(const Topology<3>& topology,
                         const std::vector<int>& line, const Vector3d& x) {
  NearestEdge nearest;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const double distance = distance_to(topology, line[k], x);
    if (distance < nearest.distance) nearest = {k, distance};
  }
  return nearest;
}

/// What is nearer than `largest` to the middle half.
Neighbourhood near(const Topology<3>& topology, const MeasuredLine& line,
                   const TetrahedronEnergies& tetrahedra, double largest) {
  const Eigen::AlignedBox3d box = box_around(topology, line.edges, largest);
  Neighbourhood found;
  for (int t = 0; t < topology.mesh.cell_count(); ++t) {
    const Vector3d x = tetrahedra.centroid.col(t);
    if (!box.contains(x)) continue;
    const auto [place, distance] = nearest_edge(topology, line.edges, x);
    if (line.is_inside[place] && distance <= largest)
      found.push_back({distance, tetrahedra.energy[t]});
  }
  return found;
}

/// 1 where there is no room for a fit.
double exponent_about(const Topology<3>& topology, const MeasuredLine& line,
                      const std::vector<std::vector<int>>& lines,
                      const TetrahedronEnergies& tetrahedra) {
  const double size =
                   tetrahedra.size(tetrahedra_at(topology, line.edges)).mean(),
               smallest = nearest_in_space * size;
  double largest = std::min(line.length / 4, farthest_in_space * size);
  if (largest < smallest) return 1;
  largest = std::min(largest, room_beside(topology, line, lines));
  return fitted_exponent(near(topology, line, tetrahedra, largest), smallest,
                         largest);
}

}  // namespace

std::vector<SingularLine> singular_lines(
    const Topology<3>& topology, const HookeTensors<3>& hooke,
    const Ref<const CellStresses<3>>& stress, const KnownComponents& known,
    const Flags& is_contact) {
  const LinesOfEdges all(topology, singular_edges(topology, known, is_contact));
  const TetrahedronEnergies tetrahedra(topology.mesh, hooke, stress);
  std::vector<SingularLine> result;
  for (const std::vector<int>& edges : all.lines)
    result.push_back({edges, exponent_about(topology, {topology, edges},
                                            all.lines, tetrahedra)});
  return result;
}

VectorXd local_rates(const Topology<3>& topology,
                     const std::vector<SingularLine>& singular) {
  VectorXd rates = VectorXd::Ones(topology.mesh.cell_count());
  for (const auto& [edges, exponent] : singular)
    for (int t : tetrahedra_at(topology, edges))
      rates[t] = std::min(rates[t], exponent);
  return rates;
}

}  // namespace ffcontact
