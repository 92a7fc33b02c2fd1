// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/material_and_loads.hpp"

#include <cmath>
#include <utility>

#include "ffcontact/base/require.hpp"
//
#include "estimate/initial_stress.hpp"
#include "estimate/springs.hpp"

namespace ffcontact::plugin {

namespace {

/// C = lambda 1 x 1 + 2 G I on each triangle.
Hooke isotropic_of(Stack stack, Expression lambda, Expression G,
                   const Fem2D::Mesh& fem_mesh) {
  const VectorXd lambdas = at_triangles(stack, lambda, fem_mesh, 0),
                 Gs = at_triangles(stack, G, fem_mesh, 0);
  Hooke hooke(fem_mesh.nt);
  for (Index t = 0; t < Gs.size(); ++t) hooke[t] = isotropic(lambdas[t], Gs[t]);
  return hooke;
}

/// From [C11, C12, C13, C22, C23, C33].
Hooke general_of(Stack stack, const NamedArguments& named,
                 const std::string& name, const Fem2D::Mesh& fem_mesh) {
  constexpr int row[] = {0, 0, 0, 1, 1, 2}, column[] = {0, 1, 2, 1, 2, 2};
  Hooke hooke(fem_mesh.nt);
  for (int c = 0; c < 6; ++c) {
    const VectorXd values =
        at_triangles(stack, named.component(name, c, 6), fem_mesh, 0);
    for (Index t = 0; t < values.size(); ++t)
      hooke[t](row[c], column[c]) = hooke[t](column[c], row[c]) = values[t];
  }
  return hooke;
}

Hooke hooke_of(Stack stack, const NamedArguments& named,
               const PlaneBodies& bodies, int body) {
  const auto name_of = [&](const char* name) {
    return name_of_body(name, body, bodies.body_count());
  };
  const std::string general = name_of("hooke");
  const Expression lambda = named.expression(name_of("lambda")),
                   G = named.expression(name_of("G"));
  const bool lame = lambda && G;
  if (lame == named.given(general))
    refuse("give either ", name_of("lambda"), "= and ", name_of("G"),
           "= (Lame's constants) or ", general,
           "=[C11, C12, C13, C22, C23, C33]");
  const Fem2D::Mesh& fem_mesh = *bodies.fem_meshes[body];
  return lame ? isotropic_of(stack, lambda, G, fem_mesh)
              : general_of(stack, named, general, fem_mesh);
}

/// The components of a load, null where it is not given.
struct Load {
  Expression x, y;
};

Load load_of(const NamedArguments& named, const char* name, int body,
             int bodies) {
  const std::string own = name_of_body(name, body, bodies);
  return {named.component(own, 0, 2), named.component(own, 1, 2)};
}

/// Reads one body into what is there for all of them.
Oscillation read_body(Stack stack, const NamedArguments& named,
                      const PlaneBodies& bodies, int k, SolvedBody<2>& body,
                      InitialStresses<2>& initial, Springs<2>& springs) {
  const JoinedMesh& joined = bodies.joined;
  const int count = bodies.body_count();
  const Fem2D::Mesh& fem_mesh = *bodies.fem_meshes[k];
  const Hooke hooke = hooke_of(stack, named, bodies, k);
  body.hooke.insert(body.hooke.end(), hooke.begin(), hooke.end());
  const Load F = load_of(named, "traction", k, count),
             f = load_of(named, "bodyforce", k, count);
  const Mesh mesh = mesh_of(&fem_mesh);
  body.neumann.middleCols(joined.first_boundary[k], mesh.boundary.cols()) =
      traction_moments(stack, F.x, F.y, fem_mesh, mesh);
  const BodyForce force = body_force_loads(stack, f.x, f.y, fem_mesh, mesh);
  body.body_loads.middleCols(joined.first_cell[k], mesh.cells.cols()) =
      force.loads;
  springs.read(named, k, count, joined.first_boundary[k],
               [&](Expression expression) {
                 return at_gauss_points(stack, expression, fem_mesh, mesh);
               });
  return {force.oscillation, initial.read(stack, named, k, hooke, fem_mesh)};
}

}  // namespace

Oscillation read_material_and_loads(Stack stack, const NamedArguments& named,
                                    const PlaneBodies& bodies,
                                    SolvedBody<2>& body) {
  body.neumann.resize(4, bodies.joined.first_boundary.back());
  body.body_loads.resize(6, bodies.joined.first_cell.back());
  Oscillation all;
  InitialStresses<2> initial(bodies.joined.first_cell);
  Springs<2> springs(bodies.joined.first_boundary.back());
  for (int k = 0; k < bodies.body_count(); ++k) {
    all.add(read_body(stack, named, bodies, k, body, initial, springs));
  }
  body.initial = initial.joined();
  body.springs = std::move(springs.joined);
  return all;
}

}  // namespace ffcontact::plugin
