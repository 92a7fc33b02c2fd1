// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/facing_error.hpp"

#include <algorithm>
#include <map>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/bodies/clearing.hpp"
#include "ffcontact/estimate/error/face_fields.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// Shares below this are rounding.
constexpr double no_share = 1e-12;
/// Vertices give way where those that are free have at least this share of a corner, the
/// larger values first.
constexpr double enough_shares[] = {0.5, 1e-3, 1e-9};

/// The jump at the corners of one polygon, against gap and load step before.
class PolygonJump {
 public:
  PolygonJump(const Facets<3>& faces, const ContactSurface& surface,
              const SurfaceLaw& law, const FacingPolygon& polygon,
              const Ref<const VectorXd>& displacement)
      : surface_(surface),
        hats_(face_hats(surface, polygon.contact_face)),
        shares_(hats_.hat.transpose() * polygon.own),
        jump_(vectors(faces, surface.face[polygon.contact_face], displacement) *
                  polygon.own -
              vectors(faces, polygon.opposite_face, displacement) *
                  polygon.opposite),
        previous_(Matrix3Xd::Zero(3, corner_count())),
        gap_(Eigen::RowVectorXd::Zero(corner_count())) {
    for (int a = 0; a < node_count(); ++a) put_given(law, a);
  }

  int node_count() const { return count_of(hats_.node); }
  int corner_count() const { return static_cast<int>(jump_.cols()); }
  int node(int a) const { return hats_.node[a]; }
  /// chi_a at a corner.
  double share(int a, int corner) const { return shares_(a, corner); }

  /// (w_n - gap, w_t - previous) in the frame of node a.
  Vector3d components(int a, int corner) const {
    const Matrix3d frame = surface_.frame(node(a));
    Vector3d w = frame.transpose() * jump_.col(corner);
    w.tail<2>() -= frame.rightCols<2>().transpose() * previous_.col(corner);
    w[0] -= gap_[corner];
    return w;
  }

 private:
  static Matrix3d vectors(const Facets<3>& faces, int face,
                          const Ref<const VectorXd>& field) {
    const auto at_vertices = field.reshaped(3, field.size() / 3);
    return at_vertices(Eigen::all, faces.vertices.col(face));
  }

  void put_given(const SurfaceLaw& law, int a) {
    const int i = node(a);
    if (law.gap.size() > 0) gap_ += law.gap[i] * shares_.row(a);
    if (law.previous.size() == 0) return;
    const Vector3d before =
        surface_.frame(i).rightCols<2>() * law.previous.col(i);
    previous_ += before * shares_.row(a);
  }

  const ContactSurface& surface_;
  FaceHats hats_;
  MatrixXd shares_;
  Matrix3Xd jump_, previous_;
  Eigen::RowVectorXd gap_;
};

/// w at the corners, less gap and load step before [3 x corners].
Matrix3Xd motions_of(const PolygonJump& jump, const ContactSurface& surface) {
  Matrix3Xd motions = Matrix3Xd::Zero(3, jump.corner_count());
  for (int k = 0; k < jump.corner_count(); ++k)
    for (int a = 0; a < jump.node_count(); ++a)
      motions.col(k) += jump.share(a, k) * surface.frame(jump.node(a)) *
                        jump.components(a, k);
  return motions;
}

/// Values at the corners of c_a |w_t| + r_a . w.
/// @param least  of |w_t|, less is rounding [mm]
VectorXd integrand_at(const PolygonJump& jump, int a, const FrictionCone& cone,
                      const Vector3d& traction, double least) {
  VectorXd values(jump.corner_count());
  for (int k = 0; k < jump.corner_count(); ++k) {
    const Vector3d w = jump.components(a, k);
    const double slip = slip_beyond(least, w.tail<2>().norm());
    values[k] = cone.bound(traction[0]) * slip + traction.dot(w);
  }
  return values;
}

/// int chi_a f over a polygon in parts of the area of its face, f linear on its triangles.
double integral_of(const FacingPolygon& polygon, const PolygonJump& jump, int a,
                   const VectorXd& f) {
  double sum = 0;
  for (const FanTriangle& triangle : fan_of(polygon.own)) {
    double chi = 0, values = 0, products = 0;
    for (int k : triangle.corner) {
      chi += jump.share(a, k);
      values += f[k];
      products += jump.share(a, k) * f[k];
    }
    sum += triangle.share / 12 * (chi * values + products);
  }
  return sum;
}

/// Which body gives way.
enum class Side { own, opposite };

/// What vertices are asked for: how far along the normal of which node.
using Wanted = std::map<int, std::map<int, double>>;

class FacingClearing {
 public:
  FacingClearing(const Facets<3>& faces, const ContactSurface& surface,
                 const SurfaceLaw& law, const Ref<const VectorXd>& displacement,
                 const Flags& prescribed)
      : faces_(faces),
        surface_(surface),
        law_(law),
        prescribed_(prescribed),
        largest_(largest_clearing(law, displacement)),
        u_(displacement) {}

  VectorXd displacement() && {
    for (double enough : enough_shares)
      for (Side side : {Side::own, Side::opposite}) give_way(side, enough);
    return std::move(u_);
  }

