// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/facing_error.hpp"

#include <algorithm>
#include <map>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/bodies/clearing.hpp"
#include "ffcontact/estimate/bodies/contact_subset.hpp"
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

/// Calls ask(corner, depth) for how deep the corners of a polygon are.
template <class Ask>
void ask_at_corners(const FaceMotion& motion, const Ask& ask) {
  for (int k = 0; k < motion.corners(); ++k) ask(k, motion.depth(k));
}

/// Calls ask(corner, depth) for how far pairs of corners of a polygon must go along their
/// normals so that it keeps clear between them.
template <class Ask>
void ask_between(const FacingPolygon& polygon, const FaceMotion& motion,
                 bool alone, const Ask& ask) {
  for (const FanTriangle& triangle : fan_of(polygon.own)) {
    if (deepest_on(motion, triangle.corner) == 0) continue;
    for (int k = 0; k < 3; ++k) {
      const int first = triangle.corner[k],
                second = triangle.corner[(k + 1) % 3];
      const double depth = depth_between(motion, first, second, alone);
      ask(first, depth);
      ask(second, depth);
    }
  }
}

/// Which body gives way.
enum class Side { own, opposite };

/// What vertices are asked for: how far along the normal of which node.
using Wanted = std::map<int, std::map<int, double>>;

class FacingClearing {
 public:
  FacingClearing(const Facets<3>& faces, const ContactSurface& surface,
                 const ContactLaw<3>& law,
                 const Ref<const VectorXd>& displacement,
                 const Flags& prescribed)
      : faces_(faces),
        surface_(surface),
        law_(law),
        prescribed_(prescribed),
        largest_(largest_clearing(law, displacement)),
        u_(displacement) {}

  VectorXd displacement() && {
    for (double enough : enough_shares)
      for (Side side : {Side::own, Side::opposite})
        give_way(side, enough,
                 [](const FacingPolygon&, const FaceMotion& motion,
                    const auto& ask) { ask_at_corners(motion, ask); });
    return std::move(u_);
  }

  /// The same between the corners, which one move may push in where another one clears.
  VectorXd displacement_between() && {
    constexpr int most_passes = 20;
    for (int pass = 0; pass < most_passes; ++pass) {
      const bool is_clear =
          give_way(pass % 2 == 0 ? Side::own : Side::opposite,
                   enough_shares[std::min(pass / 2, 2)],
                   [&](const FacingPolygon& polygon, const FaceMotion& motion,
                       const auto& ask) {
                     ask_at_corners(motion, ask);
                     ask_between(polygon, motion, pass > 0, ask);
                   });
      if (is_clear) break;
    }
    return std::move(u_);
  }

 private:
  /// @param ask_all  calls ask(corner, depth) for what a polygon asks for
  /// @return whether none does
  template <class AskAll>
  bool give_way(Side side, double enough, const AskAll& ask_all) {
    Wanted wanted;
    bool none = true;
    for (const FacingPolygon& polygon : surface_.polygons) {
      const FaceHats hats = face_hats(surface_, polygon.contact_face);
      const MatrixXd shares = hats.hat.transpose() * polygon.own;
      ask_all(polygon, motion_on_polygon(faces_, surface_, law_, polygon, u_),
              [&](int corner, double depth) {
                if (depth <= 0) return;
                none = false;
                for (int a = 0; a < count_of(hats.node); ++a)
                  if (shares(a, corner) > no_share)
                    ask(polygon, side, corner, hats.node[a], depth, enough,
                        wanted);
              });
    }
    const double sign = side == Side::own ? -1 : 1;
    for (const auto& [vertex, depths] : wanted)
      u_.segment<3>(dof_of<3>(vertex, 0)) += change(vertex, depths, sign);
    return none;
  }

  /// What one corner asks for.
  void ask(const FacingPolygon& polygon, Side side, int corner, int node,
           double depth, double enough, Wanted& wanted) const {
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
  const ContactLaw<3>& law_;
  const Flags& prescribed_;
  double largest_;
  VectorXd u_;
};

}  // namespace

VectorXd facing_contact_error(const SolidMesh& mesh, const Facets<3>& faces,
                              const ContactSurface& surface,
                              const ContactLaw<3>& law,
                              const TractionFields& traction,
                              const Ref<const VectorXd>& displacement) {
  const std::vector<FrictionCone> cones = law_cones(law);
  const double rounding = rounding_of_slip(law, displacement);
  VectorXd result = VectorXd::Zero(surface.face_count());
  for (const FacingPolygon& polygon : surface.polygons) {
    const int m = polygon.contact_face;
    if (is_bonded<3>(surface, law, m)) continue;
    const FaceMotion motion =
        motion_on_polygon(faces, surface, law, polygon, displacement);
    const auto [r, bound] =
        traction_on_face(surface, cones, m, traction).between(polygon.own);
    const double area = facet_measure(mesh, faces, surface.face[m]);
    for (const FanTriangle& triangle : fan_of(polygon.own)) {
      const FaceCosts costs = face_costs(motion, triangle.corner, rounding);
      result[m] += 2 * area * triangle.share *
                   (bound(triangle.corner).dot(costs.friction) +
                    r.pressing(triangle.corner).dot(costs.depth) -
                    r.turned(Eigen::all, triangle.corner)
                        .cwiseProduct(costs.slip)
                        .sum());
    }
  }
  return result;
}

VectorXd facing_admissible_displacement(const Facets<3>& faces,
                                        const ContactSurface& surface,
                                        const ContactLaw<3>& law,
                                        const Ref<const VectorXd>& displacement,
                                        const Flags& prescribed) {
  return FacingClearing(faces, surface, law, displacement, prescribed)
      .displacement();
}

VectorXd facing_cleared_between(const Facets<3>& faces,
                                const ContactSurface& surface,
                                const ContactLaw<3>& law,
                                const Ref<const VectorXd>& displacement,
                                const Flags& prescribed) {
  return FacingClearing(faces, surface, law, displacement, prescribed)
      .displacement_between();
}

DeepestNode deepest_facing_node(const Facets<3>& faces,
                                const ContactSurface& surface,
                                const ContactLaw<3>& law,
                                const Ref<const VectorXd>& displacement) {
  DeepestNode deepest;
  for (const FacingPolygon& polygon : surface.polygons) {
    const FaceMotion motion =
        motion_on_polygon(faces, surface, law, polygon, displacement);
    for (const FanTriangle& triangle : fan_of(polygon.own)) {
      const double depth = deepest_on(motion, triangle.corner);
      if (depth <= deepest.depth) continue;
      const FaceHats hats = face_hats(surface, polygon.contact_face);
      const VectorXd shares =
          hats.hat.transpose() *
          polygon.own.col(deepest_corner(motion, triangle.corner));
      Index nearest;
      shares.maxCoeff(&nearest);
      deepest = {depth, hats.node[nearest]};
    }
  }
  return deepest;
}

BetweenNodes facing_between_nodes(const Facets<3>& faces,
                                  const ContactSurface& surface,
                                  const ContactLaw<3>& law,
                                  const TractionFields& traction,
                                  const Ref<const VectorXd>& displacement) {
  const std::vector<FrictionCone> cones = law_cones(law);
  BetweenNodes found;
  for (const FacingPolygon& polygon : surface.polygons) {
    const int m = polygon.contact_face;
    if (is_bonded<3>(surface, law, m)) continue;
    note(traction_on_face(surface, cones, m, traction).between(polygon.own),
         motion_on_polygon(faces, surface, law, polygon, displacement),
         surface.normal(Eigen::all, face_hats(surface, m).node), m, found);
  }
  return found;
}

}  // namespace ffcontact
