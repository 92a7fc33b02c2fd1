// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/scaled_stiffness.hpp"

#include <cmath>
#include <type_traits>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/memory.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// K_ii^-1/2; 1 where nothing holds a dof, which shows in the factor.
double inverse_root(const ElasticSystem& system, int dof) {
  if (system.prescribed[dof]) return 1;
  const double own = system.stiffness.coeff(dof, dof);
  return own > 0 ? 1 / std::sqrt(own) : 1;
}

void require_free(const ElasticSystem& system, int dof) {
  if (dof < 0 || dof >= system.dof_count() || system.prescribed[dof])
    refuse("kept dof ", dof, " is prescribed or does not exist");
}

}  // namespace

void require_room_for_schur(int kept, double memory) {
  constexpr double gigabyte = 1e9, copies = 3;
  const double needed = copies * kept * kept * sizeof(double);
  if (needed > memory / 2)
    refuse(kept, " free dofs where bodies may touch need dense matrices of ",
           needed / gigabyte, " GB, more than half of the memory (",
           memory / gigabyte,
           " GB): state contact on a smaller part of the boundary, or on a "
           "coarser mesh");
}

const std::vector<int>& required_kept(const ElasticSystem& system,
                                      const std::vector<int>& kept) {
  require_room_for_schur(count_of(kept), memory_of_the_machine());
  Flags met(system.dof_count(), 0);
  for (int dof : kept) {
    require_free(system, dof);
    if (met[dof]) refuse("kept dof ", dof, " is listed twice");
    met[dof] = 1;
  }
  return kept;
}

VectorXd inverse_roots(const ElasticSystem& system) {
  return VectorXd::NullaryExpr(
      system.dof_count(), [&](int dof) { return inverse_root(system, dof); });
}

std::vector<int> places(const std::vector<int>& order, std::size_t dofs) {
  std::vector<int> place(dofs, -1);
  int next = 0;
  for (int dof : order) place[dof] = next++;
  return place;
}

template <class Scalar>
MatrixXd unscaled(Matrix<Scalar, Dynamic, Dynamic> S, const VectorXd& R) {
  MatrixXd result;
  if constexpr (std::is_same_v<Scalar, double>)
    result.swap(S);
  else
    result.resize(S.rows(), S.cols());
#pragma omp parallel for
  for (Index j = 0; j < result.cols(); ++j) {
    if constexpr (!std::is_same_v<Scalar, double>)
      result.col(j) = S.col(j).template cast<double>();
    result.col(j).array() /= R.array() * R[j];
  }
  return result;
}

template MatrixXd unscaled(MatrixXd, const VectorXd&);
template MatrixXd unscaled(Matrix<float, Dynamic, Dynamic>, const VectorXd&);

void fail_as_singular() {
  throw Failure(
      "the stiffness matrix is singular: a part of the body is held neither by "
      "prescribed displacements nor by contact");
}

}  // namespace ffcontact
