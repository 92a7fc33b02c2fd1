// SPDX-License-Identifier: GPL-3.0-or-later
/// Example 2 of [CHH01] without FreeFEM: half of a block 80 x 40 that a pressure on its top holds on a rigid plane (mm, N, MPa).
#include <cmath>
#include <ffcontact/ffcontact.hpp>
#include <iostream>

using namespace ffcontact;

enum Side { bottom = 1, right, top, left };
constexpr int n = 16;  // squares along a side
constexpr double width = 40, pressure = 5, E = 13e3, nu = 0.2, mu = 0.3;

/// n x n squares of two triangles; every edge of the boundary has a label.
Mesh block() {
  const auto id = [](int i, int j) { return j * (n + 1) + i; };
  Mesh mesh;
  mesh.vertices.resize(2, (n + 1) * (n + 1));
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      mesh.vertices.col(id(i, j)) << width * i / n, width * j / n;
  mesh.cells.resize(3, 2 * n * n);
  for (int s = 0; s < n * n; ++s) {
    const int a = id(s % n, s / n), b = a + 1, d = a + n + 1, c = d + 1;
    mesh.cells.middleCols<2>(2 * s) << a, a, b, c, c, d;
  }
  mesh.boundary.resize(2, 4 * n);
  for (int k = 0; k < n; ++k)
    mesh.boundary.middleCols<4>(4 * k) << id(k, 0), id(n, k), id(k, n),
        id(0, k), id(k + 1, 0), id(n, k + 1), id(k + 1, n), id(0, k + 1);
  mesh.boundary_label = Vector4i(bottom, right, top, left).replicate(n, 1);
  return mesh;
}

int main() {
  const Topology topology = topology_of(block());
  const Mesh& mesh = topology.mesh;
  const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  const double G = E / (2 * (1 + nu));
  const Hooke hooke(mesh.cell_count(), isotropic(lambda, G));

  // A and b as FreeFEM assembles them: dofs 2 v and 2 v + 1 at vertex v, 1e30 on the diagonal where a dof is prescribed.
  RowMatrix A = stiffness(mesh, hooke);
  VectorXd b = VectorXd::Zero(A.rows());
  // of the tractions, two components at each end of an edge
  Matrix4Xd moments = Matrix4Xd::Zero(4, mesh.boundary.cols());
  for (int edge = 0; edge < mesh.boundary.cols(); ++edge)
    for (int end = 0; end < 2; ++end) {
      const int dof = 2 * mesh.boundary(end, edge);
      if (mesh.boundary_label[edge] == right) A.coeffRef(dof, dof) = 1e30;
      if (mesh.boundary_label[edge] == top)
        moments(2 * end + 1, edge) = -pressure * width / n / 2;
      b[dof + 1] += moments(2 * end + 1, edge);
    }
  const ElasticSystem system = elastic_system(A, b);

  const ContactLine line = contact_line(mesh, topology.edges, {bottom});
  ContactLaw law;
  law.friction = VectorXd::Constant(line.node_count(), mu);
  const ContactSolution solution = solve_contact(mesh, line, law, system);
  const BodyLoadsOfAll no_loads = BodyLoadsOfAll::Zero(6, mesh.cell_count());
  const SolvedBody solved{
      hooke,    solution.displacement, solution.pressure, law, moments,
      no_loads, solution.stiffness};
  const Estimate estimate = estimate_error(topology, line, system, solved);

  const double force = solution.force.row(0).sum();
  const double off = std::abs(force / (pressure * width) + 1);
  std::cout << "normal force " << force << " N/mm, eps "
            << 100 * estimate.relative << " %\n";
  return estimate.admissible && estimate.relative < 0.012 && off < 1e-9 ? 0 : 1;
}
