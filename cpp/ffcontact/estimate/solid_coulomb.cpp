// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/solid_coulomb.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/uniqueness/coulomb_constant.hpp"
#include "ffcontact/contact/uniqueness/slip_pattern.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/estimate/error/contact_faces.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"
#include "ffcontact/interface/traction_parts.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// A face of a surface that carries tractions on its own: its nodes and area, and
/// (r_n, r_t1, r_t2) at the corners in the frames of these.
struct FaceOfNodes {
  Vector3i node;
  double area;
  Matrix3d traction;
};

std::vector<FaceOfNodes> faces_of_nodes(const Topology<3>& topology,
                                        const ContactSurface& surface,
                                        const SurfaceTractions& tractions) {
  std::vector<FaceOfNodes> faces;
  for (int m = 0; m < surface.face_count(); ++m)
    faces.push_back(
        {surface.face_node.col(m),
         facet_measure(topology.mesh, topology.facets, surface.face[m]),
         tractions.col(m).reshaped(3, 3)});
  return faces;
}

/// r_hat_t and its bound, as means around the nodes times an area.
struct NodalFriction {
  Matrix2Xd traction;
  VectorXd bound;

  explicit NodalFriction(Index nodes)
      : traction(Matrix2Xd::Zero(2, nodes)), bound(VectorXd::Zero(nodes)) {}
  void add(int node, const FrictionCone& cone, const Vector3d& r, double area) {
    traction.col(node) += area * r.tail<2>();
    bound[node] += area * cone.bound(r[0]);
  }
};

/// What a solution says of the friction at its nodes.
class PairOnSurface {
 public:
  PairOnSurface(const Topology<3>& topology, const ContactSurface& surface,
                const ContactLaw<3>& law, const Estimate<3>& estimate)
      : surface_(surface),
        cones_(traction_cones(law)),
        nodal_(estimate.tractions),
        friction_(surface.node_count()) {
    if (!surface.against_a_body())
      faces_ = faces_of_nodes(topology, surface, estimate.face_tractions);
    else
      put_parts(topology, estimate.face_tractions);
    visit([&](int node, const Vector3d& r, double area) {
      friction_.add(node, cones_[node], r, area);
    });
    put_directions(
        displacement_against_foundation(surface, law, estimate.displacement),
        least_motion * largest_displacement(law, estimate.displacement));
  }

  const Matrix2Xd& directions() const { return s_; }

  bool reaches_limit() const {
    bool reached = false;
    visit([&](int node, const Vector3d& r, double) {
      reached = reached || cones_[node].at_limit(r[0]);
    });
    for (const auto& [part, traction] : parts_)
      for (Index a = 0; a < traction.cols(); ++a) {
        const int node = face_hats(surface_, part.contact_face).node[a];
        reached = reached || cones_[node].at_limit(traction(0, a));
      }
    return reached;
  }

  /// int phi_i d
  Matrix2Xd missed_moments() const {
    return surface_.against_a_body() ? moments_of_parts() : moments_of_faces();
  }

 private:
  /// All (node, traction, area that belongs to it).
  template <class Visitor>
  void visit(const Visitor& visitor) const {
    if (surface_.against_a_body())
      for (int i = 0; i < surface_.node_count(); ++i)
        visitor(i, nodal_.col(i), surface_.area[i]);
    for (const FaceOfNodes& face : faces_)
      for (int k = 0; k < 3; ++k)
        visitor(face.node[k], face.traction.col(k), face.area / 3);
  }

  void put_directions(const Matrix3Xd& w, double least) {
    s_ = Matrix2Xd::Zero(2, w.cols());
    for (Index i = 0; i < w.cols(); ++i) {
      const Vector2d slip = w.col(i).tail<2>();
      if (slip.norm() > least)
        s_.col(i) = slip.normalized();
      else if (friction_.bound[i] > 0)
        s_.col(i) = -friction_.traction.col(i) / friction_.bound[i];
    }
  }

  /// (0, d) in the frame of the node.
  Vector3d missed(int node, const Vector3d& r) const {
    Vector3d d = Vector3d::Zero();
    d.tail<2>() = r.tail<2>() + cones_[node].bound(r[0]) * s_.col(node);
    return d;
  }

  /// What each face feels, with r_hat at its nodes.
  void put_parts(const Topology<3>& topology,
                 const SurfaceTractions& on_faces) {
    for (const TractionPart& part :
         traction_parts(topology.mesh, topology.facets, surface_)) {
      const int m = part.contact_face;
      if (part.face == surface_.face[m])
        parts_.push_back({part, at_nodes(m, of_face(on_faces, m))});
    }
  }

