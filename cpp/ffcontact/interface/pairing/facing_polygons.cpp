// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/facing_polygons.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/base/plane.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/labelled_facets.hpp"
#include "ffcontact/interface/pairing/convex_polygon.hpp"
#include "ffcontact/interface/pairing/line_of_sight.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/facet_tree.hpp"
#include "ffcontact/mesh/separate_bodies.hpp"

namespace ffcontact {

namespace {

/// Polygons below this part of the contact face are rounding.
constexpr double no_area = 1e-14;
/// Faces that a contact direction meets at less than this, as a cosine, are not faced.
constexpr double grazing = 1e-6;
/// Distances below this part of the size of a contact face are none; nor are those below
/// this part of the largest coordinate.
constexpr double no_distance = 1e-10,
                 coordinates_off = 16 * std::numeric_limits<double>::epsilon();

/// A face seen along a contact direction n: places across n, counter-clockwise where it
/// turns its outside to who looks against n, and heights along n.
struct SeenFace {
  Matrix2Xd corners;  ///< [2 x 3]
  Eigen::RowVector3d height;

  /// Barycentric coordinates of places [3 x k].
  Matrix3Xd coordinates(const Matrix2Xd& places) const {
    Matrix3d at;
    at << corners, Eigen::RowVector3d::Ones();
    Matrix3Xd homogeneous(3, places.cols());
    homogeneous << places, Eigen::RowVectorXd::Ones(places.cols());
    return at.inverse() * homogeneous;
  }
};

/// A contact face, and all that may lie before or behind it.
struct ContactFace {
  int face;  ///< of the mesh
  Matrix3d frame;
  Vector3d start;  ///< where places and heights are counted from
  SeenFace seen;
  double touching;       ///< distances below this are none [mm]
  double least;          ///< areas below this are rounding [mm^2]
  std::vector<int> met;  ///< boundary faces, ascending
};

/// A part of an opposite face.
struct SeenPart {
  int face;
  SeenFace seen;
  ConvexPolygon polygon;
  double distance;  ///< mean [mm]
};

/// A place within a polygon that is on no line which symmetry would draw there.
Vector2d inner_place(const ConvexPolygon& polygon) {
  return 0.9 * polygon.rowwise().mean() + 0.07 * polygon.col(0) +
         0.03 * polygon.col(1);
}

class FacePairing {
 public:
  FacePairing(const SolidMesh& mesh, const Facets<3>& faces,
              const ContactSurface& surface, const std::vector<int>& labels)
      : mesh_(mesh),
        faces_(faces),
        surface_(surface),
        body_(body_of_each_vertex(mesh)),
        boundary_(mesh, faces, boundary_faces(faces)),
        is_target_(faces.count(), 0),
        rounding_(coordinates_off * max_norm(mesh.vertices)) {
    for (int face : labelled_facets(mesh, faces, labels)) is_target_[face] = 1;
  }

  /// The first contact face that touches a target; -1 for none.
  int touching_face() const {
    for (int m = 0; m < surface_.face_count(); ++m)
      if (touches(contact_face(m))) return surface_.face[m];
    return -1;
  }

  std::vector<FacingPolygon> polygons() const {
    std::vector<FacingPolygon> found;
    for (int m = 0; m < surface_.face_count(); ++m) add_face(m, found);
    if (found.empty()) refuse_unfaced();
    return found;
  }

 private:
  bool touches(const ContactFace& own) const {
    for (const SeenPart& part : parts(own))
      if (std::abs(part.distance) <= own.touching) return true;
    return false;
  }

  static std::vector<int> boundary_faces(const Facets<3>& faces) {
    return numbers_where(faces.count(),
                         [&](int f) { return faces.on_boundary(f); });
  }

  [[noreturn]] void refuse_unfaced() const {
    const int face = surface_.face[0];
    const Vector3d x =
        mesh_.origin + facet_points(mesh_, faces_, face).rowwise().mean();
    refuse("no point of the contact surface, as ", in_words(x),
           ", faces a face of the opposite body along its contact direction: "
           "give the labels of two sides that lie opposite to each other, or "
           "normal=");
  }

