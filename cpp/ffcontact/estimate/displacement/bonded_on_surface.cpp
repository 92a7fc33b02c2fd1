// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/bodies/contact_subset.hpp"
#include "ffcontact/estimate/displacement/bonded_displacement.hpp"
#include "ffcontact/estimate/displacement/following_faces.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Adds what is free of h to a vertex.
/// @return the largest component that was added
double follow(int vertex, const Vector3d& h, const Flags& prescribed,
              VectorXd& u) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) {
    const int dof = dof_of<3>(vertex, c);
    if (prescribed[dof]) continue;
    u[dof] += h[c];
    largest = std::max(largest, std::abs(h[c]));
  }
  return largest;
}

/// @return by how much the vertices moved at most
double follow_all(const Facets<3>& faces,
                  const std::vector<FollowingPart>& parts,
                  const Flags& prescribed, VectorXd& u) {
  double largest = 0;
  for (const FollowingPart& part : parts)
    for (Index corner = 0; corner < part.place.cols(); ++corner) {
      const int k = part.vertex_at(corner);
      if (k < 0) continue;
      const Vector3d h = part.jumps(faces, u).col(k);
      largest = std::max(
          largest, follow(faces.vertices(k, part.face), h, prescribed, u));
    }
  return largest;
}

}  // namespace

VectorXd bonded_displacement(const SolvedProblem<3>& solved) {
  constexpr int most_in_a_row = 20;  // bodies, each of which follows the next
  constexpr double rounding = 1e-14;
  const auto& [topology, contact, system, body] = solved;
  VectorXd u = body.displacement;
  if (!body.law.has_bonded()) return u;
  const ContactSurface surface = bonded_subset<3>(contact, body.law).contact;
  const double nothing = rounding * max_norm(u);
  if (!surface.against_a_body())
    for (const int v : surface.vertex)
      follow(v, -vector_at<3>(u, v), system.prescribed, u);
  const std::vector<FollowingPart> parts =
      following_parts(topology.facets, surface);
  for (int pass = 0; pass < most_in_a_row; ++pass)
    if (follow_all(topology.facets, parts, system.prescribed, u) <= nothing)
      break;
  return u;
}

}  // namespace ffcontact