 private:
  void give_way(Side side, double enough) {
    Wanted wanted;
    for (const FacingPolygon& polygon : surface_.polygons) {
      const PolygonJump jump(faces_, surface_, law_, polygon, u_);
      for (int k = 0; k < jump.corner_count(); ++k)
        for (int a = 0; a < jump.node_count(); ++a)
          if (jump.share(a, k) > no_share)
            ask(polygon, side, k, jump.node(a), jump.components(a, k)[0],
                enough, wanted);
    }
    const double sign = side == Side::own ? -1 : 1;
    for (const auto& [vertex, depths] : wanted)
      u_.segment<3>(dof_of<3>(vertex, 0)) += change(vertex, depths, sign);
  }

  /// What one corner asks for.
  void ask(const FacingPolygon& polygon, Side side, int corner, int node,
           double depth, double enough, Wanted& wanted) const {
    if (depth <= 0) return;
    const bool own = side == Side::own;
    const int face =
        own ? surface_.face[polygon.contact_face] : polygon.opposite_face;
    const Vector3d place =
        own ? polygon.own.col(corner) : polygon.opposite.col(corner);
    const Vector3d n = surface_.normal.col(node);
    double share = 0;
    for (int k = 0; k < 3; ++k)
      if (is_free_along(faces_.vertices(k, face), n, prescribed_))
        share += place[k];
    if (share < enough) return;
    for (int k = 0; k < 3; ++k) {
      const int vertex = faces_.vertices(k, face);
      if (place[k] <= no_share || !is_free_along(vertex, n, prescribed_))
        continue;
      double& asked = wanted[vertex][node];
      asked = std::max(asked, depth / share);
    }
  }

  Vector3d change(int vertex, const std::map<int, double>& depths,
                  double sign) const {
    Matrix3Xd away(3, count_of(depths));
    VectorXd deep(count_of(depths));
    Index row = 0;
    for (const auto& [node, depth] : depths) {
      away.col(row) = sign * surface_.normal.col(node);
      deep[row++] = depth;
    }
    return clearing(vertex, away, deep, prescribed_, largest_);
  }

  const Facets<3>& faces_;
  const ContactSurface& surface_;
  const SurfaceLaw& law_;
  const Flags& prescribed_;
  double largest_;
  VectorXd u_;
};

}  // namespace

VectorXd facing_contact_error(const SolidMesh& mesh, const Facets<3>& faces,
                              const ContactSurface& surface,
                              const SurfaceLaw& law,
                              const Ref<const Matrix3Xd>& traction,
                              const Ref<const VectorXd>& displacement) {
  const std::vector<FrictionCone> cones = law_cones(law, surface);
  const double least = rounding_of_slip(law, displacement);
  VectorXd result = VectorXd::Zero(surface.face_count());
  for (const FacingPolygon& polygon : surface.polygons) {
    const int m = polygon.contact_face;
    const PolygonJump jump(faces, surface, law, polygon, displacement);
    const double area = facet_measure(mesh, faces, surface.face[m]);
    for (int a = 0; a < jump.node_count(); ++a) {
      const int node = jump.node(a);
      const VectorXd f =
          integrand_at(jump, a, cones[node], traction.col(node), least);
      result[m] += 2 * area * integral_of(polygon, jump, a, f);
    }
  }
  return result;
}

VectorXd facing_admissible_displacement(const Facets<3>& faces,
                                        const ContactSurface& surface,
                                        const SurfaceLaw& law,
                                        const Ref<const VectorXd>& displacement,
                                        const Flags& prescribed) {
  return FacingClearing(faces, surface, law, displacement, prescribed)
      .displacement();
}

DeepestNode deepest_facing_node(const Facets<3>& faces,
                                const ContactSurface& surface,
                                const SurfaceLaw& law,
                                const Ref<const VectorXd>& displacement) {
  DeepestNode deepest;
  for (const FacingPolygon& polygon : surface.polygons) {
    const PolygonJump jump(faces, surface, law, polygon, displacement);
    for (int k = 0; k < jump.corner_count(); ++k)
      for (int a = 0; a < jump.node_count(); ++a) {
        const double depth = jump.components(a, k)[0];
        if (jump.share(a, k) > no_share && depth > deepest.depth)
          deepest = {depth, jump.node(a)};
      }
  }
  return deepest;
}

BetweenNodes facing_between_nodes(const Facets<3>& faces,
                                  const ContactSurface& surface,
                                  const SurfaceLaw& law,
                                  const SurfaceTractions& tractions,
                                  const Ref<const VectorXd>& displacement) {
  const std::vector<FrictionCone> cones = law_cones(law, surface);
  BetweenNodes found;
  for (const FacingPolygon& polygon : surface.polygons) {
    const int m = polygon.contact_face;
    const FaceFields face = fields_on_face(surface, cones, m, tractions.col(m));
    FaceFields part{
        face.normal * polygon.own,
        face.traction * polygon.own,
        motions_of({faces, surface, law, polygon, displacement}, surface),
        {}};
    for (const auto& place : polygon.own.colwise())
      // rounding of a place is none of a large bound
      part.cone.push_back(cone_between(face.cone, place.cwiseMax(0)));
    note(part, face.normal, m, found);
  }
  return found;
}

}  // namespace ffcontact
