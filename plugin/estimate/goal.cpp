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

/// Values on the edges are off the line through those at the ends by no more than rounding,
/// at places that no odd or even function passes.
void require_linear(Stack stack, const std::string& name, Expression w,
                    const Fem2D::Mesh& fem_mesh, const Mesh& mesh) {
  const std::vector<double> places = {1e-3, 0.113, 0.31,    0.5,
                                      0.74, 0.887, 1 - 1e-3};
  const MatrixXd values = along_boundary(stack, w, fem_mesh, mesh, places);
  const Map<const Eigen::ArrayXd> s(places.data(), values.rows());
  const VectorXd share =
      (s - places.front()) / (places.back() - places.front());
  const MatrixXd line = values.topRows(1).replicate(values.rows(), 1) +
                        share * (values.bottomRows(1) - values.topRows(1));
  Index point = 0, worst = 0;
  if (values.cols() > 0 && (values - line).cwiseAbs().maxCoeff(&point, &worst) >
                               linear_to * max_norm(values))
    refuse(
        name, "= is not linear on the edge at ",
        in_words(
            facet_points<2>(mesh, mesh.boundary.col(worst)).rowwise().mean()),
        ": let the mesh have a vertex where it jumps or bends");
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

/// The norm of its means.
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

/// Body after body.
class GoalReader {
 public:
  GoalReader(Stack stack, const NamedArguments& named,
             const PlaneBodies& bodies)
      : stack_(stack), named_(named), bodies_(bodies) {
    goal_.body_loads.resize(6, first_cell().back());
    goal_.tractions.resize(4, bodies.joined.first_boundary.back());
    goal_.constant = named.number(stack, "goalconstant", 0);
    stress_.setZero(Eigen::NoChange, first_cell().back());
  }

  void read(int body, const Hooke& hooke) {
    const Fem2D::Mesh& fem_mesh = *bodies_.fem_meshes[body];
    const Mesh mesh = mesh_of(&fem_mesh);
    require_linear("goaltraction", body);
    const std::array<Expression, 2> w = vector_of("goaltraction", body);
    goal_.tractions.middleCols(bodies_.joined.first_boundary[body],
                               mesh.boundary.cols()) =
        traction_moments(stack_, w[0], w[1], fem_mesh, mesh);
    goal_.body_loads.middleCols(first_cell()[body], mesh.cells.cols()) =
        body_loads_of(stack_, vector_of("goalbodyforce", body), fem_mesh, mesh);
    read_stress(body, hooke, fem_mesh, mesh);
  }

  void require_linear(const char* name, int body) const {
    const Fem2D::Mesh& fem_mesh = *bodies_.fem_meshes[body];
    const Mesh mesh = mesh_of(&fem_mesh);
    const std::string own = name_of_body(name, body, bodies_.body_count());
    for (Expression w : vector_of(name, body))
      if (w) plugin::require_linear(stack_, own, w, fem_mesh, mesh);
  }

  Quantity<2> goal() && {
    if (!stress_.isZero(0))
      goal_.stress = LinearStresses<2>::of_values(stress_);
    return std::move(goal_);
  }

 private:
  const std::vector<int>& first_cell() const {
    return bodies_.joined.first_cell;
  }

  /// A component of a list, null where it is not given.
  Expression component(const char* name, int body, int k, int size) const {
    return named_.component(name_of_body(name, body, bodies_.body_count()), k,
                            size);
  }
  std::array<Expression, 2> vector_of(const char* name, int body) const {
    return {component(name, body, 0, 2), component(name, body, 1, 2)};
  }

  void read_stress(int body, const Hooke& hooke, const Fem2D::Mesh& fem_mesh,
                   const Mesh& mesh) {
    VoigtExpression<2> q;
    for (int c = 0; c < 3; ++c) q[c] = component("goalstress", body, c, 3);
    if (!q[0]) return;
    const auto begin = hooke.begin() + first_cell()[body];
    const Hooke own(begin, begin + mesh.cell_count());
    const InitialStress<2> read =
        initial_stress_of(stack_, VoigtExpression<2>{}, q, own, fem_mesh);
    if (read.oscillation > linear_to * size_of(read, own, mesh))
      refuse(
          "goalstress= is not linear in each triangle: let the mesh have edges "
          "where it jumps, or choose triangles by region");
    stress_.middleCols(first_cell()[body], mesh.cells.cols()) =
        read.at_vertices;
  }

  Stack stack_;
  const NamedArguments& named_;
  const PlaneBodies& bodies_;
  Quantity<2> goal_;
  LinearStresses<2>::Values stress_;
};

}  // namespace

Quantity<2> read_goal(Stack stack, const NamedArguments& named,
                      const PlaneBodies& bodies, const Hooke& hooke) {
  GoalReader reader(stack, named, bodies);
  for (int k = 0; k < bodies.body_count(); ++k) reader.read(k, hooke);
  return std::move(reader).goal();
}

void require_linear_tractions(Stack stack, const NamedArguments& named,
                              const PlaneBodies& bodies) {
  const GoalReader reader(stack, named, bodies);
  for (int k = 0; k < bodies.body_count(); ++k)
    reader.require_linear("traction", k);
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
      "q is ", given[worst], " at the vertex ", in_words(mesh.place(vertex)),
      ", but goaltraction=, goalbodyforce= and goalstress= make ", load[worst],
      " of it: they are the integrands of q, on the same edges and triangles");
}

}  // namespace ffcontact::plugin