  /// Of values at the corners of a face.
  Matrix3Xd at_nodes(int contact_face, const Matrix3d& corners) const {
    std::vector<int> nodes;
    for (int k = 0; k < 3; ++k)
      if (surface_.face_node(k, contact_face) >= 0) nodes.push_back(k);
    return corners(Eigen::all, nodes);
  }

  Matrix2Xd moments_of_parts() const {
    Matrix2Xd moments = Matrix2Xd::Zero(2, surface_.node_count());
    for (const auto& [part, traction] : parts_) {
      const FaceHats hats = face_hats(surface_, part.contact_face);
      Matrix3Xd d(3, traction.cols());
      for (Index a = 0; a < d.cols(); ++a)
        d.col(a) = surface_.frame(hats.node[a]) *
                   missed(hats.node[a], traction.col(a));
      const Matrix3Xd of_nodes =
          raised(d * hats.hat.transpose()) * part.weight * hats.hat;
      for (Index a = 0; a < d.cols(); ++a)
        moments.col(hats.node[a]) +=
            surface_.frame(hats.node[a]).rightCols<2>().transpose() *
            of_nodes.col(a);
    }
    return moments;
  }

  Matrix2Xd moments_of_faces() const {
    Matrix2Xd moments = Matrix2Xd::Zero(2, surface_.node_count());
    for (const FaceOfNodes& face : faces_) {
      Matrix3d d;
      for (int k = 0; k < 3; ++k)
        d.col(k) = surface_.frame(face.node[k]) *
                   missed(face.node[k], face.traction.col(k));
      const Matrix3d of_face = facet_moments_of<3>(d, face.area);
      for (int k = 0; k < 3; ++k)
        moments.col(face.node[k]) +=
            surface_.frame(face.node[k]).rightCols<2>().transpose() *
            of_face.col(k);
    }
    return moments;
  }

  const ContactSurface& surface_;
  std::vector<FrictionCone> cones_;
  const Matrix3Xd& nodal_;
  std::vector<FaceOfNodes> faces_;  ///< on a rigid foundation
  /// what faces feel, and r_hat at the nodes of each
  std::vector<std::pair<TractionPart, Matrix3Xd>> parts_;
  NodalFriction friction_;
  Matrix2Xd s_;
};

/// s times the slope of the bound over the largest coefficient.
Matrix2Xd weight_of(const Matrix2Xd& s, const NodalLaw& law) {
  const double largest = largest_friction(law);
  Matrix2Xd weight = s;
  for (Index i = 0; i < s.cols(); ++i)
    weight.col(i) *= relative(law.cone[i].friction, largest);
  return weight;
}

/// @param left_out  1 at nodes that slip nowhere [p]
DirectedSlip slip_of(const PairOnSurface& pair, const NodalLaw& law,
                     const Flags& left_out) {
  return {weight_of(pair.directions(), law), pair.missed_moments(), left_out};
}

}  // namespace

DirectedSlip directed_slip(const Topology<3>& topology,
                           const ContactSurface& surface,
                           const SolvedBody<3>& body,
                           const Estimate<3>& estimate) {
  return slip_of({topology, surface, body.law, estimate},
                 nodal_law(body.law, surface), Flags(surface.node_count(), 0));
}

SolidCoulomb solid_coulomb(const Topology<3>& topology,
                           const ContactSurface& surface,
                           const ElasticSystem& system,
                           const SolvedBody<3>& body,
                           const Estimate<3>& estimate, const Flags& held) {
  const double e =
      estimate.admissible ? estimate.e + estimate.oscillation : infinity;
  const NodalLaw law = nodal_law(body.law, surface);
  const double friction = largest_friction(law);
  if (friction == 0) return {0, 0, 0, e};
  const PairOnSurface pair(topology, surface, body.law, estimate);
  if (pair.reaches_limit() || turns(surface) || body.law.layer.given() ||
      body.law.has_bonded())
    return {friction, infinity, infinity, infinity};
  const auto constant = directed_constant(
      surface_contact(surface, body.law, system, *body.stiffness),
      slip_of(pair, law, held));
  return {friction, constant.kappa, constant.missed,
          coulomb_bound(e, friction, constant.kappa, constant.missed)};
}

}  // namespace ffcontact
