// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/stiffness.hpp"
#include "ffcontact/interface/joined_contact.hpp"
#include "ffcontact/interface/line_ends.hpp"
#include "ffcontact/interface/pairing/facing_line.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "support/problems.hpp"

/// Contact problems of several bodies.
namespace ffcontact::test {

/// Body `first` carries the multipliers on one of its labels and faces a label of body
/// `second`.
struct Pair {
  int first, first_label, second, second_label;
};

struct Bodies {
  JoinedMesh joined;
  Problem problem;
  std::vector<FacingTraces> traces;  ///< per pair
  int label(int body, int own) const { return joined.label(body, own); }
};

/// Bodies without loads and supports, and without friction; gaps are those of the meshes.
inline Bodies bodies(const std::vector<Mesh>& meshes,
                     const std::vector<Material>& materials,
                     const std::vector<Pair>& pairs,
                     const std::vector<Vector2d>& directions = {}) {
  Bodies result;
  result.joined = joined_mesh(meshes);
  const Mesh& mesh = result.joined.mesh;
  result.problem = body(mesh, materials[0],
                        {result.label(pairs[0].first, pairs[0].first_label)});
  Problem& problem = result.problem;
  for (std::size_t k = 0; k < meshes.size(); ++k)
    for (int t = result.joined.first_cell[k];
         t < result.joined.first_cell[k + 1]; ++t)
      problem.hooke[t] = materials[k].hooke();
  problem.A = stiffness(mesh, problem.hooke);
  std::vector<ContactLine> lines;
  std::vector<double> gaps;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    ContactLine line =
        contact_line(mesh, problem.edges,
                     {result.label(pairs[k].first, pairs[k].first_label)});
    if (!directions.empty()) {
      line = smooth_contact_line(
          mesh, problem.edges,
          {result.label(pairs[k].first, pairs[k].first_label)});
      line = along_directions(mesh, problem.edges, line,
                              directions[k].replicate(1, line.node_count()));
    }
    result.traces.push_back(
        facing_traces(mesh, problem.edges, line,
                      {result.label(pairs[k].second, pairs[k].second_label)}));
    lines.push_back(
        facing_line(mesh, problem.edges, line, result.traces.back()));
    const VectorXd gap = facing_gap(lines.back());
    gaps.insert(gaps.end(), gap.begin(), gap.end());
  }
  problem.line = joined_contact<2>(lines);
  problem.law.friction = everywhere(problem.line, 0);
  problem.law.gap = Map<VectorXd>(gaps.data(), static_cast<Index>(gaps.size()));
  return result;
}

inline Mesh shifted(Mesh mesh, const Vector2d& by) {
  mesh.vertices.colwise() += by;
  return mesh;
}

/// A rectangle whose vertices on top and bottom are at random places.
inline Mesh with_random_rows(int nx, int ny, double width, double height,
                             std::mt19937& random) {
  return moved(rectangle(nx, ny, width, height),
               std::min(width / nx, height / ny), 0.2, random);
}

/// Example 3 of [CHH01]: a square 100 x 100 pressed by 10 MPa on the middle of a square
/// 200 x 200.
/// @param cells  along the upper square's side, and along the lower one's
inline Bodies example_3(Multiplier multiplier, int upper = 8, int lower = 16) {
  Bodies two = bodies({shifted(rectangle(upper, upper, 100, 100), {50, 200}),
                       rectangle(lower, lower, 200, 200)},
                      {material(200e3, 0.25), material(200e3, 0.25)},
                      {{0, bottom, 1, top}});
  Problem& problem = two.problem;
  add_traction(problem, two.label(0, top), {0, -10});
  prescribe(problem, two.label(1, bottom), 1);
  prescribe_dof(problem, 2 * two.joined.first_vertex[1], 0);
  set_friction(problem, 0.3);
  problem.law.multiplier = multiplier;
  return two;
}

}  // namespace ffcontact::test
