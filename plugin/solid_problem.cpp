// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_problem.hpp"

#include <utility>

#include "ffcontact/base/require.hpp"
//
#include "contact_statement.hpp"
#include "solid_views.hpp"
#include "views.hpp"

namespace ffcontact::plugin {

namespace {

/// What several meshes or parameters of plane bodies ask for.
void require_one_solid(const NamedArguments& named, std::size_t meshes) {
  if (meshes > 1)
    refuse("a contact of solids takes one mesh3 for now, got ", meshes);
  for (const char* name : {"opposite", "side"})
    if (named.given(name))
      refuse(name, "= is for plane bodies so far; a solid is on a rigid ",
             "foundation: leave it out");
}

pmesh3 only_mesh(const NamedArguments& named,
                 const std::vector<pmesh3>& meshes) {
  require_one_solid(named, meshes.size());
  return meshes.front();
}

}  // namespace

SolidProblem::SolidProblem(Stack stack, const NamedArguments& named,
                           const std::vector<pmesh3>& meshes)
    : SolidProblem(stack, named, only_mesh(named, meshes),
                   solid_mesh_of(meshes.front())) {}

SolidProblem::SolidProblem(Stack stack, const NamedArguments& named, pmesh3 fem,
                           SolidMesh solid)
    : BodyDofs(3, {0, solid.vertex_count()}),
      mesh(std::move(solid)),
      fem_mesh(fem),
      faces(facets_of(mesh)) {
  require_names_of_bodies(named, stated_of_bodies, 1);
  require_law(named);
  surface = stated_surface(stack, named);
  law = stated_law(stack, named);
  require_valid(law, surface);
}

ContactSurface SolidProblem::stated_surface(Stack stack,
                                            const NamedArguments& named) const {
  const std::vector<int> labels = named.integers(stack, "label");
  ContactSurface own = contact_surface(mesh, faces, labels);
  if (!named.given("normal")) return own;
  Matrix3Xd direction = Matrix3Xd::Zero(3, mesh.vertices.cols());
  for (int c = 0; c < 3; ++c) {
    const VectorXd values = at_nodes(stack, named.component("normal", c, 3),
                                     {*fem_mesh, mesh, faces}, own, 0);
    for (int i = own.node_count() - 1; i >= 0; --i)
      direction(c, own.vertex[i]) = values[i];
  }
  return surface_along(mesh, faces, labels, direction);
}

SurfaceLaw SolidProblem::stated_law(Stack stack,
                                    const NamedArguments& named) const {
  const auto read = [&](const char* name) {
    return at_nodes(stack, named.expression(name), {*fem_mesh, mesh, faces},
                    surface, 0);
  };
  SurfaceLaw stated;
  stated.friction = read("friction");
  if (named.given("slipbound"))
    (named.given("friction") ? stated.shear_limit : stated.slip_bound) =
        read("slipbound");
  if (named.given("gap")) stated.gap = read("gap");
  const Expression before = named.expression("previous");
  KN<double>* u = before ? value_of<KN<double>*>(stack, before) : nullptr;
  if (!u || u->N() == 0) return stated;
  require_dofs("previous", 0, u->N());
  stated.previous = contact_components(surface, vector_of(u)).bottomRows<2>();
  return stated;
}

std::vector<long> SolidProblem::vertices() const {
  return {surface.vertex.begin(), surface.vertex.end()};
}

Matrix3Xd SolidProblem::places() const {
  return mesh.vertices(Eigen::all, surface.vertex).colwise() + mesh.origin;
}

}  // namespace ffcontact::plugin