  /// Columns e1, e2, n.
  static Matrix3d frame_along(const Vector3d& n) {
    Matrix3d columns;
    columns.col(0) = n.unitOrthogonal();
    columns.col(1) = n.cross(columns.col(0));
    columns.col(2) = n;
    return columns;
  }

  /// That of a contact face.
  Matrix3d seen_along(int m) const {
    const auto nodes = surface_.face_node.col(m);
    return frame_along(
        surface_.normal(Eigen::all, nodes).rowwise().sum().normalized());
  }

  /// @param start  where places and heights are counted from
  SeenFace seen(int face, const Matrix3d& frame, const Vector3d& start) const {
    const Matrix3d x = frame.transpose() *
                       (facet_points(mesh_, faces_, face).colwise() - start);
    return {x.topRows<2>(), x.row(2)};
  }

  /// What an opposite face shows to a contact face.
  SeenPart part_of(int face, const SeenFace& other, const SeenFace& own) const {
    const ConvexPolygon shown = other.corners.rowwise().reverse();
    SeenPart part{face, other, intersection(own.corners, shown), 0};
    if (part.polygon.cols() > 0)
      part.distance = distances(own, other, part.polygon).mean();
    return part;
  }

  static VectorXd distances(const SeenFace& own, const SeenFace& other,
                            const Matrix2Xd& places) {
    return (other.height * other.coordinates(places) -
            own.height * own.coordinates(places))
        .transpose();
  }

  bool is_apart(const SeenFace& a, const SeenFace& b) const {
    const auto low = [](const SeenFace& f) {
      return f.corners.rowwise().minCoeff().eval();
    };
    const auto high = [](const SeenFace& f) {
      return f.corners.rowwise().maxCoeff().eval();
    };
    return (low(a).array() >= high(b).array()).any() ||
           (low(b).array() >= high(a).array()).any();
  }

  /// The faces on the lines along n through a contact face, by their boxes.
  std::vector<int> met_by(const ContactFace& own) const {
    const Matrix<double, 2, 3> across = own.frame.leftCols<2>().transpose();
    const Vector2d low = own.seen.corners.rowwise().minCoeff(),
                   high = own.seen.corners.rowwise().maxCoeff();
    return boundary_.met_by([&](const Box<3>& box) {
      const Vector2d middle = across * (box.middle - own.start),
                     half = across.cwiseAbs() * box.half;
      return (middle + half - low).minCoeff() >= -rounding_ &&
             (high - middle + half).minCoeff() >= -rounding_;
    });
  }

  ContactFace contact_face(int m) const {
    ContactFace own;
    own.face = surface_.face[m];
    own.frame = seen_along(m);
    own.start = mesh_.vertices.col(faces_.vertices(0, own.face));
    own.seen = seen(own.face, own.frame, own.start);
    const double area = polygon_area(own.seen.corners);
    own.touching = std::max(rounding_, no_distance * std::sqrt(area));
    own.least = no_area * area;
    own.met = met_by(own);
    return own;
  }

  /// Whether a face turns its side to a place, as who looks along n sees it; faces that
  /// share the edge agree.
  bool is_left_of(int face, int k, const SeenFace& seen,
                  const Vector2d& place) const {
    const int next = (k + 1) % 3;
    const bool turned = faces_.vertices(k, face) > faces_.vertices(next, face);
    const Vector2d p = seen.corners.col(turned ? next : k),
                   q = seen.corners.col(turned ? k : next);
    return (cross(q - p, place - p) > 0) != turned;
  }

  /// Where the line along n through a place of a contact face meets a boundary face.
  std::optional<Crossing> crossing(const ContactFace& own, int face,
                                   const Vector2d& place) const {
    const SeenFace other = seen(face, own.frame, own.start);
    const bool left = is_left_of(face, 0, other, place);
    for (int k = 1; k < 3; ++k)
      if (is_left_of(face, k, other, place) != left) return std::nullopt;
    return Crossing{distances(own.seen, other, place)[0], !left};
  }

  std::vector<Crossing> crossings(const ContactFace& own, const Vector2d& place,
                                  int body) const {
    std::vector<Crossing> found;
    for (int face : own.met)
      if (this->body(face) == body)
        if (const auto next = crossing(own, face, place))
          found.push_back(*next);
    return found;
  }

