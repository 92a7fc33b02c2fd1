// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/nodal_pressures.hpp"

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/law/held_rows.hpp"
#include "ffcontact/interface/line_ends.hpp"
#include "ffcontact/linear/sparse_lu.hpp"

namespace ffcontact {

namespace {

/// The other node of an edge at each node [p].
VectorXi neighbours(const ContactLine& line) {
  VectorXi neighbour(line.node_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    if (is_constant_on(line, e)) continue;
    const Vector2i nodes = line.edge_node.col(e);
    neighbour(nodes) = nodes.reverse();
  }
  return neighbour;
}

/// The row whose equation gives the value of each row: its own, that it is continued
/// from, or -1 for a value of 0 [2 p].
std::vector<int> sources(const ContactLine& line, const Flags& prescribed) {
  const Flags held = held_rows(line, prescribed);
  const std::vector<int> continued = continued_rows(line, prescribed);
  std::vector<int> source(held.size());
  for (int row = 0; row < count_of(source); ++row) {
    const int next = continued[row];
    source[row] = !held[row] ? row : next >= 0 && !held[next] ? next : -1;
  }
  return source;
}

/// The values of the rows that they are continued from, 0 where there is none [2 x p].
Matrix2Xd continued(const VectorXd& values, const std::vector<int>& source) {
  VectorXd result(values.size());
  for (int row = 0; row < values.size(); ++row)
    result[row] = source[row] < 0 ? 0 : values[source[row]];
  return result.reshaped(2, values.size() / 2);
}

/// The mass matrix of continued values on the rows that have an equation, 1 on the
/// others.
SparseMatrix continued_mass(const SparseMatrix& mass,
                            const std::vector<int>& source) {
  Triplets entries;
  for (int j = 0; j < mass.outerSize(); ++j)
    for (SparseMatrix::InnerIterator m(mass, j); m; ++m)
      if (source[j] >= 0 && source[m.row()] == m.row())
        entries.emplace_back(static_cast<int>(m.row()), source[j], m.value());
  for (int row = 0; row < mass.rows(); ++row)
    if (source[row] != row) entries.emplace_back(row, row, 1.0);
  return packed(mass.rows(), mass.cols(), entries);
}

}  // namespace

VectorXd nodal_lengths(const ContactLine& line) {
  VectorXd lengths = VectorXd::Zero(line.node_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int node : line.edge_node.col(e)) lengths[node] += line.length[e] / 2;
  return lengths;
}

Matrix2Xd lumped_pressures(const ContactLine& line,
                           const Ref<const Matrix2Xd>& force) {
  return force * nodal_lengths(line).cwiseInverse().asDiagonal();
}

Matrix2Xd lumped_forces(const ContactLine& line,
                        const Ref<const Matrix2Xd>& pressure) {
  return pressure * nodal_lengths(line).asDiagonal();
}

Matrix2Xd forces_of(const ContactLine& line,
                    const Ref<const Matrix2Xd>& density) {
  return (weight_of_rows(Multiplier::pressure, line) * density.reshaped())
      .reshaped(2, line.node_count());
}

Matrix2Xd consistent_pressures(const ContactLine& line, const Flags& prescribed,
                               const Ref<const Matrix2Xd>& force) {
  const std::vector<int> source = sources(line, prescribed);
  const SparseMatrix mass = weight_of_rows(Multiplier::pressure, line);
  VectorXd right = force.reshaped();
  for (int row = 0; row < right.size(); ++row)
    if (source[row] != row) right[row] = 0;
  const VectorXd pressure = SparseLu(continued_mass(mass, source)).solve(right);
  return continued(pressure, source);
}

Matrix2Xd lumped_pressures(const ContactLine& line, const Flags& prescribed,
                           const Ref<const Matrix2Xd>& force) {
  const std::vector<int> source = sources(line, prescribed);
  return continued(lumped_pressures(line, force).reshaped(), source);
}

Matrix2Xd multiplier_density(const ContactLine& line, Multiplier multiplier,
                             const Flags& prescribed,
                             const Ref<const Matrix2Xd>& pressure) {
  if (multiplier == Multiplier::pressure) return pressure;
  return consistent_pressures(line, prescribed, lumped_forces(line, pressure));
}

std::vector<int> continued_rows(const ContactLine& line,
                                const Flags& prescribed) {
  const VectorXi neighbour = neighbours(line);
  std::vector<int> continued(2 * line.node_count());
  for (int row = 0; row < 2 * line.node_count(); ++row) {
    const int v = line.vertex[row / 2];
    const bool clamped = prescribed[2 * v] && prescribed[2 * v + 1],
               held = prescribed[2 * v] || prescribed[2 * v + 1];
    continued[row] = clamped || (held && row % 2 == 0)
                         ? 2 * neighbour[row / 2] + row % 2
                         : -1;
  }
  return continued;
}

}  // namespace ffcontact
