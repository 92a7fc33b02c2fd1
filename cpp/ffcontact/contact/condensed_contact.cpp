// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed_contact.hpp"

#include <map>
#include <stdexcept>

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/sparse_lu.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"

namespace ffcontact {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// A free direction of a contact vertex is taken as tangential when its normal component
/// is below this.
constexpr double tangential = 1e-3;

/// How a vertex moves: displacement = directions w for its free components w (first
/// column of `directions` at `column`).
struct VertexMotion {
  int column = 0;
  std::vector<int> rows;  ///< primary row of each free component
  Matrix<double, 2, Dynamic> directions;
};

VertexMotion vertex_motion(const ContactLine& line, int node,
                           const std::vector<char>& prescribed) {
  const int v = line.vertex[node];
  const Vector2d n = line.normal.col(node), t = line.tangent(node);
  VertexMotion motion;
  if (!prescribed[2 * v] && !prescribed[2 * v + 1]) {
    motion.rows = {2 * node, 2 * node + 1};
    motion.directions.resize(2, 2);
    motion.directions << n, t;
  } else if (!prescribed[2 * v] || !prescribed[2 * v + 1]) {
    const Vector2d d =
        prescribed[2 * v] ? Vector2d::UnitY() : Vector2d::UnitX();
    const bool along_tangent = std::abs(n.dot(d)) < tangential;
    motion.rows = {2 * node + (along_tangent ? 1 : 0)};
    motion.directions = d;
  } else {
    motion.directions.resize(2, 0);
  }
  return motion;
}

/// Fills primary, dependent and position; the first node of a vertex carries its primary
/// rows.
std::map<int, VertexMotion> number_rows(const ContactLine& line,
                                        const std::vector<char>& prescribed,
                                        CondensedContact& contact) {
  std::map<int, VertexMotion> motions;
  contact.position = VectorXi::Zero(2 * line.node_count());
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
  for (std::size_t k = 0; k < contact.primary.size(); ++k)
    contact.position[contact.primary[k]] = static_cast<int>(k);
  for (int row = 0; row < 2 * line.node_count(); ++row)
    if (!primary[row]) {
      contact.position[row] = -1 - static_cast<int>(contact.dependent.size());
      contact.dependent.push_back(row);
    }
  return motions;
}

/// The opposite vertices that carry no rows move by their free components. Returns the
/// number of all unknowns.
int number_opposite(const ContactLine& line,
                    const std::vector<char>& prescribed, int unknowns,
                    std::map<int, VertexMotion>& motions) {
  for (const int v : opposite_vertices(line)) {
    if (motions.count(v)) continue;
    VertexMotion motion;
    motion.column = unknowns;
    motion.directions.resize(2, 2 - prescribed[2 * v] - prescribed[2 * v + 1]);
    for (int c = 0, column = 0; c < 2; ++c)
      if (!prescribed[2 * v + c])
        motion.directions.col(column++) = Vector2d::Unit(c);
    unknowns += static_cast<int>(motion.directions.cols());
    motions.emplace(v, std::move(motion));
  }
  return unknowns;
}

/// Trace operator of all rows, [u]_rows = T w; 0 on held rows.
SparseMatrix trace_operator(const ContactLine& line,
                            const std::vector<char>& held,
                            const std::map<int, VertexMotion>& motions,
                            Index unknowns) {
  Triplets entries;
  const auto add_motion = [&](int node, int vertex, double factor) {
    const VertexMotion& motion = motions.at(vertex);
    const Vector2d direction[2] = {line.normal.col(node), line.tangent(node)};
    for (Index k = 0; k < motion.directions.cols(); ++k)
      for (int c = 0; c < 2; ++c)
        if (!held[2 * node + c])
          entries.emplace_back(
              2 * node + c, motion.column + k,
              factor * direction[c].dot(motion.directions.col(k)));
  };
  for (int i = 0; i < line.node_count(); ++i) {
    add_motion(i, line.vertex[i], 1);
    visit_opposite(line, i, [&](int vertex, double weight) {
      add_motion(i, vertex, -weight);
    });
  }
  SparseMatrix T(2 * line.node_count(), unknowns);
  T.setFromTriplets(entries.begin(), entries.end());
  return T;
}

SparseMatrix selected_rows(const SparseMatrix& A,
                           const std::vector<int>& rows) {
  Triplets entries;
  for (std::size_t k = 0; k < rows.size(); ++k)
    entries.emplace_back(static_cast<int>(k), rows[k], 1.0);
  SparseMatrix selection(static_cast<Index>(rows.size()), A.rows());
  selection.setFromTriplets(entries.begin(), entries.end());
  return selection * A;
}

/// Displacement of the kept dofs in terms of w.
SparseMatrix kept_operator(const std::map<int, VertexMotion>& motions,
                           const std::vector<int>& kept, Index unknowns) {
  Triplets entries;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const VertexMotion& motion = motions.at(kept[k] / 2);
    for (Index j = 0; j < motion.directions.cols(); ++j)
      entries.emplace_back(static_cast<int>(k), motion.column + j,
                           motion.directions(kept[k] % 2, j));
  }
  SparseMatrix Q(static_cast<Index>(kept.size()), unknowns);
  Q.setFromTriplets(entries.begin(), entries.end());
  return Q;
}

