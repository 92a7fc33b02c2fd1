// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/edge_stars.hpp"

#include <Eigen/Cholesky>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/equilibrium/edge_form.hpp"
#include "ffcontact/equilibrium/tiled_factor.hpp"

namespace ffcontact {

namespace {

/// Conditions on the corrections of an edge that depend on others but for this part.
constexpr PivotThreshold dependent_conditions{1e-9};

}  // namespace

EdgeStars::Star EdgeStars::star(int edge, const FaceTractions& boundary,
                                const FaceForms& forms, float* factor) const {
  Star star;
  MatrixXd A = edge_form(topology_, edge, forms);
  if (topology_.edges.on_boundary[edge]) {
    const MatrixXd known = edge_conditions(topology_, edge, boundary.known);
    if (known.rows() > 0) {
      const MatrixXd basis = kernel_basis(known, dependent_conditions);
      A = (basis.transpose() * A * basis).eval();
      star.basis = basis;
    }
  }
  star.size = static_cast<int>(A.rows());
  if (star.size == 0) return star;
  const Eigen::LLT<Ref<MatrixXd>> cholesky(A);  // in place
  if (cholesky.info() == Eigen::Success)
    put_tiles(A, factor);
  else
    star = {MatrixXd(), 0};
  return star;
}

EdgeStars::EdgeStars(const SolidTopology& topology, const FaceShare& share,
                     const FaceTractions& boundary, const FaceForms& forms)
    : topology_(topology),
      share_(share),
      place_(3, topology.faces.count()),
      shifts_(topology.edges.facet.size()),
      stars_(topology.edges.count()),
      first_(1, 0),
      first_of_factor_(1, 0) {
  const Hinges<3>& edges = topology.edges;
  for (int e = 0; e < edges.count(); ++e) {
    const int size = share.edge[e] ? unknowns_around(edges, e) : 0;
    first_.push_back(first_.back() + tiled(size));
    first_of_factor_.push_back(first_of_factor_.back() + factor_size(size));
    for (int i = 0; i < edges.facet_count(e); ++i) {
      const int face = edges.facet[edges.facet_start[e] + i];
      shifts_[edges.facet_start[e] + i] = wrench_shift(topology, face, e);
      for (int k = 0; k < 3; ++k)
        if (edges.of_facet(k, face) == e) place_(k, face) = i;
    }
  }
  x_.setZero(first_.back());
  factors_.reset(new float[first_of_factor_.back()]);
#pragma omp parallel for
  for (int e = 0; e < edges.count(); ++e)
    if (share.edge[e])
      stars_[e] =
          star(e, boundary, forms, factors_.get() + first_of_factor_[e]);
}

const WrenchShift& EdgeStars::shift(int edge, int place) const {
  return shifts_[topology_.edges.facet_start[edge] + place];
}

/// x = Z' g
void EdgeStars::restrict_to(int edge, const Matrix9Xd& g, double* x) const {
  const Hinges<3>& edges = topology_.edges;
  Vector6d wrench = Vector6d::Zero();
  for (int i = 0; i < edges.facet_count(edge); ++i) {
    const auto of_face = g.col(edges.facet[edges.facet_start[edge] + i]);
    wrench += shift(edge, i).transposed_times(of_face.head<6>());
    Map<Vector3d>(x + 6 + 3 * i) = of_face.tail<3>();
  }
  Map<Vector6d>{x} = wrench;
}

/// x <- A^-1 basis' x
void EdgeStars::solve(int edge, double* x) const {
  const auto& [basis, size] = stars_[edge];
  Map<VectorXd> all(x, unknowns_around(topology_.edges, edge));
  if (size == 0) {
    all.setZero();
    return;
  }
  if (basis.size() > 0) {
    const VectorXd inside = basis.transpose() * all;
    all.setZero();
    all.head(size) = inside;
  }
  solve_tiles(factors_.get() + first_of_factor_[edge], size, x);
}

/// What an edge has for one of its faces: Z basis x.
Vector9d EdgeStars::of_face(int edge, int place) const {
  const auto& [basis, size] = stars_[edge];
  const double* x = x_.data() + first_[edge];
  Vector6d wrench;
  Vector3d bars;
  if (basis.size() > 0) {
    const Map<const VectorXd> inside(x, size);
    wrench = basis.topRows<6>() * inside;
    bars = basis.middleRows<3>(6 + 3 * place) * inside;
  } else {
    wrench = Map<const Vector6d>(x);
    bars = Map<const Vector3d>(x + 6 + 3 * place);
  }
  Vector9d unknowns;
  unknowns << shift(edge, place).times(wrench), bars;
  return unknowns;
}

/// What the edges of a face have for it.
Vector9d EdgeStars::gathered(int face) const {
  Vector9d sum = Vector9d::Zero();
  for (int k = 0; k < 3; ++k)
    sum += of_face(topology_.edges.of_facet(k, face), place_(k, face));
  return sum;
}

void EdgeStars::operator()(const Matrix9Xd& g, Matrix9Xd& z) {
#pragma omp parallel for
  for (int e = 0; e < topology_.edges.count(); ++e) {
    if (!share_.edge[e]) continue;
    double* own = x_.data() + first_[e];
    restrict_to(e, g, own);
    solve(e, own);
  }
#pragma omp parallel for
  for (int f = 0; f < topology_.faces.count(); ++f)
    z.col(f) = share_.face[f] ? gathered(f) : Vector9d::Zero();
}

}  // namespace ffcontact
