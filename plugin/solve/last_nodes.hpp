// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/contact/condensed/contact_rows.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
//
#include "problem/contact_type.hpp"
#include "solve/load_step.hpp"

/// What a solution leaves to the next one, of another mesh, too.
namespace ffcontact::plugin {

inline VectorXd sizes_of_nodes(const ContactLine& line) {
  return nodal_lengths(line);
}
inline VectorXd sizes_of_nodes(const ContactSurface& surface) {
  return surface.area.cwiseSqrt();
}

template <int d>
PlacedNodes placed_nodes(const ContactProblem<d>& problem) {
  return {problem.places(), problem.own_normals(),
          sizes_of_nodes(problem.contact)};
}

/// Vectors along x, y (z) on the body that comes first, of components along n, t at the nodes
/// [d x p].
template <int d>
Matrix<double, d, Dynamic> own_vectors(
    const ContactProblem<d>& problem,
    const Ref<const Matrix<double, d, Dynamic>>& components) {
  const VectorXd sign = problem.own_signs();
  Matrix<double, d, Dynamic> vectors(d, components.cols());
  for (Index i = 0; i < components.cols(); ++i)
    vectors.col(i) = sign[i] * (problem.contact.frame(static_cast<int>(i)) *
                                components.col(i));
  return vectors;
}

/// (u_n - gap, u_t - previous) of the tractions that a layer carries [d x p].
template <int d>
Matrix<double, d, Dynamic> displaced(const ContactProblem<d>& problem,
                                     const SolvedContact<d>& solved) {
  const ContactSolution<d>& found = solved.solution;
  const Matrix<double, d, Dynamic> pressure =
      lumped_pressures(problem.contact, found.force);
  return displacement_against_foundation<d>(
      problem.contact, on_layer<d>(solved.law, pressure), found.displacement);
}

/// @param moved  displaced()
template <int d>
LastNodes last_nodes(const ContactProblem<d>& problem,
                     const SolvedContact<d>& solved,
                     const Matrix<double, d, Dynamic>& moved,
                     double tolerance) {
  const Matrix<double, d, Dynamic> pressure =
      lumped_pressures(problem.contact, solved.solution.force);
  return {states_for_next(problem, solved, tolerance), placed_nodes(problem),
          own_vectors<d>(problem, pressure), own_vectors<d>(problem, moved)};
}

/// The last nodes as a guess at those of a problem.
struct Guess {
  ContactStates state;
  std::optional<ContactRows> rows;  ///< P and v
};

template <int d>
Guess guess_at(const ContactProblem<d>& problem, const LastNodes& last) {
  Guess guess;
  if (last.state.empty()) return guess;
  const LineOrSurface<d>& where = problem.contact;
  const PlacedNodes nodes = placed_nodes(problem);
  const std::vector<int> nearest = nearest_nodes(nodes, last.at);
  const VectorXd sign = problem.own_signs();
  Matrix<double, d, Dynamic> P(d, where.node_count()), v(d, where.node_count());
  for (int i = 0; i < where.node_count(); ++i) {
    const Matrix<double, d, d> to_components =
        sign[i] * where.frame(i).transpose();
    guess.state.push_back(last.state[nearest[i]]);
    P.col(i) = std::pow(nodes.size[i], d - 1) * to_components *
               last.pressure.col(nearest[i]);
    v.col(i) = to_components * last.moved.col(nearest[i]);
  }
  guess.rows = {P.reshaped(), v.reshaped()};
  return guess;
}

}  // namespace ffcontact::plugin