/// Of A on the primary rows.
SparseLu primary_factor(const CondensedContact& contact) {
  const auto f = static_cast<Index>(contact.primary.size());
  SparseLu factor(selected_rows(contact.A, contact.primary).leftCols(f));
  if (!factor.is_regular())
    refuse(
        "the contact multipliers are not independent: the contact line turns "
        "too sharply "
        "between prescribed vertices");
  return factor;
}

/// The relation between v, w_o and the multipliers before w_o is condensed, loads apart:
///     S v + V' w_o = P + E q,   V v + O w_o = E_o q,   v_dependent = E' v + E_o' w_o.
struct OppositeTerms {
  MatrixXd V, O, E;
};

/// Fills S and E as if w_o were given.
OppositeTerms relation_with_opposite(const CondensedStiffness& stiffness,
                                     const SparseLu& factor,
                                     CondensedContact& contact) {
  const auto f = static_cast<Index>(contact.primary.size()),
             o = contact.A.cols() - f;
  const SparseMatrix Qt = contact.to_kept.transpose();
  const MatrixXd S_w = Qt * stiffness.schur() * contact.to_kept;
  // A^-T S_w
  const MatrixXd half =
      factor.solve_transposed_columns(S_w.topLeftCorner(f, f));
  contact.S = factor.solve_transposed_columns(half.transpose());
  contact.S = (0.5 * (contact.S + contact.S.transpose())).eval();
  const MatrixXd A_dependent = selected_rows(contact.A, contact.dependent);
  contact.E =
      factor.solve_transposed_columns(A_dependent.leftCols(f).transpose());

  // w = A^-1 (v - v_prescribed) - X w_o with X = A^-1 A_o.
  OppositeTerms terms;
  const MatrixXd X = factor.solve_columns(
      selected_rows(contact.A, contact.primary).rightCols(o));
  const MatrixXd S_ow =
      S_w.bottomLeftCorner(o, f) - X.transpose() * S_w.topLeftCorner(f, f);
  terms.V = factor.solve_transposed_columns(S_ow.transpose()).transpose();
  terms.O = S_w.bottomRightCorner(o, o) - S_ow * X -
            X.transpose() * S_w.topRightCorner(f, o);
  terms.E = A_dependent.rightCols(o).transpose() -
            X.transpose() * A_dependent.leftCols(f).transpose();
  return terms;
}

/// w_o = O^-1 (h + E_o q - V v) put into the relation, loads apart.
void condense_opposite(const OppositeTerms& terms, CondensedContact& contact) {
  contact.opposite_of_v = MatrixXd::Zero(terms.V.rows(), terms.V.cols());
  contact.opposite_of_q = MatrixXd::Zero(terms.E.rows(), terms.E.cols());
  contact.F = MatrixXd::Zero(terms.E.cols(), terms.E.cols());
  if (terms.O.rows() == 0) return;
  contact.opposite_scale =
      terms.O.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const auto R = contact.opposite_scale.asDiagonal();
  contact.opposite_stiffness.emplace(
      MatrixXd(R * (0.5 * (terms.O + terms.O.transpose())) * R));
  if (!contact.opposite_stiffness->is_positive_definite() ||
      contact.opposite_stiffness->reciprocal_condition() < 1e-15)
    throw std::runtime_error(
        "the bodies are not held, even with their contact lines glued to each "
        "other");
  contact.opposite_of_v =
      R * contact.opposite_stiffness->solve_columns(-(R * terms.V));
  contact.S += terms.V.transpose() * contact.opposite_of_v;
  contact.S = (0.5 * (contact.S + contact.S.transpose())).eval();
  contact.opposite_of_q =
      R * contact.opposite_stiffness->solve_columns(R * terms.E);
  contact.E += contact.opposite_of_v.transpose() * terms.E;
  contact.F = terms.E.transpose() * contact.opposite_of_q;
}

