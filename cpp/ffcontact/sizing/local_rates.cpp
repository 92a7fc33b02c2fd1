// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/local_rates.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/plane.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/sizing/energy_exponent.hpp"

namespace ffcontact {

namespace {

constexpr double turning = 0.0175;  ///< sine of one degree
/// of the fit, in element sizes
constexpr double nearest_radius = 2, farthest_radius = 8;

/// Between two boundary edges, by their normals.
bool boundary_turns(const Vector2d& a, const Vector2d& b) {
  return std::abs(cross(a, b)) > turning || a.dot(b) < 0;
}

bool condition_changes(int in, int out, const BoundaryTractions& boundary,
                       const std::vector<int>& contact_edges) {
  return (boundary.known.col(in) != boundary.known.col(out)).any() ||
         (contact_edges[in] >= 0) != (contact_edges[out] >= 0);
}

/// May the stress be singular at a boundary vertex?
bool is_candidate(const Topology<2>& topology, int v,
                  const BoundaryTractions& boundary,
                  const std::vector<int>& contact_edges) {
  const auto& [mesh, edges, ridges, stars] = topology;
  int in = -1, out = -1;
  for_boundary_facets(topology, v, [&](int e) {
    (topology.facets.vertices(0, e) == v ? out : in) = e;
  });
  if (in < 0 || out < 0) return false;
  return boundary_turns(edge_normal(mesh, edges, in),
                        edge_normal(mesh, edges, out)) ||
         condition_changes(in, out, boundary, contact_edges);
}

std::vector<int> candidates(const Topology<2>& topology,
                            const BoundaryTractions& boundary,
                            const std::vector<int>& contact_edges) {
  return numbers_where(topology.mesh.vertex_count(), [&](int v) {
    return is_candidate(topology, v, boundary, contact_edges);
  });
}

double size_at(const Mesh& mesh, const Stars& stars, int v) {
  double area = 0;
  for (int t : stars.cells_of(v)) area += signed_area(mesh, t);
  return std::sqrt(2 * area / stars.count(v));
}

double distance(const Mesh& mesh, int v, int w) {
  return (mesh.vertices.col(w) - mesh.vertices.col(v)).norm();
}

double reach(const Mesh& mesh, const std::vector<int>& others, int v) {
  double nearest = infinity;
  for (int w : others)
    if (w != v) nearest = std::min(nearest, distance(mesh, v, w));
  return nearest < infinity ? 0.5 * nearest : 0;
}

/// int sigma : C^-1 sigma and the place of each triangle.
struct TriangleEnergies {
  VectorXd energy;
  Matrix2Xd centroid;

  TriangleEnergies(const Mesh& mesh, const Hooke& hooke,
                   const Ref<const Matrix3Xd>& stress)
      : energy(mesh.cells.cols()), centroid(2, mesh.cells.cols()) {
    for (int t = 0; t < mesh.cell_count(); ++t) {
      energy[t] =
          signed_area(mesh, t) * energy_density(hooke[t], stress.col(t));
      centroid.col(t) = centroid_of(mesh, t);
    }
  }
  /// sigma : C^-1 sigma
  static double energy_density(const Matrix3d& C, const Vector3d& stress) {
    return stress.dot(C.inverse() * stress);
  }

  Neighbourhood within(double largest, const Vector2d& x) const {
    Neighbourhood near;
    for (Index t = 0; t < energy.size(); ++t) {
      const double distance = (centroid.col(t) - x).norm();
      if (distance <= largest) near.push_back({distance, energy[t]});
    }
    return near;
  }
};

}  // namespace

std::vector<SingularVertex> singular_vertices(
    const Topology<2>& topology, const Hooke& hooke,
    const Ref<const Matrix3Xd>& stress, const BoundaryTractions& boundary,
    const std::vector<int>& contact_edges) {
  const Mesh& mesh = topology.mesh;
  const std::vector<int> vertices =
      candidates(topology, boundary, contact_edges);
  const TriangleEnergies triangles(mesh, hooke, stress);
  const auto exponent_at = [&](int v) {
    const double size = size_at(mesh, topology.stars, v);
    const double largest =
        std::min(reach(mesh, vertices, v), farthest_radius * size);
    const Neighbourhood near = triangles.within(largest, mesh.vertices.col(v));
    return fitted_exponent(near, nearest_radius * size, largest);
  };
  std::vector<SingularVertex> result;
  for (int v : vertices) result.push_back({v, exponent_at(v)});
  return result;
}

VectorXd local_rates(const Topology<2>& topology,
                     const std::vector<SingularVertex>& singular) {
  VectorXd rates = VectorXd::Ones(topology.mesh.cell_count());
  for (const auto& [vertex, exponent] : singular)
    for (int t : topology.stars.cells_of(vertex))
      rates[t] = std::min(rates[t], exponent);
  return rates;
}

}  // namespace ffcontact
