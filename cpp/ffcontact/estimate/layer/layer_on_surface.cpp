// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/layer/layer_parts.hpp"

namespace ffcontact {

namespace {

/// int C |r|^2 over a triangle of unit area, by the corners of the traction.
double square(const CompliantLayer& layer, const BentTraction& r,
              const Vector3i& corners) {
  const auto of = [&](const auto& field) {
    const auto values = field(Eigen::all, corners).eval();
    return (values.squaredNorm() + values.rowwise().sum().squaredNorm()) / 12;
  };
  return layer.normal * of(r.pressing) + layer.tangential * of(r.turned);
}

/// a + factor b on the same face.
BentTraction sum(BentTraction a, double factor, const BentTraction& b) {
  a.pressing += factor * b.pressing;
  a.turned += factor * b.turned;
  return a;
}

/// Both integrals over a part of a face by its corners.
void add(const CompliantLayer& layer, double area, const BentTraction& r,
         const BentTraction& p, const Ref<const Matrix3Xd>& places, int face,
         SpringNorms& norms) {
  const BentTraction off = sum(r, -1, p).between(places),
                     both = sum(r, 1, p).between(places);
  for (const FanTriangle& triangle : fan_of(places)) {
    const double part = area * triangle.share;
    norms.difference[face] += part * square(layer, off, triangle.corner);
    norms.sum += part * square(layer, both, triangle.corner);
  }
}

}  // namespace

SpringNorms layer_norms(const Topology<3>& topology,
                        const ContactSurface& surface, const SurfaceLaw& law,
                        const TractionFields& traction) {
  SpringNorms norms;
  if (!law.layer.given()) return norms;
  norms.difference.setZero(surface.face_count());
  const auto add_part = [&](int m, const Ref<const Matrix3Xd>& places) {
    add(law.layer,
        facet_measure(topology.mesh, topology.facets, surface.face[m]),
        bent_on_face(surface, m, traction),
        bent_traction(surface, m, law.carried), places, m, norms);
  };
  if (surface.against_a_body())
    for (const FacingPolygon& polygon : surface.polygons)
      add_part(polygon.contact_face, polygon.own);
  else
    for (int m = 0; m < surface.face_count(); ++m)
      add_part(m, Matrix3d::Identity());
  return norms;
}

}  // namespace ffcontact
