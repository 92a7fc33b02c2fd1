// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/goal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/linear/norms.hpp"
//
#include "estimate/initial_stress.hpp"
#include "freefem/plane_values.hpp"

namespace ffcontact::plugin {

namespace {

/// Beside the largest value: more is not rounding.
constexpr double linear_to = 1e-9;

std::string place_of_edge(const Mesh& mesh, Index edge) {
  const Vector2d middle = (mesh.vertices.col(mesh.boundary(0, edge)) +
                           mesh.vertices.col(mesh.boundary(1, edge))) /
                          2;
  return in_words(middle);
}

/// The middle one of three Gauss points has the mean of the others.
void require_linear(const Mesh& mesh, const MatrixXd& at_points) {
  const Eigen::RowVectorXd bend =
      at_points.row(0) - 2 * at_points.row(1) + at_points.row(2);
  Index worst = 0;
  if (bend.size() > 0 &&
      bend.cwiseAbs().maxCoeff(&worst) > linear_to * max_norm(at_points))
    refuse("goaltraction= is not linear on the edge at ",
           place_of_edge(mesh, worst),
           ": let the mesh have a vertex where it jumps or bends");
}

/// The components of a vector, null where it is not given.
std::array<Expression, 2> vector_of(const NamedArguments& named,
                                    const char* name, int body, int bodies) {
  const std::string own = name_of_body(name, body, bodies);
  return {named.component(own, 0, 2), named.component(own, 1, 2)};
}

Matrix4Xd tractions_of(Stack stack, const std::array<Expression, 2>& w,
                       const Fem2D::Mesh& fem_mesh, const Mesh& mesh) {
  for (Expression component : w)
    require_linear(mesh, at_gauss_points(stack, component, fem_mesh, mesh));
  return traction_moments(stack, w[0], w[1], fem_mesh, mesh);
}

BodyLoadsOfCells<2> body_loads_of(Stack stack,
                                  const std::array<Expression, 2>& p,
                                  const Fem2D::Mesh& fem_mesh,
                                  const Mesh& mesh) {
  BodyForce force = body_force_loads(stack, p[0], p[1], fem_mesh, mesh);
  if (force.oscillation > linear_to * force.loads.cwiseAbs().sum())
    refuse(
        "goalbodyforce= varies within triangles: give it as a constant of "
        "each, "
        "and let the mesh have edges where it jumps");
  return std::move(force.loads);
}

/// (sum over cells of int q : C^-1 q)^(1/2) of its means, or so.
double size_of(const InitialStress<2>& stress, const Hooke& hooke,
               const Mesh& mesh) {
  const CellStresses<2> mean =
      LinearStresses<2>::of_values(stress.at_vertices).mean;
  double sum = 0;
  for (int t = 0; t < mesh.cell_count(); ++t)
    sum += signed_area(mesh, t) *
           mean.col(t).dot(hooke[t].inverse() * mean.col(t));
  return std::sqrt(sum);
}

}  // namespace

Quantity<2> read_goal(Stack stack, const NamedArguments& named,
                      const PlaneBodies& bodies, const Hooke& hooke) {
  const JoinedMesh& joined = bodies.joined;
  const int count = bodies.body_count();
  Quantity<2> goal{BodyLoadsOfCells<2>(6, joined.first_cell.back()),
                   {},
                   Matrix4Xd(4, joined.first_boundary.back()),
                   named.number(stack, "goalconstant", 0)};
  LinearStresses<2>::Values q = LinearStresses<2>::Values::Zero(
      LinearStresses<2>::Values::RowsAtCompileTime, joined.first_cell.back());
  for (int k = 0; k < count; ++k) {
    const Fem2D::Mesh& fem_mesh = *bodies.fem_meshes[k];
    const Mesh mesh = mesh_of(&fem_mesh);
    const int first = joined.first_cell[k], cells = mesh.cell_count();
    goal.tractions.middleCols(joined.first_boundary[k], mesh.boundary.cols()) =
        tractions_of(stack, vector_of(named, "goaltraction", k, count),
                     fem_mesh, mesh);
    goal.body_loads.middleCols(first, cells) = body_loads_of(
        stack, vector_of(named, "goalbodyforce", k, count), fem_mesh, mesh);
    VoigtExpression<2> stress;
    for (int c = 0; c < 3; ++c)
      stress[c] = named.component(name_of_body("goalstress", k, count), c, 3);
    if (!stress[0]) continue;
    const Hooke own(hooke.begin() + first, hooke.begin() + first + cells);
    const InitialStress<2> read =
        initial_stress_of(stack, VoigtExpression<2>{}, stress, own, fem_mesh);
    if (read.oscillation > linear_to * size_of(read, own, mesh))
      refuse(
          "goalstress= is not linear in each triangle: let the mesh have edges "
          "where it jumps, or choose triangles by region");
    q.middleCols(first, cells) = read.at_vertices;
  }
  if (!q.isZero(0)) goal.stress = LinearStresses<2>::of_values(q);
  return goal;
}

void require_goal(const PlaneBodies& bodies, const Quantity<2>& goal,
                  const VectorXd& given) {
  const Mesh& mesh = bodies.joined.mesh;
  const VectorXd load = load_of(mesh, goal);
  require_size("q", given.size(), load.size());
  constexpr double same = 1e-10;
  Index worst;
  if ((given - load).cwiseAbs().maxCoeff(&worst) <= same * max_norm(given))
    return;
  const auto vertex = static_cast<int>(worst) / 2;
  refuse(
      "q is ", given[worst], " at vertex ", vertex, " ",
      in_words(mesh.place(vertex)), ", but goaltraction=, goalbodyforce= and ",
      "goalstress= make ", load[worst],
      " of it: they are the integrands of q, on the same edges and triangles");
}

}  // namespace ffcontact::plugin
