// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/layer/layer_parts.hpp"

namespace ffcontact {

namespace {

/// int C f . f over a triangle of measure 1.
double square(const CompliantLayer& layer, const Matrix4Xd& fields,
              const Vector3i& corners) {
  const Matrix<double, 4, 3> f = fields(Eigen::all, corners);
  return layer_product(layer, f, f);
}

/// Both integrals over a part of a face by its corners.
void add(const CompliantLayer& layer, double area, const BentTraction& r,
         const BentTraction& p, const Ref<const Matrix3Xd>& places, int face,
         SpringNorms& norms) {
  const Matrix4Xd of_r = linear_fields(r.between(places)),
                  of_p = linear_fields(p.between(places));
  for (const FanTriangle& triangle : fan_of(places)) {
    const double part = area * triangle.share;
    norms.difference[face] +=
        part * square(layer, of_r - of_p, triangle.corner);
    norms.sum += part * square(layer, of_r + of_p, triangle.corner);
  }
}

}  // namespace

SpringNorms layer_norms(const Topology<3>& topology,
                        const ContactSurface& surface, const ContactLaw<3>& law,
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
