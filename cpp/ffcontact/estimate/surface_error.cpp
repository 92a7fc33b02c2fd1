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

VectorXd contact_error(const std::vector<ContactFace>& contact,
                       const SurfaceTractions& tractions) {
  VectorXd result(tractions.cols());
  for (Index m = 0; m < tractions.cols(); ++m)
    result[m] = 2 * contact_term(contact[m], tractions.col(m).reshaped(3, 3));
  return result;
}

double cone_violation(const std::vector<ContactFace>& contact,
                      const SurfaceTractions& tractions) {
  double largest = 0;
  for (Index m = 0; m < tractions.cols(); ++m)
    largest = std::max(
        largest, cone_violation(contact[m], tractions.col(m).reshaped(3, 3)));
  return largest;
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
