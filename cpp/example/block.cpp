// SPDX-License-Identifier: GPL-3.0-or-later
/// Example 2 of [CHH01] without FreeFEM: half of a block 80 x 40 that a pressure on its top holds on a rigid plane (mm, N, MPa).
#include <cmath>
#include <ffcontact/ffcontact.hpp>
#include <iostream>

using namespace ffcontact;

int main() {
  enum Side { bottom = 1, right, top };
  const double width = 40, pressure = 5, lambda = 13e3 / 3.6, G = 13e3 / 2.4;
  const Topology<2> topology = topology_of(rectangle({16, 16}, {width, width}));
  const Mesh& mesh = topology.mesh;
  const Hooke hooke(mesh.cell_count(), isotropic(lambda, G));

  // A and b as FreeFEM assembles them, and the tractions once more for the estimate
  RowMatrix A = stiffness(mesh, hooke);
  VectorXd b = VectorXd::Zero(A.rows());
  Matrix4Xd tractions = Matrix4Xd::Zero(4, mesh.boundary.cols());
  add_traction(mesh, top, {0, -pressure}, b, tractions);
  prescribe(mesh, right, 0, 0, A, b);
  const ElasticSystem system = elastic_system(A, b);

  const ContactLine line = contact_line(mesh, topology.facets, {bottom});
  ContactLaw<2> law;
  law.friction = VectorXd::Constant(line.node_count(), 0.3);
  const ContactSolution<2> solution = solve_contact(mesh, line, law, system);
  const BodyLoadsOfCells<2> no_loads =
      BodyLoadsOfCells<2>::Zero(6, mesh.cell_count());
  const SolvedBody<2> solved{
      hooke,    solution.displacement, solution.pressure, law, tractions,
      no_loads, solution.stiffness};
  const Estimate<2> estimate = estimate_error(topology, line, system, solved);

  const double force = solution.force.row(0).sum();
  std::cout << "normal force " << force << " N/mm, eps "
            << 100 * estimate.relative << " %\n";
  const double off = std::abs(force / (pressure * width) + 1);
  return estimate.admissible && estimate.relative < 0.012 && off < 1e-9 ? 0 : 1;
}
