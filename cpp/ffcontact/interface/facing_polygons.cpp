// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/facing_polygons.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/convex_polygon.hpp"
#include "ffcontact/interface/labelled_facets.hpp"

namespace ffcontact {

namespace {

/// Polygons below this part of the contact face are rounding.
constexpr double no_area = 1e-14;
/// Faces that a contact direction meets at less than this, as a cosine, are not faced.
constexpr double grazing = 1e-6;

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

/// A part of an opposite face.
struct SeenPart {
  int face;
  SeenFace seen;
  ConvexPolygon polygon;
  double distance;  ///< mean [mm]
};

class FacePairing {
 public:
  FacePairing(const SolidMesh& mesh, const Facets<3>& faces,
              const ContactSurface& surface, const std::vector<int>& labels)
      : mesh_(mesh),
        faces_(faces),
        surface_(surface),
        target_(labelled_facets(mesh, faces, labels)) {
    require_separate();
  }

  std::vector<FacingPolygon> polygons() const {
    std::vector<FacingPolygon> found;
    for (int m = 0; m < surface_.face_count(); ++m) add_face(m, found);
    if (found.empty()) refuse_unfaced();
    return found;
  }

 private:
  void require_separate() const {
    Flags own(mesh_.vertex_count(), 0);
    for (int v : surface_.vertex) own[v] = 1;
    for (int face : target_)
      for (int v : faces_.vertices.col(face))
        if (own[v])
          refuse("vertex ", v, " ", in_words(mesh_.place(v)),
                 " is on both contact surfaces: bodies that face each other "
                 "share no vertex");
  }

  [[noreturn]] void refuse_unfaced() const {
    const int face = surface_.face[0];
    const Vector3d x =
        mesh_.origin +
        facet_points<3>(mesh_, faces_.vertices.col(face)).rowwise().mean();
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
    const Matrix3d x =
        frame.transpose() *
        (facet_points<3>(mesh_, faces_.vertices.col(face)).colwise() - start);
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

  /// All parts of opposite faces that a contact face looks at, nearest first.
  std::vector<SeenPart> parts(const SeenFace& own, const Matrix3d& frame,
                              const Vector3d& start, double least) const {
    std::vector<SeenPart> found;
    for (int face : target_) {
      const SeenFace other = seen(face, frame, start);
      if (is_apart(own, other)) continue;
      const double size = facet_measure(mesh_, faces_, face);
      if (-polygon_area(other.corners) < grazing * size) continue;
      SeenPart part = part_of(face, other, own);
      if (polygon_area(part.polygon) > least) found.push_back(std::move(part));
    }
    std::sort(found.begin(), found.end(),
              [](const SeenPart& a, const SeenPart& b) {
                return std::abs(a.distance) < std::abs(b.distance);
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
    const int face = surface_.face[m];
    const Matrix3d frame = seen_along(m);
    const Vector3d start = mesh_.vertices.col(faces_.vertices(0, face));
    const SeenFace own = seen(face, frame, start);
    const double seen_area = polygon_area(own.corners);
    if (!(seen_area > 0)) return;
    const double scale = facet_measure(mesh_, faces_, face) / seen_area;
    const double least = no_area * seen_area;
    const std::vector<SeenPart> all = parts(own, frame, start, least);
    for (const SeenPart& part : all)
      for (const ConvexPolygon& polygon : visible(part, all, least))
        if (const double area = polygon_area(polygon); area > least)
          found.push_back({m, part.face, scale * area, own.coordinates(polygon),
                           part.seen.coordinates(polygon),
                           distances(own, part.seen, polygon),
                           own.coordinates(part.seen.corners)});
  }

  const SolidMesh& mesh_;
  const Facets<3>& faces_;
  const ContactSurface& surface_;
  const std::vector<int> target_;
};

}  // namespace

std::vector<FacingPolygon> facing_polygons(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const std::vector<int>& opposite_labels) {
  return FacePairing(mesh, faces, surface, opposite_labels).polygons();
}

}  // namespace ffcontact