/// g and the offsets for a load and the v of prescribed values.
void put_loads(const CondensedStiffness& stiffness, const VectorXd& load,
               const VectorXd& v_prescribed, const SparseLu& factor,
               CondensedContact& contact) {
  const auto f = static_cast<Index>(contact.primary.size()),
             o = contact.A.cols() - f;
  contact.v_prescribed = v_prescribed;
  VectorXd w_prescribed = VectorXd::Zero(f + o);
  w_prescribed.head(f) = factor.solve(v_prescribed(contact.primary));
  contact.load = stiffness.condensed(load);
  const VectorXd forces =
      contact.load.on_kept +
      stiffness.schur() * VectorXd(contact.to_kept * w_prescribed);
  const VectorXd g_w = contact.to_kept.transpose() * forces;
  contact.g = factor.solve_transposed(g_w.head(f));
  contact.dependent_offset =
      v_prescribed(contact.dependent) -
      selected_rows(contact.A, contact.dependent) * w_prescribed;
  contact.opposite_offset = VectorXd::Zero(o);
  if (o == 0) return;
  const SparseMatrix A_o =
      selected_rows(contact.A, contact.primary).rightCols(o);
  const VectorXd h = g_w.tail(o) - A_o.transpose() * contact.g;
  contact.opposite_offset =
      contact.opposite_scale.cwiseProduct(contact.opposite_stiffness->solve(
          contact.opposite_scale.cwiseProduct(h)));
  contact.g += contact.opposite_of_v.transpose() * h;
  contact.dependent_offset += contact.opposite_of_q.transpose() * h;
}

}  // namespace

std::vector<int> contact_dofs(const ContactLine& line,
                              const ElasticSystem& system) {
  std::vector<int> vertices(line.vertex.begin(), line.vertex.end()), dofs;
  const std::vector<int> opposite = opposite_vertices(line);
  vertices.insert(vertices.end(), opposite.begin(), opposite.end());
  std::vector<char> seen(system.prescribed.size(), 0);
  for (int v : vertices)
    for (int dof = 2 * v; dof < 2 * v + 2; ++dof)
      if (!system.prescribed[dof] && !seen[dof]) {
        seen[dof] = 1;
        dofs.push_back(dof);
      }
  return dofs;
}

double motion_scale(const CondensedContact& contact, const VectorXd& v) {
  double scale = v.cwiseAbs().maxCoeff();
  for (Index i = 0; i < contact.g.size(); ++i) {
    const int other = contact.position[contact.primary[i] ^ 1];
    const double stiffness =
        std::max(contact.S(i, i), other >= 0 ? contact.S(other, other) : 0);
    if (stiffness > 0)
      scale = std::max(scale, std::abs(contact.g[i]) / stiffness);
  }
  return scale;
}

CondensedContact condensed_contact(const ContactLine& line,
                                   const ContactLaw& law,
                                   const ElasticSystem& system,
                                   const CondensedStiffness& stiffness) {
  CondensedContact contact;
  contact.held = held_rows(line, law, system);
  contact.kept_dofs = contact_dofs(line, system);
  std::map<int, VertexMotion> motions =
      number_rows(line, system.prescribed, contact);
  if (contact.primary.empty())
    refuse("every dof of the contact line is prescribed");
  const std::vector<int> continued = continued_rows(line, system.prescribed);
  for (int row : contact.dependent) contact.continued.push_back(continued[row]);
  const int unknowns =
      number_opposite(line, system.prescribed,
                      static_cast<int>(contact.primary.size()), motions);

  const SparseMatrix W = weight_of_rows(law.multiplier, line);
  contact.A = W * trace_operator(line, contact.held.row, motions, unknowns);
  contact.to_kept = kept_operator(motions, contact.kept_dofs, unknowns);
  const SparseLu factor = primary_factor(contact);
  condense_opposite(relation_with_opposite(stiffness, factor, contact),
                    contact);
  const VectorXd v_prescribed =
      W * steered_displacement(line, law, contact.held, system.prescribed_value)
              .reshaped();
  put_loads(stiffness, system.load, v_prescribed, factor, contact);
  return contact;
}

CondensedContact with_loads(CondensedContact contact,
                            const CondensedStiffness& stiffness,
                            const VectorXd& load,
                            const VectorXd& v_prescribed) {
  put_loads(stiffness, load, v_prescribed, primary_factor(contact), contact);
  return contact;
}

VectorXd kept_displacement(const CondensedContact& contact, const VectorXd& v,
                           const VectorXd& q) {
  const auto f = static_cast<Index>(contact.primary.size()),
             o = contact.A.cols() - f;
  VectorXd w(f + o);
  w.tail(o) = contact.opposite_offset + contact.opposite_of_v * v +
              contact.opposite_of_q * q;
  const VectorXd from_opposite =
      selected_rows(contact.A, contact.primary).rightCols(o) * w.tail(o);
  w.head(f) = primary_factor(contact).solve(
      v - contact.v_prescribed(contact.primary) - from_opposite);
  return contact.to_kept * w;
}

}  // namespace ffcontact
