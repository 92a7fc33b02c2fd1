// SPDX-License-Identifier: GPL-3.0-or-later
// Matrices, loads, laws and fields of any kind on meshes that are fine: what takes them says what is wrong, or goes on.
#include "bytes/data.hpp"
#include "ffcontact/contact/rigid_tool.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/interface/contact_line.hpp"

using namespace ffcontact;

namespace {

/// The stiffness with some entries replaced, clamped at the top as a rule.
RowMatrix any_matrix(fuzz::Bytes& bytes, const Mesh& mesh) {
  RowMatrix A = stiffness(mesh, Hooke(mesh.cell_count(), isotropic(400, 300)));
  constexpr double tgv = 1e30;
  const int top = static_cast<int>(mesh.vertices.row(1).maxCoeff());
  if (bytes.next() < 208)
    for (int v = 0; v < mesh.vertex_count(); ++v)
      if (mesh.vertices(1, v) == top)
        A.coeffRef(2 * v, 2 * v) = A.coeffRef(2 * v + 1, 2 * v + 1) = tgv;
  for (int k = bytes.up_to(4); k > 0; --k) {
    const int i = bytes.next() % static_cast<int>(A.rows()),
              j = bytes.next() % static_cast<int>(A.cols());
    const double value = bytes.number();
    A.coeffRef(i, j) = value;
    if (bytes.next() < 128) A.coeffRef(j, i) = value;
  }
  if (bytes.next() >= 240) A.conservativeResize(A.rows() - 1, A.cols());
  return A;
}

/// As many as wanted, as a rule.
VectorXd any_values(fuzz::Bytes& bytes, Index wanted) {
  const int odd = bytes.next();
  return bytes.numbers(odd < 232 ? wanted : odd % (wanted + 3));
}

ContactLaw<2> any_law(fuzz::Bytes& bytes, int nodes) {
  ContactLaw<2> law;
  const int kind = bytes.next();
  law.multiplier = kind % 2 == 0 ? Multiplier::force : Multiplier::pressure;
  law.friction = any_values(bytes, nodes).cwiseAbs();
  if (kind % 8 == 3) law.friction = any_values(bytes, nodes);
  if (kind % 16 < 4) law.slip_bound = any_values(bytes, nodes);
  if (kind % 32 < 8) law.shear_limit = any_values(bytes, nodes);
  if (kind % 64 < 32) law.gap = any_values(bytes, nodes);
  if (kind % 128 < 32) law.previous = any_values(bytes, nodes);
  return law;
}

SolvedBody<2> any_body(fuzz::Bytes& bytes, const Mesh& mesh,
                       const ContactLaw<2>& law,
                       const ContactSolution<2>& solution) {
  SolvedBody<2> body{Hooke(mesh.cell_count(), isotropic(400, 300)),
                     solution.displacement,
                     solution.pressure,
                     law,
                     Matrix4Xd::Zero(4, mesh.boundary.cols()),
                     BodyLoadsOfCells<2>::Zero(6, mesh.cells.cols()),
                     solution.stiffness};
  const int spoilt = bytes.next();
  if (spoilt % 8 == 1)
    body.displacement = any_values(bytes, 2 * mesh.vertex_count());
  if (spoilt % 8 == 2) body.neumann.setConstant(bytes.number());
  if (spoilt % 8 == 3) body.neumann.resize(4, bytes.up_to(20));
  if (spoilt % 8 == 4) body.hooke[0].setConstant(bytes.number());
  if (spoilt % 8 == 5) body.multipliers.resize(2, bytes.up_to(6));
  if (spoilt % 8 == 6) {
    body.springs = BoundarySprings<2>(mesh.boundary.cols() - bytes.up_to(1));
    body.springs.stiffness.reshaped() =
        bytes.numbers(body.springs.stiffness.size());
  }
  return body;
}

void solve_and_judge(fuzz::Bytes& bytes, const Mesh& mesh) {
  const Topology<2> topology = topology_of(mesh);
  const ContactLine line = contact_line(mesh, topology.facets, {1});
  const RowMatrix A = any_matrix(bytes, mesh);
  const VectorXd b = any_values(bytes, 2 * mesh.vertex_count());
  const ElasticSystem system = elastic_system(A, b);
  const ContactLaw<2> law = any_law(bytes, line.node_count());
  ContactSettings settings;
  settings.max_iterations = 1 + bytes.up_to(40);
  if (bytes.next() < 64)
    settings.initial_state.assign(bytes.up_to(6), ContactState::open);
  if (bytes.next() < 64) {
    RigidTool tool;
    tool.free = Matrix3d::Identity().leftCols(bytes.up_to(3));
    tool.push = bytes.numbers(3);
    solve_contact_with_tool(mesh, line, law, system, tool, settings);
  }
  const ContactSolution<2> solution =
      solve_contact(mesh, line, law, system, settings);
  EstimateSettings<2> sweeps;
  sweeps.relaxation.steps = bytes.up_to(2) - (bytes.next() >= 248 ? 1 : 0);
  estimate_error(topology, line, system, any_body(bytes, mesh, law, solution),
                 sweeps);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const Mesh mesh = fuzz::any_mesh(bytes);
  fuzz::refused_or_done([&] {
    require_valid(mesh);
    solve_and_judge(bytes, mesh);
  });
  return 0;
}
