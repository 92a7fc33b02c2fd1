// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/contact_pass.hpp"

#include <algorithm>

#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/edge_form.hpp"

namespace ffcontact {

namespace {

/// Places nearer to each other than this part of the body's size are the same.
constexpr double same_place = 1e-9;

/// The edges of contact faces in the order of their middles, whatever their numbers.
std::vector<int> edges_of_contact(const SolidTopology& topology,
                                  const std::vector<ContactFace>& contact) {
  const auto& [mesh, faces, edges, stars] = topology;
  std::vector<int> found;
  for (const ContactFace& face : contact)
    for (int edge : edges.of_facet.col(face.face)) found.push_back(edge);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  Matrix3Xd middle(3, edges.count());
  const double size =
      (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff())
          .maxCoeff();
  for (int edge : found) {
    const Vector3d sum =
        mesh.vertices(Eigen::all, edges.vertices.col(edge)).rowwise().sum();
    middle.col(edge) = (sum / (same_place * size)).array().round();
  }
  std::stable_sort(found.begin(), found.end(), [&](int a, int b) {
    return std::lexicographical_compare(
        middle.col(a).begin(), middle.col(a).end(), middle.col(b).begin(),
        middle.col(b).end());
  });
  return found;
}

/// The faces of all tetrahedra at an edge.
std::vector<int> faces_near(const SolidTopology& topology, int edge) {
  std::vector<int> near;
  for (const Wedge& wedge : wedges_of(topology, edge))
    for (int face : topology.faces.of_cell.col(wedge.cell))
      near.push_back(face);
  return near;
}

}  // namespace

ContactPass::ContactPass(const SolidTopology& topology,
                         const FaceTractions& boundary, const FaceForms& forms,
                         const std::vector<ContactFace>& contact,
                         const FaceMoments& moments)
    : topology_(topology), forms_(forms), contact_(contact) {
  KnownComponents known = boundary.known;
  std::vector<int> contact_index(topology.faces.count(), -1);
  for (const ContactFace& face : contact) {
    known.col(face.face).setConstant(false);
    contact_index[face.face] = count_of(tractions_);
    const Matrix3d of_face = moments.col(face.face).reshaped(3, 3);
    tractions_.push_back(traction_of(face, of_face));
  }
  for (int edge : edges_of_contact(topology, contact)) {
    ContactStar star(topology, edge, known, forms, contact, contact_index);
    if (star.is_free()) stars_.push_back(std::move(star));
  }
  colour();
}

/// The lowest colour that no star before it with a face in common has.
void ContactPass::colour() {
  std::vector<std::vector<int>> taken(topology_.faces.count());
  for (int s = 0; s < count_of(stars_); ++s) {
    const std::vector<int> faces = faces_near(topology_, stars_[s].edge());
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

/// Lets one star change what lies around its edge; returns by how much e^2 fell.
double ContactPass::relax(const ContactStar& star,
                          const ContactStar::Scales& scales,
                          Matrix9Xd& corrections, Matrix9Xd& residual) {
  const Hinges<3>& edges = topology_.edges;
  const int edge = star.edge(), first = edges.facet_start[edge];
  const ContactStar::Change change =
      star.change(-restricted(topology_, edge, residual), scales, tractions_);
  if (change.fall == 0) return 0;
  const auto of_face = [&](int place) {
    return at_place(topology_, edge, place, change.x);
  };
  for (int i = 0; i < edges.facet_count(edge); ++i)
    corrections.col(edges.facet[first + i]) += of_face(i);
  for (const Wedge& wedge : wedges_of(topology_, edge)) {
    Vector36f x = Vector36f::Zero();
    for (int side = 0; side < 2; ++side)
      x.segment<9>(9 * wedge.local[side]) =
          of_face(wedge.place[side]).cast<float>();
    const Vector36f image = forms_.times(wedge.cell, x);
    for (int k = 0; k < 4; ++k)
      residual.col(topology_.faces.of_cell(k, wedge.cell)) -=
          image.segment<9>(9 * k).cast<double>();
  }
  return change.fall;
}

double ContactPass::operator()(double least_fall, Matrix9Xd& corrections,
                               Matrix9Xd& residual) {
  ContactStar::Scales scales{least_fall, 0};
  for (const Matrix3d& traction : tractions_)
    scales.traction = std::max(scales.traction, max_norm(traction));
  VectorXd falls = VectorXd::Zero(count_of(stars_));
  for (const std::vector<int>& colour : colours_) {
#pragma omp parallel for
    for (std::size_t k = 0; k < colour.size(); ++k)
      falls[colour[k]] =
          relax(stars_[colour[k]], scales, corrections, residual);
  }
  return falls.sum();
}

double ContactPass::contact_part() const {
  double sum = 0;
  for (std::size_t m = 0; m < contact_.size(); ++m)
    sum += contact_term(contact_[m], tractions_[m]);
  return 2 * sum;
}

}  // namespace ffcontact
