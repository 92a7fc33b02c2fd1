// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "ffcontact/contact/checks/compliance_ratio.hpp"
#include "ffcontact/contact/checks/facet_compliance.hpp"

namespace ffcontact {

double compliance_ratio(const SolidMesh& mesh, const Facets<3>& faces,
                        const ContactSurface& surface,
                        const std::vector<FacingPolygon>& polygons,
                        const ElasticSystem& system) {
  MeanRatio mean;
  for (const FacingPolygon& polygon : polygons) {
    const auto nodes = surface.face_node.col(polygon.contact_face);
    const Vector3d n =
        surface.normal(Eigen::all, nodes).rowwise().sum().normalized();
    const auto compliance = [&](int face) {
      const double size = std::sqrt(facet_measure(mesh, faces, face));
      return facet_compliance<3>(faces, system, face, size, n);
    };
    mean.add(compliance(surface.face[polygon.contact_face]),
             compliance(polygon.opposite_face), polygon.area);
  }
  return mean.value();
}

}  // namespace ffcontact
