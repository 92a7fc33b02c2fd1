// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/held_rows.hpp"

#include <cmath>

#include "ffcontact/base/flags.hpp"

namespace ffcontact {

namespace {

/// Vertices of the opposite trace that weigh less do not count.
constexpr double faced = 1e-3;
/// Free directions that a row has less of do not move it.
constexpr double moved = 1e-6;

/// The weight of the vertices that do not count at a node.
double uncounted(const ContactLine& line, int node) {
  double sum = 0;
  visit_opposite(line, node, [&](int, double weight) {
    if (std::abs(weight) < faced) sum += std::abs(weight);
  });
  return sum;
}

/// Does a free dof of a vertex move a node that it has this weight at?
bool moves_along(const Vector2d& direction, int vertex, double weight,
                 const Flags& prescribed) {
  if (std::abs(weight) < faced) return false;
  for (int k = 0; k < 2; ++k)
    if (!prescribed[2 * vertex + k] && std::abs(weight * direction[k]) > moved)
      return true;
  return false;
}

}  // namespace

Flags held_rows(const ContactLine& line, const Flags& prescribed) {
  Flags held(2 * line.node_count(), 1);
  for (int i = 0; i < line.node_count(); ++i) {
    const Matrix2d frame = line.frame(i);
    const auto moves_with = [&](int vertex, double weight) {
      for (int c = 0; c < 2; ++c)
        if (moves_along(frame.col(c), vertex, weight, prescribed))
          held[2 * i + c] = 0;
    };
    moves_with(line.vertex[i], 1);
    visit_opposite(line, i, moves_with);
  }
  return held;
}

HeldRows<2> held_rows(const ContactLine& line, const ContactLaw<2>& law,
                      const ElasticSystem& system) {
  const VectorXd& given = system.prescribed_value;
  HeldRows<2> held{held_rows(line, system.prescribed),
                   displacement_against_foundation(line, law, given)};
  const double largest = largest_displacement(law, given);
  for (int i = 0; i < line.node_count(); ++i) {
    const double none = (moved + uncounted(line, i)) * largest;
    for (double& v : held.v.col(i))
      if (std::abs(v) <= none) v = 0;
  }
  return held;
}

}  // namespace ffcontact
