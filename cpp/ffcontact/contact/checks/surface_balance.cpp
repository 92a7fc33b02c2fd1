// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/surface_balance.hpp"

#include <cmath>
#include <vector>

#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"

namespace ffcontact {

namespace {

/// Forces of size 1 that span the cone of a node, from a thousandth outside [3 x k].
Matrix3Xd spanning_forces(const FrictionCone& cone) {
  constexpr int sides = 64;
  if (cone.bonded) return forces_either_way(Matrix3d::Identity());
  if (cone.frictionless()) return Vector3d(-1, 0, 0);
  const bool given = !cone.depends_on_contact();
  const double radius = (given ? 1 : cone.friction) / std::cos(M_PI / sides);
  const double size = given ? radius : std::hypot(1, radius),
               share = radius / size;
  Matrix3Xd forces(3, sides + 1);
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * M_PI * k / sides;
    forces.col(k) = Vector3d(given ? 0 : -1 / size, share * std::cos(angle),
                             share * std::sin(angle));
  }
  forces.col(sides) = Vector3d(-1, 0, 0);
  return forces;
}

}  // namespace

MatrixXd extreme_forces(const ContactSurface& surface, const ContactLaw<3>& law,
                        const MatrixXd& motions) {
  const MatrixXd traces = traces_of(surface, motions);
  const NodalLaw cones = nodal_law(law, surface);
  std::vector<MatrixXd> work;
  Index columns = 0;
  for (int i = 0; i < surface.node_count(); ++i) {
    work.push_back(traces.middleRows<3>(3 * i).transpose() *
                   spanning_forces(cones.cone[i]));
    columns += work.back().cols();
  }
  MatrixXd all(motions.cols(), columns);
  Index next = 0;
  for (const MatrixXd& of_node : work) {
    all.middleCols(next, of_node.cols()) = of_node;
    next += of_node.cols();
  }
  return all;
}

}  // namespace ffcontact
