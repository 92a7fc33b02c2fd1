// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/facing_oscillations.hpp"

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/estimate/error/facet_oscillation.hpp"
#include "ffcontact/estimate/error/facing_faces.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// int r' G r over a polygon, on the face that it faces, in the unknowns of QuadraticOnFace
/// [27 x 27].
MatrixXd square_on(const FacingPolygon& polygon, double own_area,
                   double opposite_area, const Matrix3d& G) {
  const double ratio = own_area *
                       std::abs(polygon.own_of_opposite.determinant()) /
                       opposite_area;
  Matrix9d products = Matrix9d::Zero();
  for (const FanTriangle& triangle : fan_of(polygon.own)) {
    const Matrix9d places =
        products_of_places(polygon.own(Eigen::all, triangle.corner));
    products += own_area * triangle.share * places * fourfold_products() *
                places.transpose();
  }
  MatrixXd square(27, 27);
  for (int j = 0; j < 9; ++j)
    for (int k = 0; k < 9; ++k)
      square.block<3, 3>(3 * j, 3 * k) = ratio * products(j, k) * G;
  return square;
}

/// int l' G l of the linear traction l with moments M is M' P M.
Matrix9d square_of_linear(double area, const Matrix3d& G) {
  Matrix9d P;
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l)
      P.block<3, 3>(3 * k, 3 * l) = 12 / area * ((k == l) - 0.25) * G;
  return P;
}

class OscillationsOfFaces {
 public:
  OscillationsOfFaces(const SolidMesh& mesh, const Facets<3>& faces,
                      const ContactSurface& surface,
                      const HookeTensors<3>& hooke,
                      const std::vector<ContactFacet<3>>& contact)
      : mesh_(mesh),
        faces_(faces),
        surface_(surface),
        hooke_(hooke),
        contact_(contact),
        place_(surface.face_count(), -1) {
    for (int k = 0; k < count_of(contact); ++k) {
      if (contact[k].facing.empty()) continue;
      place_[contact[k].index] = k;
      for (const FacingPart<3>& part : contact[k].facing) begin(part.facet);
    }
  }

  std::vector<FacingOscillation<3>> found(
      const Ref<const Matrix3Xd>& traction) && {
    const FacePolygons of(mesh_, faces_, surface_);
    for (int m = 0; m < surface_.face_count(); ++m) {
      if (place_[m] >= 0)
        add_free(m, of);
      else
        add_fixed(m, of,
                  along_axes(bent_traction(surface_, m, traction)).reshaped());
    }
    std::vector<FacingOscillation<3>> all;
    for (auto& [face, beyond] : of_face_) all.push_back(std::move(beyond));
    return all;
  }

 private:
  double area(int face) const { return facet_measure(mesh_, faces_, face); }

  Matrix3d form_of(int face) const {
    const int cell = faces_.cells(0, face);
    return facet_oscillation_form<3>(corners_of(mesh_, cell),
                                     hooke_[cell].inverse(), area(face));
  }

  void begin(int face) {
    if (of_face_.count(face) == 0)
      of_face_[face].of_moments = square_of_linear(area(face), form_of(face));
  }

  /// Of the polygons that a contact face shares with another one.
  MatrixXd square_with(int m, int face, const FacePolygons& of) const {
    MatrixXd square = MatrixXd::Zero(27, 27);
    for (const FacingPolygon* polygon : of.polygons[m])
      if (polygon->opposite_face == face)
        square += square_on(*polygon, area(surface_.face[m]), area(face),
                            form_of(face));
    return square;
  }

  void add_free(int m, const FacePolygons& of) {
    const ContactFacet<3>& face = contact_[place_[m]];
    const DensityOfCorners density = density_by_corners(face);
    std::map<int, Matrix9d> moments;
    for (const FacingPart<3>& part : face.facing) {
      const auto added = moments.emplace(part.facet, Matrix9d::Zero());
      added.first->second += part.moments;
    }
    for (const auto& [opposite, of_part] : moments)
      of_face_[opposite].parts.push_back(
          {place_[m],
           density.transpose() * square_with(m, opposite, of) * density,
           of_part});
  }

  void add_fixed(int m, const FacePolygons& of,
                 const Matrix<double, 27, 1>& density) {
    for (const FacingPolygon* polygon : of.polygons[m]) {
      const auto found = of_face_.find(polygon->opposite_face);
      if (found == of_face_.end()) continue;
      found->second.first_square +=
          density.dot(square_on(*polygon, area(surface_.face[m]),
                                area(polygon->opposite_face),
                                form_of(polygon->opposite_face)) *
                      density);
    }
    for (const TractionPart& part : of.parts[m]) {
      const auto found = of_face_.find(part.face);
      if (found != of_face_.end())
        found->second.first_moments +=
            (density.reshaped(3, 9) * part.weight).reshaped();
    }
  }

  const SolidMesh& mesh_;
  const Facets<3>& faces_;
  const ContactSurface& surface_;
  const HookeTensors<3>& hooke_;
  const std::vector<ContactFacet<3>>& contact_;
  std::vector<int> place_;  ///< of a contact face that is free, or -1
  std::map<int, FacingOscillation<3>> of_face_;
};

}  // namespace

std::vector<FacingOscillation<3>> facing_oscillations(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const HookeTensors<3>& hooke,
    const std::vector<ContactFacet<3>>& contact,
    const Ref<const Matrix3Xd>& traction) {
  return OscillationsOfFaces(mesh, faces, surface, hooke, contact)
      .found(traction);
}

}  // namespace ffcontact
