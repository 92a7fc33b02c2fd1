// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
//
#include "contact_arguments.hpp"

namespace ffcontact::plugin {

NamedArguments::Table ContactArguments::table(const NamedArguments::Table& own) {
  NamedArguments::Table table{{"label", &typeid(KN_<long>)},
                              {"friction", &typeid(double)},
                              {"slipbound", &typeid(double)},
                              {"gap", &typeid(double)}};
  table.insert(table.end(), own.begin(), own.end());
  return table;
}

ContactArguments::ContactArguments(Stack stack, const NamedArguments& named, const Fem2D::Mesh* fem_mesh)
    : mesh(mesh_of(fem_mesh)), edges(edges_of(mesh)), line(contact_line(mesh, edges, named.integers(stack, "label"))) {
  law.friction = at_nodes(stack, named.expression("friction"), *fem_mesh, edges, line, 0);
  if (const Expression bound = named.expression("slipbound"))
    law.slip_bound = at_nodes(stack, bound, *fem_mesh, edges, line, 0);
  if (const Expression gap = named.expression("gap")) law.gap = at_nodes(stack, gap, *fem_mesh, edges, line, 0);
  require_valid(law, line);
}

void ContactArguments::require_dofs(const char* name, Eigen::Index count) const {
  const Eigen::Index dofs = 2 * mesh.vertices.cols();
  if (count != dofs) refuse(name, " has size ", count, " but [P1, P1] has ", dofs, " dofs on this mesh");
}

Eigen::Matrix2Xd ContactArguments::pressures(KN<double>* normal, KN<double>* tangential) const {
  require_size("pn", normal->N(), line.node_count());
  require_size("pt", tangential->N(), line.node_count());
  Eigen::Matrix2Xd pressure(2, line.node_count());
  pressure.row(0) = vector_of(normal).transpose();
  pressure.row(1) = vector_of(tangential).transpose();
  return pressure;
}

}  // namespace ffcontact::plugin
