// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/surface_error.hpp"

#include <algorithm>
#include <map>

#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/quadratic_minimum.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/surface_tractions.hpp"

namespace ffcontact {

namespace {

/// As for a line: what a free component has of a normal at least, and how far vertices
/// move against the largest displacement or gap.
constexpr double along_the_surface = 1e-9, farthest_on_surface = 1e3;

/// The smallest change of a vertex that lowers its nodes out of the foundation, or 0.
Vector3d lowering(const ContactSurface& surface, const VectorXd& penetration,
                  const std::vector<int>& nodes,
                  const std::vector<char>& prescribed, double largest) {
  const auto count = static_cast<Index>(nodes.size());
  const VectorXd deep = penetration(nodes);
  if (deep.maxCoeff() <= 0) return Vector3d::Zero();
  MatrixXd away(count, 3);
  for (Index k = 0; k < count; ++k)
    for (int c = 0; c < 3; ++c) {
      const double n = surface.normal(c, nodes[k]);
      const bool is_free =
          !prescribed[dof_of<3>(surface.vertex[nodes[k]], c)] &&
          std::abs(n) > along_the_surface;
      away(k, c) = is_free ? -n : 0;
    }
  const auto change = quadratic_minimum(MatrixXd::Identity(3, 3),
                                        VectorXd::Zero(3), away, deep);
  if (!change || max_norm(*change) > largest) return Vector3d::Zero();
  return *change;
}

}  // namespace

VectorXd contact_error(const SolidMesh& mesh, const Facets<3>& faces,
                       const ContactSurface& surface, const SurfaceLaw& law,
                       const Ref<const Matrix3Xd>& traction,
                       const Ref<const VectorXd>& displacement) {
  const Matrix3Xd w =
      displacement_against_foundation(surface, law, displacement);
  const std::vector<FrictionCone> cones = traction_cones(law, surface);
  VectorXd result(surface.face_count());
  for (int m = 0; m < surface.face_count(); ++m) {
    const Vector3i nodes = surface.face_node.col(m);
    double sum = 0;
    for (int i : nodes)
      for (int j : nodes) {
        const double bound = cones[i].bound(traction(0, i)),
                     product = bound * w.col(j).tail<2>().norm() +
                               traction.col(i).dot(w.col(j));
        sum += (i == j ? 2 : 1) * product;
      }
    result[m] = 2 * facet_measure(mesh, faces, surface.face[m]) / 12 * sum;
  }
  return result;
}

VectorXd admissible_displacement(const ContactSurface& surface,
                                 const SurfaceLaw& law,
                                 const Ref<const VectorXd>& displacement,
                                 const std::vector<char>& prescribed) {
  const VectorXd penetration =
      displacement_against_foundation(surface, law, displacement).row(0);
  const double largest =
      farthest_on_surface * largest_displacement(law, displacement);
  std::map<int, std::vector<int>> nodes_of_vertex;
  for (int i = 0; i < surface.node_count(); ++i)
    nodes_of_vertex[surface.vertex[i]].push_back(i);
  VectorXd u = displacement;
  for (const auto& [vertex, nodes] : nodes_of_vertex)
    u.segment<3>(dof_of<3>(vertex, 0)) +=
        lowering(surface, penetration, nodes, prescribed, largest);
  return u;
}

DeepestNode deepest_node(const ContactSurface& surface, const SurfaceLaw& law,
                         const Ref<const VectorXd>& displacement) {
  DeepestNode deepest;
  const double value =
      displacement_against_foundation(surface, law, displacement)
          .row(0)
          .maxCoeff(&deepest.node);
  deepest.depth = std::max(0.0, value);
  return deepest;
}

}  // namespace ffcontact
