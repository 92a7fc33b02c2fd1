// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/packed.hpp"
#include "ffcontact/bounds/contact_of_bounds.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/error/facing_faces.hpp"
#include "ffcontact/estimate/error/surface_error.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// With the motion of v.
std::vector<ContactFacet<3>> faces_with(const MatchedBodies<3>& bodies,
                                        const VectorXd& v) {
  const Topology<3>& topology = bodies.topology();
  return contact_faces(topology.mesh, topology.facets, bodies.contact(),
                       bodies.body().law, v);
}

/// Of rho alone, on all faces.
FaceMoments moments_of(const MatchedBodies<3>& bodies,
                       const SurfaceDensities& rho) {
  const auto& [mesh, faces, ridges, stars] = bodies.topology();
  const FaceTractions none{KnownComponents::Constant(3, faces.count(), false),
                           FaceMoments::Zero(9, faces.count())};
  FaceMoments moments =
      with_contact(none, mesh, faces, bodies.contact(), rho.nodal).moments;
  const VectorXd& u = bodies.body().displacement;
  for (const auto& contact :
       {faces_with(bodies, u),
        facing_faces(mesh, faces, bodies.contact(), bodies.body().law, u)})
    put_moments(contact, rho.on_faces(Eigen::all, surface_faces(contact)),
                moments);
  return moments;
}

}  // namespace

template <>
VectorXd nodal_forces(const MatchedBodies<3>& bodies,
                      const SurfaceDensities& rho) {
  const auto& [mesh, faces, ridges, stars] = bodies.topology();
  const FaceMoments moments = moments_of(bodies, rho);
  VectorXd forces = VectorXd::Zero(3 * mesh.vertices.cols());
  for (int f = 0; f < faces.count(); ++f)
    for (int k = 0; k < 3; ++k)
      vector_at<3>(forces, faces.vertices(k, f)) +=
          moments.col(f).segment<3>(3 * k);
  return forces;
}

template <>
VectorXd twice_psi<3>(const MatchedBodies<3>& bodies, const ContactLaw<3>& law,
                      const VectorXd& v, const SurfaceDensities& rho) {
  const auto& [mesh, faces, ridges, stars] = bodies.topology();
  return contact_error(mesh, faces, bodies.contact(), law,
                       faces_with(bodies, v), {rho.nodal, rho.on_faces}, v);
}

template <>
ContactLaw<3> with_twice_the_bound<3>(ContactLaw<3> law) {
  law.slip_bound *= 2;
  return law;
}

template <>
ContactLaw<3> reflected(const SolvedProblem<3>& solved, const VectorXd& v) {
  ContactLaw<3> law = solved.body.law;
  const Matrix3Xd moved = contact_components(solved.contact, v);
  law.gap = on_the_other_side<VectorXd>(law.gap, moved.row(0));
  law.previous =
      on_the_other_side<Matrix2Xd>(law.previous, moved.bottomRows<2>());
  return law;
}

template <>
VectorXd cleared(const MatchedBodies<3>& bodies,
                 const ContactConditions<3>& conditions, const VectorXd& v) {
  const Facets<3>& faces = bodies.topology().facets;
  const auto& [surface, law] = conditions;
  const Flags& prescribed = bodies.prescribed();
  return cleared_between_nodes(
      faces, surface, law,
      admissible_displacement(faces, surface, law, v, prescribed), prescribed);
}

template <>
double depth_of(const MatchedBodies<3>& bodies,
                const ContactConditions<3>& conditions, const VectorXd& v) {
  return deepest_node(bodies.topology().facets, conditions.contact,
                      conditions.law, v)
      .depth;
}

}  // namespace ffcontact
