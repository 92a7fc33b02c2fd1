// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/stiffness_comparison.hpp"

#include <cmath>
#include <utility>

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// A field without order, between -1 and 1, and 0 where a dof is prescribed.
VectorXd probe(const Flags& prescribed) {
  VectorXd z(static_cast<Index>(prescribed.size()));
  unsigned number = 1;
  for (Index dof = 0; dof < z.size(); ++dof) {
    number = number * 1664525u + 1013904223u;  // Numerical Recipes' generator
    z[dof] = prescribed[dof] ? 0 : number / 2147483648.0 - 1;
  }
  return z;
}

/// What a row of A z is made of.
struct Row {
  double sum = 0, terms = 0;
};

Row row_of(const RowMatrix& A, const VectorXd& z, Index dof) {
  Row row;
  for (RowMatrix::InnerIterator a(A, dof); a; ++a) {
    const double term = a.value() * z[a.col()];
    row.sum += term;
    row.terms += std::abs(term);
  }
  return row;
}

}  // namespace

Comparison::Comparison(const RowMatrix& A, const StatedForces& forces,
                       const Flags& prescribed)
    : z(probe(prescribed)), of_law(forces(z)) {
  of_matrix = terms = off = VectorXd::Zero(z.size());
#pragma omp parallel for
  for (Index dof = 0; dof < z.size(); ++dof) {
    if (prescribed[dof]) continue;
    const Row row = row_of(A, z, dof);
    of_matrix[dof] = row.sum;
    terms[dof] = row.terms;
    off[dof] = relative(std::abs(row.sum - of_law[dof]), row.terms);
  }
}

double Comparison::factor() const {
  const auto elsewhere = (off.array() <= stiffness_tolerance).cast<double>();
  return ((1 - elsewhere) * of_matrix.array() * of_law.array()).sum() /
         ((1 - elsewhere) * of_law.array().square()).sum();
}

bool Comparison::is_multiple() const {
  const auto rest = (of_matrix - factor() * of_law).array().abs();
  return (rest <= stiffness_tolerance * terms.array() ||
          off.array() <= stiffness_tolerance)
      .all();
}

VectorXd row_beyond_law(const ElasticSystem& system, const StatedForces& forces,
                        Index dof) {
  VectorXd row = -forces(VectorXd::Unit(system.dof_count(), dof));
  for (RowMatrix::InnerIterator a(system.stiffness, dof); a; ++a)
    row[a.col()] += a.value();
  return on_free_dofs(system, std::move(row));
}

}  // namespace ffcontact
