// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/facing_surface.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// Faces that face less than this part of their area face nothing.
constexpr double least_faced = 1e-6;
/// A hat that reaches this far on what is faced carries a multiplier.
constexpr double reaches = 0.5;
/// det of (int chi chi') with a diagonal of 1 below which functions are all but
/// dependent; 1/2 on a whole triangle.
constexpr double dependent = 1e-4;
/// Weights below this are rounding.
constexpr double no_weight = 1e-13;
/// Gaps below this part of the size of a node are none.
constexpr double no_gap = 1e-10;

/// Integrals over the parts of a contact face that face something.
struct FaceIntegrals {
  double area = 0;
  Vector3d reach = Vector3d::Zero();     ///< largest phi of each corner
  Matrix3d mass = Matrix3d::Zero();      ///< int phi phi'
  Vector3d distance = Vector3d::Zero();  ///< int phi s
  /// int phi phi_j of the vertices j of the opposite body
  std::map<int, Vector3d> opposite;
};

/// Adds integrals over a triangle of a polygon by the midpoints of its sides, which is
/// exact for products of two linear functions.
void add_triangle(const FacingPolygon& polygon, const Vector3i& corners,
                  const Vector3i& vertices, double area,
                  FaceIntegrals& integrals) {
  for (int k = 0; k < 3; ++k) {
    const int a = corners[k], b = corners[(k + 1) % 3];
    const Vector3d phi = 0.5 * (polygon.own.col(a) + polygon.own.col(b));
    const Vector3d other =
        0.5 * (polygon.opposite.col(a) + polygon.opposite.col(b));
    const double s = 0.5 * (polygon.distance[a] + polygon.distance[b]);
    const double weight = area / 3;
    integrals.area += weight;
    integrals.mass += weight * phi * phi.transpose();
    integrals.distance += weight * s * phi;
    for (int j = 0; j < 3; ++j) {
      const auto place =
          integrals.opposite.emplace(vertices[j], Vector3d::Zero()).first;
      place->second += weight * other[j] * phi;
    }
  }
}

void add_polygon(const Facets<3>& faces, const FacingPolygon& polygon,
                 double face_area, FaceIntegrals& integrals) {
  const Vector3i vertices = faces.vertices.col(polygon.opposite_face);
  integrals.reach = integrals.reach.cwiseMax(polygon.own.rowwise().maxCoeff());
  for (int k = 2; k < polygon.own.cols(); ++k) {
    const Vector3i corners(0, k - 1, k);
    const Matrix3d at = polygon.own(Eigen::all, corners);
    const double area = face_area * std::abs(at.determinant());
    add_triangle(polygon, corners, vertices, area, integrals);
  }
}

/// chi = C phi, C' of the corners that are given; the others give their hats in equal
/// shares.
MatrixXd shared_hats(const std::vector<int>& kept) {
  const auto count = static_cast<Index>(kept.size());
  MatrixXd C = MatrixXd::Constant(count, 3, 1.0 / static_cast<double>(count));
  for (Index a = 0; a < count; ++a) {
    C.col(kept[a]).setZero();
    C(a, kept[a]) = 1;
  }
  return C;
}

/// The functions of a face: its corners that carry multipliers, C of chi = C phi, and
/// psi = B phi.
struct DualFunctions {
  std::vector<int> kept;
  MatrixXd C, B;
  VectorXd weight;  ///< int psi = int chi
  MatrixXd mass;    ///< int chi chi'
};

double relative_determinant(const MatrixXd& gram) {
  return gram.determinant() / gram.diagonal().prod();
}

DualFunctions dual_functions(const FaceIntegrals& integrals) {
  DualFunctions functions;
  const double enough = std::min(reaches, integrals.reach.maxCoeff());
  for (int k = 0; k < 3; ++k)
    if (integrals.reach[k] >= enough - no_weight) functions.kept.push_back(k);
  for (;;) {
    functions.C = shared_hats(functions.kept);
    functions.mass = functions.C * integrals.mass * functions.C.transpose();
    functions.weight = functions.mass.rowwise().sum();
    if (functions.kept.size() == 1 ||
        relative_determinant(functions.mass) > dependent) {
      functions.B = functions.weight.asDiagonal() * functions.mass.inverse() *
                    functions.C;
      return functions;
    }
    Index least;
    functions.weight.minCoeff(&least);
    functions.kept.erase(functions.kept.begin() + least);
  }
}

/// Adds up A_i, A_i v_i and A_i g_i node by node.
class Coupling {
 public:
  Coupling(const SolidMesh& mesh, const Facets<3>& faces,
           const ContactSurface& surface,
           const std::vector<FacingPolygon>& polygons, Flags glued)
      : mesh_(mesh),
        faces_(faces),
        surface_(surface),
        area_(VectorXd::Zero(surface.node_count())),
        gap_(VectorXd::Zero(surface.node_count())),
        is_faced_(surface.face_count(), 0),
        carries_none_(std::move(glued)),
        weights_(surface.node_count()) {
    carries_none_.resize(mesh.vertex_count(), 0);
    for (const FacingPolygon& polygon : polygons)
      for (int v : faces.vertices.col(polygon.opposite_face))
        carries_none_[v] = 1;
  }

