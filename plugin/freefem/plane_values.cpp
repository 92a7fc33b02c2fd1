// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/stress/stress_conditions.hpp"
#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"
#include "ffcontact/interface/line_ends.hpp"
//
#include "freefem/plane_values.hpp"
#include "freefem/point_evaluator.hpp"

namespace ffcontact::plugin {

namespace {

/// Evaluates expressions at points of a plane mesh.
class PlanePoint : public PointEvaluator {
 public:
  PlanePoint(Stack stack, const Fem2D::Mesh& mesh)
      : PointEvaluator(stack), mesh_(mesh) {}

  /// Goes to a boundary element, a share `s` of the way from its second local end to its
  /// first.
  void go_to_boundary(int element, double s) {
    int side;
    const int k = mesh_.BoundaryElement(element, side);
    const Fem2D::Triangle& triangle = mesh_[k];
    const R2 along = triangle.Edge(side);
    const R2 normal = along.perp() / -std::sqrt((along, along));
    const R2 first(
        Fem2D::TriangleHat[Fem2D::VerticesOfTriangularEdge[side][0]]);
    const R2 second(
        Fem2D::TriangleHat[Fem2D::VerticesOfTriangularEdge[side][1]]);
    const R2 hat = first * s + second * (1 - s);
    point().set(mesh_, triangle(hat), hat, triangle, mesh_.bedges[element].lab,
                normal, side);
  }
  void go_to(const BoundaryPlace<2>& place) {
    const Fem2D::Mesh::BorderElement& edge = mesh_.bedges[place.column];
    const bool same = first_vertex(place.column) == mesh_(edge[0]);
    go_to_boundary(place.column, place.weights[same ? 0 : 1]);
  }
  int first_vertex(int element) const {
    int side;
    const int k = mesh_.BoundaryElement(element, side);
    return mesh_(k, Fem2D::VerticesOfTriangularEdge[side][0]);
  }
  void go_to_triangle(int t, const R2& hat = R2(1.0 / 3, 1.0 / 3)) {
    const Fem2D::Triangle& triangle = mesh_[t];
    point().set(mesh_, triangle(hat), hat, triangle, triangle.lab);
  }

 private:
  const Fem2D::Mesh& mesh_;
};

/// (h / pi)^2 |f - f~|^2 on one triangle, h = square root of twice its area; f~ is
/// constant on the subtriangles, and subtriangle k holds the points where phi_k is the
/// smallest.
double oscillation_square(const Matrix2Xd& f, const Matrix3Xd& phi,
                          const VectorXd& weight,
                          const Matrix<double, 2, 3>& constant, double area) {
  double square = 0;
  for (Index q = 0; q < weight.size(); ++q) {
    Index k;
    phi.col(q).minCoeff(&k);
    square += weight[q] * (f.col(q) - constant.col(k)).squaredNorm();
  }
  return 2 * area / (M_PI * M_PI) * square;
}

VectorXd values_of(Stack stack, Expression expression, const BodyPart& part,
                   const std::vector<BoundaryPlace<2>>& places) {
  return part.elsewhere ? part.elsewhere->values(expression, part.body, places)
                        : at_boundary(stack, expression, part, places);
}

/// A place on an edge of the joined mesh as one of the body that the edge is of.
BoundaryPlace<2> on_boundary(const BodyPart& part, const Edges& edges,
                             const EdgePlace& at) {
  const int column = edges.boundary_index[at.edge];
  Vector2d weights(1 - at.place, at.place);
  if (part.mesh.boundary(0, column) != edges.vertices(0, at.edge))
    weights.reverseInPlace();
  return {column - part.first_boundary, weights};
}

/// A vector field, 0 where a component is not given.
struct PlaneField {
  Expression x, y;

  bool given() const { return x || y; }
  Vector2d at(const PlanePoint& point) const {
    return {x ? point.value(x) : 0, y ? point.value(y) : 0};
  }
};

/// Adds int F phi of a traction along one boundary edge.
void add_moments(const PlaneField& F, int e, const Mesh& mesh,
                 PlanePoint& point, Matrix4Xd& moments) {
  const Fem2D::QuadratureFormular1d& quadrature = Fem2D::QF_GaussLegendre3;
  const double length = boundary_measure(mesh, e);
  const int first_row = point.first_vertex(e) == mesh.boundary(0, e) ? 0 : 2;
  for (int q = 0; q < quadrature.n; ++q) {
    const double s = quadrature[q].x, weight = length * quadrature[q].a;
    point.go_to_boundary(e, s);
    const Vector2d value = F.at(point);
    moments.block<2, 1>(first_row, e) += weight * s * value;
    moments.block<2, 1>(2 - first_row, e) += weight * (1 - s) * value;
  }
}

/// A body force and the hat functions at the quadrature points of one triangle.
struct SampledForce {
  Matrix2Xd f;
  Matrix3Xd phi;
  VectorXd weight;

  SampledForce(const PlaneField& field, int t, double area, PlanePoint& point) {
    const Fem2D::QuadratureFormular& quadrature = Fem2D::QuadratureFormular_T_5;
    f.resize(2, quadrature.n);
    phi.resize(3, quadrature.n);
    weight.resize(quadrature.n);
    for (int q = 0; q < quadrature.n; ++q) {
      const R2 hat(quadrature[q].x, quadrature[q].y);
      point.go_to_triangle(t, hat);
      f.col(q) = field.at(point);
      phi.col(q) << 1 - hat.x - hat.y, hat.x, hat.y;
      weight[q] = area * quadrature[q].a;
    }
  }

