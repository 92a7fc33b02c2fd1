// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/edge_stars.hpp"

#include <Eigen/Cholesky>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/equilibrium/edge_form.hpp"

namespace ffcontact {

namespace {

/// Conditions on the corrections of an edge that depend on others but for this part.
constexpr PivotThreshold dependent_conditions{1e-9};

/// The columns of L from the diagonal down.
Eigen::VectorXf packed_columns(const MatrixXd& L) {
  const Index n = L.rows();
  Eigen::VectorXf columns(n * (n + 1) / 2);
  Index next = 0;
  for (Index j = 0; j < n; next += n - j, ++j)
    columns.segment(next, n - j) = L.col(j).tail(n - j).cast<float>();
  return columns;
}

/// x <- L'^-1 L^-1 x
void solve_with(const Eigen::VectorXf& factor, Index n, double* x) {
  const float* column = factor.data();  // from its diagonal on
  for (Index j = 0; j < n; column += n - j, ++j) {
    const double value = x[j] /= column[0];
    for (Index i = 1; i < n - j; ++i) x[j + i] -= column[i] * value;
  }
  for (Index j = n - 1; j >= 0; --j) {
    column -= n - j;
    double sum = x[j];
    for (Index i = 1; i < n - j; ++i) sum -= column[i] * x[j + i];
    x[j] = sum / column[0];
  }
}

}  // namespace

EdgeStars::Star EdgeStars::star(int edge, const FaceTractions& boundary,
                                const FaceForms& forms) const {
  Star star;
  MatrixXd A = edge_form(topology_, edge, forms);
  if (topology_.edges.on_boundary[edge]) {
    const MatrixXd known = edge_conditions(topology_, edge, boundary.known);
    if (known.rows() > 0) {
      star.basis = kernel_basis(known, dependent_conditions);
      A = (star.basis.transpose() * A * star.basis).eval();
    }
  }
  if (A.rows() == 0) return star;
  const Eigen::LLT<MatrixXd> cholesky(A);
  if (cholesky.info() == Eigen::Success)
    star.factor = packed_columns(cholesky.matrixLLT());
  return star;
}

EdgeStars::EdgeStars(const SolidTopology& topology,
                     const FaceTractions& boundary, const FaceForms& forms)
    : topology_(topology),
      place_(3, topology.faces.count()),
      shifts_(topology.edges.facet.size()),
      stars_(topology.edges.count()),
      first_(1, 0) {
  const Hinges<3>& edges = topology.edges;
  for (int e = 0; e < edges.count(); ++e) {
    first_.push_back(first_.back() + unknowns(e));
    for (int i = 0; i < edges.facet_count(e); ++i) {
      const int face = edges.facet[edges.facet_start[e] + i];
      shifts_[edges.facet_start[e] + i] = wrench_shift(topology, face, e);
      for (int k = 0; k < 3; ++k)
        if (edges.of_facet(k, face) == e) place_(k, face) = i;
    }
  }
#pragma omp parallel for
  for (int e = 0; e < edges.count(); ++e) stars_[e] = star(e, boundary, forms);
}

const WrenchShift& EdgeStars::shift(int edge, int place) const {
  return shifts_[topology_.edges.facet_start[edge] + place];
}

/// x = Z' g
void EdgeStars::restrict_to(int edge, const Matrix9Xd& g,
                            Ref<VectorXd> x) const {
  const Hinges<3>& edges = topology_.edges;
  Vector6d wrench = Vector6d::Zero();
  for (int i = 0; i < edges.facet_count(edge); ++i) {
    const auto of_face = g.col(edges.facet[edges.facet_start[edge] + i]);
    wrench += shift(edge, i).transposed_times(of_face.head<6>());
    x.segment<3>(6 + 3 * i) = of_face.tail<3>();
  }
  x.head<6>() = wrench;
}

/// x <- A^-1 x
void EdgeStars::solve(int edge, Ref<VectorXd> x) const {
  const auto& [basis, factor] = stars_[edge];
  if (factor.size() == 0) {
    x.setZero();
  } else if (basis.size() == 0) {
    solve_with(factor, x.size(), x.data());
  } else {
    VectorXd inside = basis.transpose() * x;
    solve_with(factor, inside.size(), inside.data());
    x = basis * inside;
  }
}

/// What the edges of a face have for it.
Vector9d EdgeStars::gathered(int face, const VectorXd& x) const {
  Vector9d sum = Vector9d::Zero();
  for (int k = 0; k < 3; ++k) {
    const int edge = topology_.edges.of_facet(k, face), place = place_(k, face);
    const double* of_edge = x.data() + first_[edge];
    sum.head<6>() += shift(edge, place).times(Map<const Vector6d>(of_edge));
    sum.tail<3>() += Map<const Vector3d>(of_edge + 6 + 3 * place);
  }
  return sum;
}

Matrix9Xd EdgeStars::operator()(const Matrix9Xd& g) const {
  VectorXd x(first_.back());
#pragma omp parallel for
  for (int e = 0; e < topology_.edges.count(); ++e) {
    auto own = x.segment(first_[e], unknowns(e));
    restrict_to(e, g, own);
    solve(e, own);
  }
  Matrix9Xd z(9, g.cols());
#pragma omp parallel for
  for (int f = 0; f < topology_.faces.count(); ++f) z.col(f) = gathered(f, x);
  return z;
}

}  // namespace ffcontact
