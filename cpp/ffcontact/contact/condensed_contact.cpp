// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed_contact.hpp"

#include <Eigen/LU>
#include <map>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// A free direction of a contact vertex is taken as tangential when its normal component is below this.
constexpr double tangential = 1e-3;

/// How a vertex moves: displacement = directions w for its free components w (first column of `directions` at `column`).
struct VertexMotion {
  int first_node = 0;
  int column = 0;
  std::vector<int> rows;  ///< primary row of each free component
  Eigen::Matrix<double, 2, Eigen::Dynamic> directions;
};

VertexMotion vertex_motion(const ContactLine& line, int node, const std::vector<char>& prescribed) {
  const int v = line.vertex[node];
  const Eigen::Vector2d n = line.normal.col(node), t = line.tangent(node);
  VertexMotion motion;
  motion.first_node = node;
  if (!prescribed[2 * v] && !prescribed[2 * v + 1]) {
    motion.rows = {2 * node, 2 * node + 1};
    motion.directions.resize(2, 2);
    motion.directions << n, t;
  } else if (!prescribed[2 * v] || !prescribed[2 * v + 1]) {
    const Eigen::Vector2d d = prescribed[2 * v] ? Eigen::Vector2d::UnitY() : Eigen::Vector2d::UnitX();
    const bool along_tangent = std::abs(n.dot(d)) < tangential;
    motion.rows = {2 * node + (along_tangent ? 1 : 0)};
    motion.directions = d / (along_tangent ? t.dot(d) : n.dot(d));
  } else {
    motion.directions.resize(2, 0);
  }
  return motion;
}

/// Fills primary, dependent and position; the first node of a vertex carries its primary rows.
std::map<int, VertexMotion> number_rows(const ContactLine& line, const std::vector<char>& prescribed,
                                        CondensedContact& contact) {
  std::map<int, VertexMotion> motions;
  contact.position = Eigen::VectorXi::Zero(2 * line.node_count());
  std::vector<char> primary(2 * line.node_count(), 0);
  for (int i = 0; i < line.node_count(); ++i) {
    if (motions.count(line.vertex[i])) continue;
    VertexMotion motion = vertex_motion(line, i, prescribed);
    motion.column = static_cast<int>(contact.primary.size());
    for (int row : motion.rows) {
      primary[row] = 1;
      contact.primary.push_back(row);
    }
    motions.emplace(line.vertex[i], std::move(motion));
  }
  for (std::size_t k = 0; k < contact.primary.size(); ++k) contact.position[contact.primary[k]] = static_cast<int>(k);
  for (int row = 0; row < 2 * line.node_count(); ++row)
    if (!primary[row]) {
      contact.position[row] = -1 - static_cast<int>(contact.dependent.size());
      contact.dependent.push_back(row);
    }
  return motions;
}

/// The other node of an edge at each node [p].
Eigen::VectorXi neighbours(const ContactLine& line) {
  Eigen::VectorXi neighbour(line.node_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) neighbour[line.edge_node(end, e)] = line.edge_node(1 - end, e);
  return neighbour;
}

/// CondensedContact::continued.
std::vector<int> continued_rows(const ContactLine& line, const std::vector<char>& prescribed,
                                const std::vector<int>& dependent) {
  const Eigen::VectorXi neighbour = neighbours(line);
  std::vector<int> continued;
  for (int row : dependent) {
    const int v = line.vertex[row / 2];
    const bool clamped = prescribed[2 * v] && prescribed[2 * v + 1], held = prescribed[2 * v] || prescribed[2 * v + 1];
    continued.push_back(clamped || (held && row % 2 == 0) ? 2 * neighbour[row / 2] + row % 2 : -1);
  }
  return continued;
}

/// Trace operator of all rows, u_rows = T w.
Eigen::SparseMatrix<double> trace_operator(const ContactLine& line, const std::map<int, VertexMotion>& motions,
                                           Eigen::Index unknowns) {
  Triplets entries;
  for (int i = 0; i < line.node_count(); ++i) {
    const VertexMotion& motion = motions.at(line.vertex[i]);
    for (Eigen::Index k = 0; k < motion.directions.cols(); ++k) {
      entries.emplace_back(2 * i, motion.column + k, line.normal.col(i).dot(motion.directions.col(k)));
      entries.emplace_back(2 * i + 1, motion.column + k, line.tangent(i).dot(motion.directions.col(k)));
    }
  }
  Eigen::SparseMatrix<double> T(2 * line.node_count(), unknowns);
  T.setFromTriplets(entries.begin(), entries.end());
  return T;
}

