// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/compliance_ratio.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/norms.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

/// Components of n below this do not move a node along n.
constexpr double along_the_line = 1e-3;
/// Ratios beyond this, as that to a rigid trace, count as this.
constexpr double largest_ratio = 1e12;

/// 1 / (n' K_vv n) on the free components, or 0 at a vertex that none moves along n.
template <int dim>
double nodal_compliance(const ElasticSystem& system, int vertex,
                        const Matrix<double, dim, 1>& n) {
  double stiffness = 0;
  for (int i = 0; i < dim; ++i) {
    const int row = dof_of<dim>(vertex, i);
    if (system.prescribed[row] || std::abs(n[i]) < along_the_line) continue;
    for (int j = 0; j < dim; ++j)
      if (const int column = dof_of<dim>(vertex, j); !system.prescribed[column])
        stiffness += n[i] * system.stiffness.coeff(row, column) * n[j];
  }
  return relative(1, stiffness);
}

/// The mean of its vertices' nodal compliances along n, times its size.
template <int dim>
double facet_compliance(const Facets<dim>& facets, const ElasticSystem& system,
                        int facet, double size,
                        const Matrix<double, dim, 1>& n) {
  double sum = 0;
  for (int v : facets.vertices.col(facet))
    sum += nodal_compliance<dim>(system, v, n);
  return size * sum / dim;
}

/// The mean of the logarithms of ratios.
class MeanRatio {
 public:
  void add(double own, double opposite, double weight) {
    if (own == 0 && opposite == 0) return;
    const double ratio =
        std::clamp(opposite / own, 1 / largest_ratio, largest_ratio);
    sum_ += weight * std::log(ratio);
    weight_ += weight;
  }
  double value() const { return weight_ > 0 ? std::exp(sum_ / weight_) : 1; }

 private:
  double sum_ = 0, weight_ = 0;
};

}  // namespace

double compliance_ratio(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const ElasticSystem& system) {
  MeanRatio mean;
  for (const FacingPiece& piece : line.pieces) {
    const int own = line.edge[piece.contact_edge];
    const Vector2d n = line.edge_normal(piece.contact_edge);
    const auto compliance = [&](int edge) {
      const double length = edge_vector(mesh, edges, edge).norm();
      return facet_compliance<2>(edges, system, edge, length, n);
    };
    mean.add(compliance(own), compliance(piece.opposite_edge),
             (piece.end - piece.begin) * edge_vector(mesh, edges, own).norm());
  }
  return mean.value();
}

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
