// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/contact_pass.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// The faces of all tetrahedra at an edge.
std::vector<int> faces_near(const Topology<3>& topology,
                            const JointEdge& joint) {
  std::vector<int> near;
  for (const JointEdge::Part& part : joint.parts)
    for (const Wedge& wedge : wedges_of<3>(topology, part.edge))
      for (int face : topology.facets.of_cell.col(wedge.cell))
        near.push_back(face);
  return near;
}

}  // namespace

ContactPass::ContactPass(const Topology<3>& topology,
                         const FaceTractions& boundary,
                         const FacetForms<3>& forms,
                         const std::vector<ContactFace>& contact,
                         const FaceMoments& moments)
    : topology_(topology), forms_(forms), contact_(contact) {
  const KnownComponents known = without_contact(boundary.known, contact);
  std::vector<int> contact_index(topology.facets.count(), -1);
  for (const ContactFace& face : contact) {
    contact_index[face.face] = count_of(tractions_);
    const Matrix3d of_face = moments.col(face.face).reshaped(3, 3);
    tractions_.push_back(traction_of(face, of_face));
  }
  for (JointEdge& joint : joint_edges(topology, contact)) {
    ContactStar star(topology, std::move(joint), known, forms, contact,
                     contact_index);
    if (star.is_free()) stars_.push_back(std::move(star));
  }
  colour();
}

/// The lowest colour that no star before it with a face in common has.
void ContactPass::colour() {
  std::vector<std::vector<int>> taken(topology_.facets.count());
  for (int s = 0; s < count_of(stars_); ++s) {
    const std::vector<int> faces = faces_near(topology_, stars_[s].joint());
    const auto is_taken = [&](int colour) {
      return std::any_of(faces.begin(), faces.end(), [&](int face) {
        const std::vector<int>& of_face = taken[face];
        return std::find(of_face.begin(), of_face.end(), colour) !=
               of_face.end();
      });
    };
    int colour = 0;
    while (is_taken(colour)) ++colour;
    for (int face : faces) taken[face].push_back(colour);
    if (colour == count_of(colours_)) colours_.emplace_back();
    colours_[colour].push_back(s);
  }
}

/// Lets one star change what lies around its edges; returns by how much e^2 fell.
double ContactPass::relax(const ContactStar& star,
                          const ContactStar::Scales& scales,
                          Matrix9Xd& corrections, Matrix9Xd& residual) {
  const VectorXd g = -joint_restricted(topology_, star.joint(), residual);
  const ContactStar::Change change = star.change(g, scales, tractions_);
  if (change.fall == 0) return 0;
  for (const JointEdge::Part& part : star.joint().parts)
    add_around<3>(topology_, forms_, part.edge, part.of(change.x), corrections,
                  residual);
  return change.fall;
}

double ContactPass::pass(double least_fall, Matrix9Xd& corrections,
                         Matrix9Xd& residual) {
  ContactStar::Scales scales{least_fall, 0};
  for (const Matrix3d& traction : tractions_)
    scales.traction = std::max(scales.traction, max_norm(traction));
  VectorXd falls = VectorXd::Zero(count_of(stars_));
  constexpr std::size_t worth_threads = 64;  // fewer stars than a wait takes
  for (const std::vector<int>& colour : colours_) {
#pragma omp parallel for if (colour.size() >= worth_threads)
    for (std::size_t k = 0; k < colour.size(); ++k)
      falls[colour[k]] =
          relax(stars_[colour[k]], scales, corrections, residual);
  }
  return falls.sum();
}

double ContactPass::contact_part() const {
  const double sum = sum_over(contact_.size(), [&](int m) {
    return contact_term(contact_[m], tractions_[m]);
  });
  return 2 * sum;
}

}  // namespace ffcontact
