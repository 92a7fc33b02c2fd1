// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/elastic_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr double symmetry_tolerance = 1e-9;

using RowIterator = RowMatrixView::InnerIterator;

void require_finite_entries(const RowMatrixView& A) {
  visit_entries(A, [](const RowIterator& entry) {
    if (!std::isfinite(entry.value()))
      refuse("A(", entry.row(), ",", entry.col(), ") is ", entry.value(),
             ", not finite");
  });
}

void require_no_negative_diagonal(const RowMatrixView& A,
                                  const Flags& prescribed) {
  for (Index dof = 0; dof < A.rows(); ++dof)
    if (!prescribed[dof] && A.coeff(dof, dof) < 0)
      refuse("A(", dof, ",", dof, ") is ", A.coeff(dof, dof),
             ": no body has a negative stiffness, mind the signs of the varf");
}

/// A fixed vector without structure, zero on prescribed dofs.
VectorXd arbitrary(const Flags& prescribed, double start, double step,
                   int period) {
  VectorXd x = VectorXd::Zero(static_cast<Index>(prescribed.size()));
  for (Index i = 0; i < x.size(); ++i)
    if (!prescribed[i])
      x[i] = std::sin(start + step * static_cast<double>(i % period));
  return x;
}

/// |x' (K y) - y' (K x)| vanishes for a symmetric K.
void require_symmetric(const RowMatrixView& A, const Flags& prescribed) {
  const VectorXd x = arbitrary(prescribed, 1.0, 0.7, 1009);
  const VectorXd y = arbitrary(prescribed, 3.5, 1.3, 1013);
  const VectorXd Ax = A * x, Ay = A * y;
  const double scale = y.cwiseProduct(Ax).cwiseAbs().sum();
  if (std::abs(x.dot(Ay) - y.dot(Ax)) > symmetry_tolerance * scale)
    refuse("A is not symmetric on the free dofs");
}

/// Refuses values other than zero where the columns of all prescribed dofs are gone: what
/// they load the body with is lost.
void require_columns(const RowMatrixView& A, const Flags& prescribed,
                     const VectorXd& prescribed_value) {
  if (has_columns(A, prescribed)) return;
  Index dof = 0;
  while (prescribed_value[dof] == 0) ++dof;
  refuse("dof ", dof, " is prescribed to ", prescribed_value[dof],
         " but its column of A is gone: assemble A and b with tgv=-1 or the "
         "default tgv");
}

void require_square(const RowMatrixView& A) {
  if (A.rows() != A.cols())
    refuse("A has ", A.rows(), " rows and ", A.cols(),
           " columns, it must be square");
}

void require_shape(const RowMatrixView& A, const Ref<const VectorXd>& b,
                   int dimension) {
  require_square(A);
  require_size("b", b.size(), A.rows());
  if (A.rows() % dimension != 0)
    refuse("A has ", A.rows(), " rows, no multiple of the dimension ",
           dimension);
}

void read_prescribed_values(const RowMatrixView& A,
                            const Ref<const VectorXd>& b,
                            ElasticSystem& system) {
  for (Index dof = 0; dof < A.rows(); ++dof)
    if (system.prescribed[dof])
      system.prescribed_value[dof] = b[dof] / A.coeff(dof, dof);
}

void require_one_dimension(const std::vector<ElasticSystem>& bodies) {
  for (const ElasticSystem& body : bodies)
    if (body.dimension != bodies.front().dimension)
      refuse("a plane body and a solid in one system");
}

/// A system of the size of all bodies, without rows.
ElasticSystem room_for(const std::vector<ElasticSystem>& bodies) {
  Index dofs = 0, entries = 0;
  for (const ElasticSystem& body : bodies) {
    dofs += body.dof_count();
    entries += body.stiffness.nonZeros();
  }
  ElasticSystem joined{
      RowMatrix(dofs, dofs), VectorXd(dofs), {}, VectorXd(dofs)};
  if (!bodies.empty()) joined.dimension = bodies.front().dimension;
  joined.stiffness.reserve(entries);
  return joined;
}

/// Appends a row of K, its rows and columns numbered from `first` on.
void append_row(const RowMatrix& K, Index row, Index first, RowMatrix& joined) {
  joined.startVec(first + row);
  for (RowMatrix::InnerIterator e(K, row); e; ++e)
    joined.insertBack(first + row, first + e.col()) = e.value();
}

}  // namespace

ElasticSystem elastic_system(MovableMatrix matrix, const Ref<const VectorXd>& b,
                             int dimension) {
  require_shape(matrix, b, dimension);
  require_finite("b", b);
  require_finite_entries(matrix);

  ElasticSystem system{
      std::move(matrix), b, {}, VectorXd::Zero(b.size()), dimension};
  const RowMatrix& A = system.stiffness;
  system.prescribed = prescribed_dofs(A);
  require_no_negative_diagonal(A, system.prescribed);
  require_symmetric(A, system.prescribed);
  read_prescribed_values(A, b, system);
  if (!system.prescribed_value.isZero(0)) {
    require_columns(A, system.prescribed, system.prescribed_value);
    system.load -= A * system.prescribed_value;
  }
  system.load = on_free_dofs(system, std::move(system.load));
  return system;
}

void require_same_tgv(const ElasticSystem& system, double extent) {
  constexpr double far = 1e15;  // tgv is 1e30
  const double value = max_norm(system.prescribed_value);
  if (value > far * extent)
    refuse("the largest prescribed displacement is ", value,
           " on a mesh of size ", extent,
           ": assemble A and b with the same tgv");
  for (Index dof = 0; dof < system.load.size(); ++dof)
    if (std::abs(system.load[dof]) >
        far * extent * system.stiffness.coeff(dof, dof))
      refuse("b is ", system.load[dof], " at dof ", dof,
             ", which A does not prescribe: assemble A and b with the same "
             "on() and tgv");
}

VectorXd on_free_dofs(const ElasticSystem& system, VectorXd forces) {
  for (Index dof = 0; dof < forces.size(); ++dof)
    if (system.prescribed[dof]) forces[dof] = 0;
  return forces;
}

ElasticSystem joined_systems(const std::vector<ElasticSystem>& bodies) {
  require_one_dimension(bodies);
  ElasticSystem joined = room_for(bodies);
  Index first = 0;
  for (const ElasticSystem& body : bodies) {
    const Index size = body.dof_count();
    joined.load.segment(first, size) = body.load;
    joined.prescribed_value.segment(first, size) = body.prescribed_value;
    joined.prescribed.insert(joined.prescribed.end(), body.prescribed.begin(),
                             body.prescribed.end());
    for (Index row = 0; row < size; ++row)
      append_row(body.stiffness, row, first, joined.stiffness);
    first += size;
  }
  joined.stiffness.finalize();
  return joined;
}

Index free_dof_count(const ElasticSystem& system) {
  return std::count(system.prescribed.begin(), system.prescribed.end(), 0);
}

std::vector<int> free_dofs_at(const std::vector<int>& vertices,
                              const ElasticSystem& system) {
  const int dim = system.dimension;
  Flags seen(system.prescribed.size(), 0);
  std::vector<int> dofs;
  for (int v : vertices)
    for (int dof = dim * v; dof < dim * v + dim; ++dof)
      if (!system.prescribed[dof] && !seen[dof]) {
        seen[dof] = 1;
        dofs.push_back(dof);
      }
  return dofs;
}

}  // namespace ffcontact