  void add_face(int m, FaceIntegrals integrals) {
    const double whole = facet_measure(mesh_, faces_, surface_.face[m]);
    leave_out_shared(m, integrals);
    if (integrals.area < least_faced * whole || integrals.reach.isZero(0))
      return;
    is_faced_[m] = 1;
    const DualFunctions psi = dual_functions(integrals);
    const auto& corners = faces_.vertices.col(surface_.face[m]);
    const MatrixXd own = psi.B * integrals.mass;
    const VectorXd distance = psi.B * integrals.distance;
    for (std::size_t a = 0; a < psi.kept.size(); ++a) {
      const auto row = static_cast<Index>(a);
      const int node = surface_.face_node(psi.kept[a], m);
      area_[node] += psi.weight[row];
      gap_[node] += distance[row];
      for (std::size_t b = 0; b < psi.kept.size(); ++b)
        mass_.emplace_back(node, surface_.face_node(psi.kept[b], m),
                           psi.mass(row, static_cast<Index>(b)));
      std::map<int, double>& weights = weights_[node];
      for (const auto& [vertex, integral] : integrals.opposite)
        weights[vertex] += psi.B.row(row).dot(integral);
      if (psi.kept.size() == 3) continue;  // v of the own trace is u_i
      weights[surface_.vertex[node]] += psi.weight[row];
      for (int k = 0; k < 3; ++k) weights[corners[k]] -= own(row, k);
    }
  }

  FacingSurface surface(const std::vector<FacingPolygon>& polygons) const {
    FacingSurface result;
    const std::vector<int> nodes = carriers();
    ContactSurface& part = result.surface;
    part.vertex = surface_.vertex(nodes);
    part.normal = surface_.normal(Eigen::all, nodes);
    part.area = area_(nodes);
    const VectorXi number = numbers(nodes);
    put_faces(number, part);
    put_polygons(polygons, part);
    put_weights(nodes, part);
    Triplets mass;
    for (const auto& entry : mass_)
      mass.emplace_back(number[entry.row()], number[entry.col()],
                        entry.value());
    part.mass = packed(part.node_count(), part.node_count(), mass);
    result.gap = gap_(nodes).cwiseQuotient(part.area);
    for (Index i = 0; i < result.gap.size(); ++i)
      if (std::abs(result.gap[i]) < no_gap * std::sqrt(part.area[i]))
        result.gap[i] = 0;
    return result;
  }

 private:
  /// Vertices of both bodies, as at the front of a crack, and those that are glued carry
  /// nothing: the jump there is 0 already.
  void leave_out_shared(int m, FaceIntegrals& integrals) const {
    for (int k = 0; k < 3; ++k)
      if (carries_none_[faces_.vertices(k, surface_.face[m])])
        integrals.reach[k] = 0;
  }

  std::vector<int> carriers() const {
    return numbers_where(area_.size(), [&](int i) { return area_[i] > 0; });
  }

  /// Of all nodes in the part, or -1.
  VectorXi numbers(const std::vector<int>& nodes) const {
    VectorXi number = VectorXi::Constant(surface_.node_count(), -1);
    for (int i = 0; i < count_of(nodes); ++i) number[nodes[i]] = i;
    return number;
  }

  std::vector<int> faced() const {
    return numbers_where(surface_.face_count(),
                         [&](int m) { return is_faced_[m]; });
  }

  void put_faces(const VectorXi& number, ContactSurface& part) const {
    const std::vector<int> kept = faced();
    part.face = surface_.face(kept);
    part.face_node = surface_.face_node(Eigen::all, kept);
    for (int& node : part.face_node.reshaped()) node = number[node];
  }

  void put_polygons(const std::vector<FacingPolygon>& polygons,
                    ContactSurface& part) const {
    VectorXi number(surface_.face_count());
    for (int m = 0, next = 0; m < surface_.face_count(); ++m)
      number[m] = is_faced_[m] ? next++ : -1;
    for (const FacingPolygon& polygon : polygons) {
      if (!is_faced_[polygon.contact_face]) continue;
      part.polygons.push_back(polygon);
      part.polygons.back().contact_face = number[polygon.contact_face];
    }
  }

  /// A node that follows one vertex follows it to the last digit.
  void put_weights(const std::vector<int>& nodes, ContactSurface& part) const {
    Triplets entries;
    for (int i = 0; i < count_of(nodes); ++i) {
      const double area = part.area[i];
      std::vector<std::pair<int, double>> row;
      for (const auto& [vertex, integral] : weights_[nodes[i]])
        if (std::abs(integral) > no_weight * area)
          row.emplace_back(vertex, integral / area);
      if (row.size() == 1) row[0].second = 1;
      for (const auto& [vertex, weight] : row)
        entries.emplace_back(i, vertex, weight);
    }
    part.opposite =
        packed<WeightsByNode>(count_of(nodes), mesh_.vertex_count(), entries);
  }

  const SolidMesh& mesh_;
  const Facets<3>& faces_;
  const ContactSurface& surface_;
  VectorXd area_, gap_;
  Triplets mass_;
  Flags is_faced_;
  Flags carries_none_;  ///< of each vertex
  std::vector<std::map<int, double>> weights_;
};

}  // namespace

FacingSurface facing_surface(const SolidMesh& mesh, const Facets<3>& faces,
                             const ContactSurface& surface,
                             const std::vector<FacingPolygon>& polygons,
                             const Flags& glued) {
  std::map<int, FaceIntegrals> of_face;
  for (const FacingPolygon& polygon : polygons) {
    const int face = surface.face[polygon.contact_face];
    add_polygon(faces, polygon, facet_measure(mesh, faces, face),
                of_face[polygon.contact_face]);
  }
  Coupling coupling(mesh, faces, surface, polygons, glued);
  for (const auto& [m, integrals] : of_face) coupling.add_face(m, integrals);
  return coupling.surface(polygons);
}

}  // namespace ffcontact
