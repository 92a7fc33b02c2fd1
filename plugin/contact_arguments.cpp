// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
//
#include "contact_arguments.hpp"

namespace ffcontact::plugin {

namespace {

/// The line by its own normals, or along the directions of normal=.
ContactLine line_of(Stack stack, const NamedArguments& named, const Fem2D::Mesh& fem_mesh, const Mesh& mesh,
                    const Edges& edges) {
  const std::vector<int> labels = named.integers(stack, "label");
  if (!named.given("normal")) return contact_line(mesh, edges, labels);
  const ContactLine line = smooth_contact_line(mesh, edges, labels);
  Eigen::Matrix2Xd direction(2, line.node_count());
  for (int c = 0; c < 2; ++c)
    direction.row(c) = at_nodes(stack, named.component("normal", c, 2), fem_mesh, edges, line, 0).transpose();
  return along_directions(mesh, edges, line, direction);
}

}  // namespace

NamedArguments::Table ContactArguments::table(const NamedArguments::Table& own) {
  NamedArguments::Table table{{"label", &typeid(KN_<long>)},  {"friction", &typeid(double)},
                              {"slipbound", &typeid(double)}, {"gap", &typeid(double)},
                              {"normal", &typeid(E_Array)},   {"previous", &typeid(KN<double>*)}};
  table.insert(table.end(), own.begin(), own.end());
  return table;
}

ContactArguments::ContactArguments(Stack stack, const NamedArguments& named, const Fem2D::Mesh* fem_mesh)
    : mesh(mesh_of(fem_mesh)), edges(edges_of(mesh)), line(line_of(stack, named, *fem_mesh, mesh, edges)) {
  law.friction = at_nodes(stack, named.expression("friction"), *fem_mesh, edges, line, 0);
  if (const Expression bound = named.expression("slipbound"))
    law.slip_bound = at_nodes(stack, bound, *fem_mesh, edges, line, 0);
  if (const Expression gap = named.expression("gap")) law.gap = at_nodes(stack, gap, *fem_mesh, edges, line, 0);
  if (const Expression previous = named.expression("previous")) {
    KN<double>* u = GetAny<KN<double>*>((*previous)(stack));
    if (u->N() > 0) {
      require_dofs("previous", u->N());
      law.previous = contact_components(line, vector_of(u)).row(1);
    }
  }
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