  CellBodyLoads<2> loads() const {
    return (f * weight.asDiagonal()).lazyProduct(phi.transpose());
  }
};

}  // namespace

VectorXd at_boundary(Stack stack, Expression expression, const BodyPart& part,
                     const std::vector<BoundaryPlace<2>>& places) {
  VectorXd values(count_of(places));
  PlanePoint point(stack, *part.fem_mesh);
  for (int i = 0; i < count_of(places); ++i) {
    point.go_to(places[i]);
    values[i] = point.value(expression);
  }
  return values;
}

VectorXd at_nodes(Stack stack, Expression expression, const BodyPart& part,
                  const Edges& edges, const ContactLine& line,
                  const StatedPlaces& places, double otherwise) {
  VectorXd values = VectorXd::Constant(line.node_count(), otherwise);
  if (!expression) return values;
  std::vector<int> node;
  std::vector<BoundaryPlace<2>> at;
  for (
      int e = line.edge_count() - 1; e >= 0;
      --e)  // backwards: a node between two edges ends with the value of the first
    for (int end = 1; end >= 0; --end) {
      if (!ends_at_its_node(line, end, e)) continue;
      node.push_back(line.edge_node(end, e));
      at.push_back(on_boundary(
          part, edges, end == 0 ? places[e].front() : places[e].back()));
    }
  const VectorXd found = values_of(stack, expression, part, at);
  for (int i = 0; i < count_of(node); ++i) values[node[i]] = found[i];
  return values;
}

MatrixXd along_edges(Stack stack, Expression expression, const BodyPart& part,
                     const Edges& edges, const StatedPlaces& places) {
  std::vector<BoundaryPlace<2>> at;
  for (const std::vector<EdgePlace>& of_edge : places)
    for (const EdgePlace& place : of_edge)
      at.push_back(on_boundary(part, edges, place));
  return values_of(stack, expression, part, at)
      .reshaped(samples_of_an_edge, count_of(places));
}

VectorXd at_triangles(Stack stack, Expression expression,
                      const Fem2D::Mesh& fem_mesh, double otherwise) {
  VectorXd values = VectorXd::Constant(fem_mesh.nt, otherwise);
  if (!expression) return values;
  PlanePoint point(stack, fem_mesh);
  for (int t = 0; t < fem_mesh.nt; ++t) {
    point.go_to_triangle(t);
    values[t] = point.value(expression);
  }
  return values;
}

MatrixXd at_quadrature_points(Stack stack, Expression expression,
                              const Fem2D::Mesh& fem_mesh) {
  const Fem2D::QuadratureFormular& quadrature = Fem2D::QuadratureFormular_T_5;
  MatrixXd values = MatrixXd::Zero(quadrature.n, fem_mesh.nt);
  if (!expression) return values;
  PlanePoint point(stack, fem_mesh);
  for (int t = 0; t < fem_mesh.nt; ++t)
    for (int q = 0; q < quadrature.n; ++q) {
      point.go_to_triangle(t, R2(quadrature[q].x, quadrature[q].y));
      values(q, t) = point.value(expression);
    }
  return values;
}

MatrixXd along_boundary(Stack stack, Expression expression,
                        const Fem2D::Mesh& fem_mesh, const Mesh& mesh,
                        const std::vector<double>& places) {
  MatrixXd values =
      MatrixXd::Zero(static_cast<Index>(places.size()), mesh.boundary.cols());
  if (!expression) return values;
  PlanePoint point(stack, fem_mesh);
  for (int e = 0; e < values.cols(); ++e) {
    const bool same = point.first_vertex(e) == mesh.boundary(0, e);
    for (Index q = 0; q < values.rows(); ++q) {
      point.go_to_boundary(e, same ? 1 - places[q] : places[q]);
      values(q, e) = point.value(expression);
    }
  }
  return values;
}

MatrixXd at_gauss_points(Stack stack, Expression expression,
                         const Fem2D::Mesh& fem_mesh, const Mesh& mesh) {
  std::vector<double> places;
  for (int q = 0; q < 3; ++q) places.push_back(FacetQuadrature<2>::hats(q)[1]);
  return along_boundary(stack, expression, fem_mesh, mesh, places);
}

Matrix4Xd traction_moments(Stack stack, Expression Fx, Expression Fy,
                           const Fem2D::Mesh& fem_mesh, const Mesh& mesh) {
  Matrix4Xd moments = Matrix4Xd::Zero(4, mesh.boundary.cols());
  const PlaneField F{Fx, Fy};
  if (!F.given()) return moments;
  PlanePoint point(stack, fem_mesh);
  for (int e = 0; e < mesh.boundary.cols(); ++e)
    add_moments(F, e, mesh, point, moments);
  return moments;
}

BodyForce body_force_loads(Stack stack, Expression fx, Expression fy,
                           const Fem2D::Mesh& fem_mesh, const Mesh& mesh) {
  BodyForce force{BodyLoadsOfCells<2>::Zero(6, mesh.cells.cols()), 0};
  const PlaneField field{fx, fy};
  if (!field.given()) return force;
  PlanePoint point(stack, fem_mesh);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const double area = signed_area(mesh, t);
    const SampledForce sampled(field, t, area, point);
    const CellBodyLoads<2> loads = sampled.loads();
    force.loads.col(t) = loads.reshaped();
    force.oscillation +=
        oscillation_square(sampled.f, sampled.phi, sampled.weight,
                           body_force_of<2>(loads, area), area);
  }
  force.oscillation = std::sqrt(force.oscillation);
  return force;
}

}  // namespace ffcontact::plugin
