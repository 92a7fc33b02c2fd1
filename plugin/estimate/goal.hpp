// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/bounds/quantity.hpp"
#include "ffcontact/linear/norms.hpp"
//
#include "estimate/goal_force.hpp"
#include "estimate/linear_tractions.hpp"
#include "estimate/material_and_loads.hpp"

namespace ffcontact::plugin {

/// In the words of messages.
template <int d>
constexpr const char* facets = d == 2 ? "edges" : "faces";

/// @throws std::invalid_argument  if w is off the linear function through its values near the
///                                vertices of a boundary element by more than rounding
template <int d>
void require_linear(Stack stack, const std::string& name, Expression w,
                    const BodyPart<d>& part) {
  const Bends bends = bends_of<d>(stack, w, part);
  Index worst = 0;
  if (bends.off.size() == 0 ||
      bends.off.maxCoeff(&worst) <= linear_to * bends.largest)
    return;
  const auto vertices = part.mesh.boundary.col(part.first_boundary + worst);
  refuse(name, "= is not linear on the ", MeshWords<d>::facet, " at ",
         in_words(facet_points<d>(part.mesh, vertices).rowwise().mean()),
         ": let the mesh have ", d == 2 ? "a vertex" : "edges",
         " where it jumps or bends");
}

/// @throws std::invalid_argument  if traction= of a body is not linear on a boundary
///                                element: stresses are not in equilibrium with it then
template <int d>
void require_linear(Stack stack, const NamedArguments& named,
                    const Bodies<d>& bodies, const char* parameter) {
  for (int k = 0; k < bodies.body_count(); ++k) {
    const BodyReader<d> reader(stack, named, bodies, k);
    for (Expression w : reader.list(parameter))
      if (w) require_linear<d>(stack, reader.name(parameter), w, reader.part());
  }
}

/// The norm of the means of stresses of one body.
template <int d>
double size_of(const InitialStress<d>& stress, const HookeTensors<d>& hooke,
               const BodyPart<d>& part) {
  const CellStresses<d> mean =
      LinearStresses<d>::of_values(stress.at_vertices).mean;
  double sum = 0;
  for (int t = 0; t < mean.cols(); ++t)
    sum += signed_volume(part.mesh, part.first_cell + t) *
           mean.col(t).dot(hooke[t].inverse() * mean.col(t));
  return std::sqrt(sum);
}

/// goalstress= of one body at the vertices of its cells.
template <int d>
typename LinearStresses<d>::Values goal_stress(Stack stack,
                                               const BodyReader<d>& reader,
                                               const HookeTensors<d>& hooke) {
  const InitialStress<d> read = initial_stress_of<d>(
      stack, VoigtExpression<d>{},
      reader.template list<voigt_size<d>>("goalstress"), hooke, reader.part());
  if (read.oscillation > linear_to * size_of<d>(read, hooke, reader.part()))
    refuse("goalstress= is not linear in each ", MeshWords<d>::cell,
           ": let the mesh have ", facets<d>, " where it jumps, or choose ",
           MeshWords<d>::cells, " by region");
  return read.at_vertices;
}

template <int d>
BodyLoadsOfCells<d> goal_body_loads(const BodyReader<d>& reader) {
  BodyForce<d> force = reader.force("goalbodyforce");
  if (vary_in_cells(force.oscillation, force.loads))
    refuse("goalbodyforce= varies within ", MeshWords<d>::cells,
           ": give it as a constant of each, and let the mesh have ", facets<d>,
           " where it jumps");
  return std::move(force.loads);
}

/// Reads the quantity of interest l of all bodies: goaltraction= w, goalbodyforce= p,
/// goalstress= q, goalconstant= and goalforce=, whose l is added.
/// @param solved  with the elastic law and the loads
/// @throws std::invalid_argument  if w is not linear on a boundary element, p not constant or
///                                q not linear in a cell, or as ForceWeight
template <int d>
Quantity<d> read_goal(Stack stack, const NamedArguments& named,
                      const Bodies<d>& bodies, const SolvedProblem<d>& solved) {
  const auto& joined = bodies.joined;
  ForceWeight<d> weight(solved);
  require_linear<d>(stack, named, bodies, "goaltraction");
  Quantity<d> goal;
  goal.body_loads.resize(d * (d + 1), joined.first_cell.back());
  goal.tractions.resize(d * d, joined.first_boundary.back());
  goal.constant = named.number(stack, "goalconstant", 0);
  typename LinearStresses<d>::Values stress;
  stress.setZero(Eigen::NoChange, joined.first_cell.back());
  for (int k = 0; k < bodies.body_count(); ++k) {
    const BodyReader<d> reader(stack, named, bodies, k);
    const FacetColumns<d> tractions = reader.tractions("goaltraction");
    goal.tractions.middleCols(joined.first_boundary[k], tractions.cols()) =
        tractions;
    const BodyLoadsOfCells<d> loads = goal_body_loads<d>(reader);
    weight.read(stack, reader);
    const int first = joined.first_cell[k];
    goal.body_loads.middleCols(first, loads.cols()) = loads;
    if (!named.given(reader.name("goalstress"))) continue;
    const auto own = solved.body.hooke.begin() + first;
    stress.middleCols(first, loads.cols()) =
        goal_stress<d>(stack, reader, {own, own + loads.cols()});
  }
  if (stress.isZero(0) && goal.body_loads.isZero(0) &&
      goal.tractions.isZero(0) && !named.given_of_bodies("goalforce"))
    refuse(
        "goaltraction=, goalbodyforce= and goalstress= are 0 everywhere: mind "
        "that (label == 4)/40 divides integers, and (label == 4)/40. does not");
  if (!stress.isZero(0)) goal.stress = LinearStresses<d>::of_values(stress);
  weight.add_to(goal);
  return goal;
}

/// @param given  l of the hat functions as the script has assembled it [dofs]
/// @throws std::invalid_argument  naming the vertex where it is not that of the quantity
template <int d>
void require_goal(const SimplexMesh<d>& mesh, const Quantity<d>& goal,
                  const VectorXd& given) {
  const VectorXd load = load_of(mesh, goal);
  require_size("q", given.size(), load.size());
  constexpr double same = 1e-10;
  Index worst;
  if ((given - load).cwiseAbs().maxCoeff(&worst) <= same * max_norm(given))
    return;
  refuse("q is ", given[worst], " at the vertex ",
         in_words(mesh.place(static_cast<int>(worst) / d)),
         ", but goaltraction=, goalbodyforce= and goalstress= make ",
         load[worst], " of it: they are the integrands of q, on the same ",
         facets<d>, " and ", MeshWords<d>::cells);
}

}  // namespace ffcontact::plugin