Eigen::SparseMatrix<double> selected_rows(const Eigen::SparseMatrix<double>& A, const std::vector<int>& rows) {
  Triplets entries;
  for (std::size_t k = 0; k < rows.size(); ++k) entries.emplace_back(static_cast<int>(k), rows[k], 1.0);
  Eigen::SparseMatrix<double> selection(static_cast<Eigen::Index>(rows.size()), A.rows());
  selection.setFromTriplets(entries.begin(), entries.end());
  return selection * A;
}

Eigen::VectorXd selected(const Eigen::VectorXd& values, const std::vector<int>& rows) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) result[k] = values[rows[k]];
  return result;
}

/// Displacement of the kept dofs in terms of w.
Eigen::SparseMatrix<double> kept_operator(const std::map<int, VertexMotion>& motions, const std::vector<int>& kept,
                                          Eigen::Index unknowns) {
  Triplets entries;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const VertexMotion& motion = motions.at(kept[k] / 2);
    for (Eigen::Index j = 0; j < motion.directions.cols(); ++j)
      entries.emplace_back(static_cast<int>(k), motion.column + j, motion.directions(kept[k] % 2, j));
  }
  Eigen::SparseMatrix<double> Q(static_cast<Eigen::Index>(kept.size()), unknowns);
  Q.setFromTriplets(entries.begin(), entries.end());
  return Q;
}

using Factor = Eigen::SparseLU<Eigen::SparseMatrix<double>>;

void factorise_primary(const CondensedContact& contact, Factor& factor) {
  Eigen::SparseMatrix<double> A_primary = selected_rows(contact.A, contact.primary);
  A_primary.makeCompressed();
  factor.compute(A_primary);
  if (factor.info() != Eigen::Success)
    refuse(
        "the contact multipliers are not independent: the contact line turns too sharply between prescribed vertices");
}

}  // namespace

std::vector<int> contact_dofs(const ContactLine& line, const ElasticSystem& system) {
  std::vector<int> dofs;
  std::vector<char> seen(system.prescribed.size(), 0);
  for (int i = 0; i < line.node_count(); ++i)
    for (int dof = 2 * line.vertex[i]; dof < 2 * line.vertex[i] + 2; ++dof)
      if (!system.prescribed[dof] && !seen[dof]) {
        seen[dof] = 1;
        dofs.push_back(dof);
      }
  return dofs;
}

CondensedContact condensed_contact(const ContactLine& line, const ContactLaw& law, const ElasticSystem& system,
                                   const CondensedStiffness& stiffness) {
  CondensedContact contact;
  contact.kept_dofs = contact_dofs(line, system);
  if (contact.kept_dofs.empty()) refuse("every dof of the contact line is prescribed");
  const std::map<int, VertexMotion> motions = number_rows(line, system.prescribed, contact);
  contact.continued = continued_rows(line, system.prescribed, contact.dependent);
  const auto f = static_cast<Eigen::Index>(contact.primary.size());

  const Eigen::SparseMatrix<double> W = weight_of_rows(law.multiplier, line);
  contact.A = W * trace_operator(line, motions, f);
  contact.v_prescribed = W * displacement_against_foundation(line, law, system.prescribed_value).reshaped();
  contact.to_kept = kept_operator(motions, contact.kept_dofs, f);

  Factor factor;
  factorise_primary(contact, factor);
  const Eigen::SparseMatrix<double> Qt = contact.to_kept.transpose();
  const Eigen::MatrixXd S_w = Qt * stiffness.schur() * contact.to_kept;
  const Eigen::VectorXd g_w = Qt * stiffness.condensed_load(system.load);
  const Eigen::VectorXd w_prescribed = factor.solve(selected(contact.v_prescribed, contact.primary));
  const Eigen::MatrixXd half = factor.transpose().solve(S_w);  // A^-T S_w
  const Eigen::MatrixXd half_transposed = half.transpose();
  contact.S = factor.transpose().solve(half_transposed);
  contact.S = (0.5 * (contact.S + contact.S.transpose())).eval();
  contact.g = factor.transpose().solve(Eigen::VectorXd(g_w + S_w * w_prescribed));
  const Eigen::MatrixXd A_dependent = selected_rows(contact.A, contact.dependent);
  contact.E.resize(f, A_dependent.rows());
  if (!contact.dependent.empty())  // SparseLU does not take zero right-hand sides
    contact.E = factor.transpose().solve(Eigen::MatrixXd(A_dependent.transpose()));
  contact.dependent_offset = selected(contact.v_prescribed, contact.dependent) - A_dependent * w_prescribed;
  return contact;
}

Eigen::VectorXd kept_displacement(const CondensedContact& contact, const Eigen::VectorXd& v_primary) {
  Factor factor;
  factorise_primary(contact, factor);
  return contact.to_kept * factor.solve(Eigen::VectorXd(v_primary - selected(contact.v_prescribed, contact.primary)));
}

}  // namespace ffcontact