  int body(int face) const { return body_[faces_.vertices(0, face)]; }

  bool is_faced(const SeenPart& part, const ContactFace& own) const {
    const Vector2d place = inner_place(part.polygon);
    const double distance = distances(own.seen, part.seen, place)[0];
    if (std::abs(distance) <= own.touching) return true;
    const int first = body(own.face), second = body(part.face);
    const LineOfSight line{crossings(own, place, first),
                           crossings(own, place, second), first == second,
                           own.touching};
    return line.is_faced(distance);
  }

  /// All parts of opposite faces on the lines along n through a contact face.
  std::vector<SeenPart> parts(const ContactFace& own) const {
    std::vector<SeenPart> found;
    for (int face : own.met) {
      if (!is_target_[face]) continue;
      const SeenFace other = seen(face, own.frame, own.start);
      if (is_apart(own.seen, other)) continue;
      const double size = facet_measure(mesh_, faces_, face);
      if (-polygon_area(other.corners) < grazing * size) continue;
      SeenPart part = part_of(face, other, own.seen);
      if (polygon_area(part.polygon) > own.least)
        found.push_back(std::move(part));
    }
    return found;
  }

  /// Those that the contact face is inside of or touches first, then what is in front of
  /// it, the nearer before the farther.
  std::vector<SeenPart> faced_parts(const ContactFace& own) const {
    std::vector<SeenPart> found;
    for (SeenPart& part : parts(own))
      if (is_faced(part, own)) found.push_back(std::move(part));
    const auto rank = [&](const SeenPart& part) {
      return std::pair(part.distance > own.touching, std::abs(part.distance));
    };
    std::sort(found.begin(), found.end(),
              [&](const SeenPart& a, const SeenPart& b) {
                return rank(a) < rank(b);
              });
    return found;
  }

  /// Takes from a part what nearer ones hide.
  static std::vector<ConvexPolygon> visible(const SeenPart& part,
                                            const std::vector<SeenPart>& all,
                                            double least) {
    std::vector<ConvexPolygon> left{part.polygon};
    for (const SeenPart& nearer : all) {
      if (&nearer == &part) break;
      std::vector<ConvexPolygon> next;
      for (const ConvexPolygon& polygon : left) {
        if (polygon_area(intersection(polygon, nearer.polygon)) <= least)
          next.push_back(polygon);
        else
          for (ConvexPolygon& piece : difference(polygon, nearer.polygon))
            next.push_back(std::move(piece));
      }
      left = std::move(next);
    }
    return left;
  }

  void add_face(int m, std::vector<FacingPolygon>& found) const {
    const ContactFace own = contact_face(m);
    const double seen_area = polygon_area(own.seen.corners);
    if (!(seen_area > 0)) return;
    const double scale = facet_measure(mesh_, faces_, own.face) / seen_area;
    const std::vector<SeenPart> all = faced_parts(own);
    for (const SeenPart& part : all)
      for (const ConvexPolygon& polygon : visible(part, all, own.least))
        if (const double area = polygon_area(polygon); area > own.least)
          found.push_back({m, part.face, scale * area,
                           own.seen.coordinates(polygon),
                           part.seen.coordinates(polygon),
                           distances(own.seen, part.seen, polygon),
                           own.seen.coordinates(part.seen.corners)});
  }

  const SolidMesh& mesh_;
  const Facets<3>& faces_;
  const ContactSurface& surface_;
  const std::vector<int> body_;  ///< of each vertex
  const FacetTree<3> boundary_;
  Flags is_target_;        ///< of each face
  const double rounding_;  ///< of coordinates [mm]
};

}  // namespace

std::vector<FacingPolygon> facing_polygons(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const std::vector<int>& opposite_labels) {
  return FacePairing(mesh, faces, surface, opposite_labels).polygons();
}

int touching_face(const SolidMesh& mesh, const Facets<3>& faces,
                  const ContactSurface& surface,
                  const std::vector<int>& opposite_labels) {
  return FacePairing(mesh, faces, surface, opposite_labels).touching_face();
}

}  // namespace ffcontact
