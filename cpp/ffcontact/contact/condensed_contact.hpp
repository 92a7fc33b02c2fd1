// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseLU>
#include <vector>

#include "ffcontact/contact/contact_law.hpp"
#include "ffcontact/elastic/condensed_stiffness.hpp"

namespace ffcontact {

/// The body as the contact conditions see it: a small dense relation between multipliers P and v = W (u_n - gap, u_t - previous).
///
/// Row 2 i + c stands for component c (0 normal, 1 tangential) of node i. Rows are primary, as many as the contact vertices
/// have free dofs, or dependent: a row whose dof is prescribed, or that of the second node at a corner. With S u_c = g + W'P
/// from CondensedStiffness and v = A w in terms of the free components w,
///     P = S v - g - E q,    v_dependent = E' v + offset,    E = A_primary^-T A_dependent',
/// where P and v are those of the primary rows and q are the multipliers of the dependent rows.
/// At a vertex with one free dof the primary row is the normal one unless the dof is tangential.
///
/// Where no equation determines the multiplier of a prescribed dof, lambda_t = 0 at a vertex that may move along n (symmetry
/// demands it there); lambda_n, and both at a clamped vertex, are continued from the next node of the line.
struct CondensedContact {
  std::vector<int> primary;    ///< row of each primary unknown [f]
  std::vector<int> dependent;  ///< row of each dependent unknown [d]
  std::vector<int> continued;  ///< row whose multiplier a dependent row takes where nothing determines it, or -1: 0 [d]
  Eigen::VectorXi position;    ///< of each row: its place in `primary`, or -1 - its place in `dependent` [2 p]
  Eigen::MatrixXd S;           ///< [f x f]
  Eigen::VectorXd g;           ///< [f]
  Eigen::MatrixXd E;           ///< [f x d]
  Eigen::VectorXd dependent_offset;     ///< [d]
  std::vector<int> kept_dofs;           ///< free dofs of the contact vertices, the unknowns of CondensedStiffness
  Eigen::SparseMatrix<double> to_kept;  ///< displacement of the kept dofs = to_kept w [kept x f]
  Eigen::SparseMatrix<double> A;        ///< v of all rows = A w + v_prescribed [2 p x f]
  Eigen::VectorXd v_prescribed;         ///< v of the prescribed values, gap and previous displacement included [2 p]

  bool is_primary(int row) const { return position[row] >= 0; }
};

/// The free dofs of the vertices on the line, in the order of its nodes.
std::vector<int> contact_dofs(const ContactLine& line, const ElasticSystem& system);

/// @throws std::invalid_argument  if the contact line has no free dof
CondensedContact condensed_contact(const ContactLine& line, const ContactLaw& law, const ElasticSystem& system,
                                   const CondensedStiffness& stiffness);

/// Displacement of the kept dofs that has the given v on the primary rows [kept].
Eigen::VectorXd kept_displacement(const CondensedContact& contact, const Eigen::VectorXd& v_primary);

}  // namespace ffcontact
