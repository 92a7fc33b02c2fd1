// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/packed.hpp"
#include "ffcontact/bounds/contact_of_bounds.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/error/surface_error.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// With the motion of v.
std::vector<ContactFacet<3>> faces_with(const SolvedProblem<3>& solved,
                                        const VectorXd& v) {
  const auto& [topology, surface, system, body] = solved;
  return contact_faces(topology.mesh, topology.facets, surface, body.law, v);
}

}  // namespace

template <>
VectorXd nodal_forces(const SolvedProblem<3>& solved,
                      const SurfaceTractions& rho) {
  const auto& [mesh, faces, ridges, stars] = solved.topology;
  FaceMoments moments = FaceMoments::Zero(9, faces.count());
  put_moments(faces_with(solved, solved.body.displacement), rho, moments);
  VectorXd forces = VectorXd::Zero(3 * mesh.vertices.cols());
  for (int f = 0; f < faces.count(); ++f)
    for (int k = 0; k < 3; ++k)
      vector_at<3>(forces, faces.vertices(k, f)) +=
          moments.col(f).segment<3>(3 * k);
  return forces;
}

template <>
VectorXd twice_psi(const SolvedProblem<3>& solved, const VectorXd& v,
                   const SurfaceTractions& rho) {
  return contact_error(faces_with(solved, v), rho);
}

template <>
void add_to_cells(const SolvedProblem<3>& solved, const VectorXd& on_facets,
                  VectorXd& local) {
  const Facets<3>& faces = solved.topology.facets;
  for (int m = 0; m < on_facets.size(); ++m)
    local[faces.cells(0, solved.contact.face[m])] += on_facets[m];
}

template <>
SurfaceLaw with_twice_the_bound<3>(SurfaceLaw law) {
  law.slip_bound *= 2;
  return law;
}

template <>
SurfaceLaw reflected(const SolvedProblem<3>& solved, const VectorXd& v) {
  SurfaceLaw law = solved.body.law;
  const Matrix3Xd moved = contact_components(solved.contact, v);
  law.gap = on_the_other_side<VectorXd>(law.gap, moved.row(0));
  law.previous =
      on_the_other_side<Matrix2Xd>(law.previous, moved.bottomRows<2>());
  return law;
}

template <>
VectorXd cleared(const SolvedProblem<3>& solved, const VectorXd& v) {
  const auto& [topology, surface, system, body] = solved;
  const Facets<3>& faces = topology.facets;
  return cleared_between_nodes(
      faces, surface, body.law,
      admissible_displacement(faces, surface, body.law, v, system.prescribed),
      system.prescribed);
}

template <>
double depth_of(const SolvedProblem<3>& solved, const VectorXd& v) {
  return deepest_node(solved.topology.facets, solved.contact, solved.body.law,
                      v)
      .depth;
}

template <>
std::string reason_against_bounds(const SolvedProblem<3>& solved,
                                  const Estimate<3>&) {
  if (count_of(faces_with(solved, solved.body.displacement)) <
      solved.contact.face_count())
    return "there are no bounds of quantities of bodies whose meshes do not "
           "match on the contact: let them have the same triangles there";
  return "";
}

}  // namespace ffcontact
