// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/interface/bonded_line.hpp"
#include "ffcontact/interface/pairing/constant_ends.hpp"
#include "support/bodies.hpp"
#include "support/random.hpp"

/// Bodies that are glued to each other.
namespace ffcontact::test {

/// The line of a pair that is bonded.
inline ContactLine bonded_pair(const Bodies& bodies, const Pair& pair) {
  const Problem& problem = bodies.problem;
  const ContactLine line =
      bonded_line(problem.mesh, problem.edges,
                  {bodies.label(pair.first, pair.first_label)});
  return with_constant_ends(
      problem.mesh, problem.edges,
      facing_line(
          problem.mesh, problem.edges, line,
          facing_traces(problem.mesh, problem.edges, line,
                        {bodies.label(pair.second, pair.second_label)})));
}

/// Bodies without loads and supports, bonded along the lines of some pairs.
inline Bodies bonded_bodies(const std::vector<Mesh>& meshes,
                            const std::vector<Material>& materials,
                            const std::vector<Pair>& pairs) {
  Bodies result = bodies(meshes, materials, pairs);
  std::vector<ContactLine> lines;
  for (const Pair& pair : pairs) lines.push_back(bonded_pair(result, pair));
  result.problem.line = joined_contact<2>(lines);
  result.problem.law = bonded_law<2>(result.problem.line.node_count());
  return result;
}

/// The same, of which one pair is bonded, and the others slide with a coefficient.
inline Bodies partly_bonded_bodies(const std::vector<Mesh>& meshes,
                                   const std::vector<Material>& materials,
                                   const std::vector<Pair>& pairs, int bonded,
                                   double friction) {
  Bodies result = bodies(meshes, materials, pairs);
  const Problem& problem = result.problem;
  std::vector<ContactLine> lines;
  Flags is_bonded;
  for (int k = 0; k < count_of(pairs); ++k) {
    const ContactLine line =
        contact_line(problem.mesh, problem.edges,
                     {result.label(pairs[k].first, pairs[k].first_label)});
    lines.push_back(k == bonded ? bonded_pair(result, pairs[k])
                                : facing_line(problem.mesh, problem.edges, line,
                                              result.traces[k]));
    is_bonded.resize(is_bonded.size() + lines.back().node_count(), k == bonded);
  }
  ContactLaw<2> law;
  law.friction = without(
      is_bonded, VectorXd(VectorXd::Constant(count_of(is_bonded), friction)));
  law.bonded = is_bonded;
  result.problem.line = joined_contact<2>(lines);
  result.problem.law = law;
  return result;
}

/// A body that is bonded to a rigid foundation along some labels.
inline Problem bonded_body(const Mesh& mesh, const Material& material,
                           const std::vector<int>& labels = {bottom}) {
  Problem problem = body(mesh, material, labels);
  problem.line = bonded_line(mesh, problem.edges, labels);
  problem.law = bonded_law<2>(problem.line.node_count());
  return problem;
}

/// A linear displacement.
inline Vector2d linear_field(const Vector2d& x) {
  return {1e-3 * x[0] + 2e-3 * x[1] + 0.01, 3e-3 * x[1] - 0.5e-3 * x[0]};
}

/// Prescribes the linear field all around two bodies, of which the first lies on the other,
/// but for what is between them.
inline void prescribe_around(Bodies& two) {
  for (int side : {top, left, right})
    clamp(two.problem, two.label(0, side), linear_field);
  for (int side : {bottom, left, right})
    clamp(two.problem, two.label(1, side), linear_field);
}

/// Two blocks of one material whose rows of vertices are at random, one on the other, turned
/// by an angle at random; the linear field all around, and either multiplier.
/// @param least_below  edges of the lower one's upper side
inline Bodies random_patch(const Material& material, int least_below,
                           Random& random) {
  const int upper = *rc::gen::inRange(3, 12),
            lower = *rc::gen::inRange(least_below, 12);
  const double angle = 1e-3 * *rc::gen::inRange(-3000, 3000);
  Bodies two = bonded_bodies(
      {rotated(shifted(with_random_rows(upper, 3, 6, 4, random), {0, 5}),
               angle),
       rotated(with_random_rows(lower, 3, 6, 5, random), angle)},
      {material, material}, {{0, bottom, 1, top}});
  prescribe_around(two);
  two.problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  return two;
}

/// Two rectangles 6 x 4 and 6 x 5 one on the other, turned by an angle.
inline Bodies bonded_blocks(int upper, int lower, const Material& of_upper,
                            const Material& of_lower, double angle = 0) {
  return bonded_bodies(
      {rotated(shifted(rectangle(upper, 3, 6, 4), {0, 5}), angle),
       rotated(rectangle(lower, 4, 6, 5), angle)},
      {of_upper, of_lower}, {{0, bottom, 1, top}});
}

/// They stand on a support and are pulled upwards and aside.
inline void pull(Bodies& two) {
  add_traction(two.problem, two.label(0, top), {3, 7});
  clamp(two.problem, two.label(1, bottom));
}

}  // namespace ffcontact::test
