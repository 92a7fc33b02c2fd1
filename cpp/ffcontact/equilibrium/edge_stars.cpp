// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/edge_stars.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "ffcontact/base/congruent.hpp"
#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/base/packed.hpp"
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
      A = congruent(A, basis);
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
      parts_(Matrix9Xd::Zero(9, count_of(topology.edges.facet))),
      stars_(topology.edges.count()),
      first_of_factor_(1, 0) {
  const Hinges<3>& edges = topology.edges;
  for (int e = 0; e < edges.count(); ++e) {
    const int size = share.edge[e] ? unknowns_around(edges, e) : 0;
    largest_ = std::max(largest_, tiled(size));
    first_of_factor_.push_back(first_of_factor_.back() + factor_size(size));
  }
  factors_.reset(new float[first_of_factor_.back()]);
  place_faces();
#pragma omp parallel for
  for (int e = 0; e < edges.count(); ++e)
    if (share.edge[e])
      stars_[e] =
          star(e, boundary, forms, factors_.get() + first_of_factor_[e]);
}

void EdgeStars::place_faces() {
  const Hinges<3>& edges = topology_.edges;
#pragma omp parallel for
  for (int e = 0; e < edges.count(); ++e)
    for (int i = edges.facet_start[e]; i < edges.facet_start[e + 1]; ++i) {
      const int face = edges.facet[i];
      shifts_[i] = wrench_shift(topology_, face, e);
      for (int k = 0; k < 3; ++k)
        if (edges.of_facet(k, face) == e) place_(k, face) = i;
    }
}

/// x = Z' g
void EdgeStars::restrict_to(int edge, const Matrix9Xd& g, double* x) const {
  const Hinges<3>& edges = topology_.edges;
  Vector6d wrench = Vector6d::Zero();
  double* bars = x + 6;
  for (int i = edges.facet_start[edge]; i < edges.facet_start[edge + 1];
       ++i, bars += 3) {
    const auto of_face = g.col(edges.facet[i]);
    wrench += shifts_[i].transposed_times(of_face.head<6>());
    Map<Vector3d>{bars} = of_face.tail<3>();
  }
  Map<Vector6d>{x} = wrench;
}

/// x <- A^-1 basis' x
void EdgeStars::solve(int edge, double* x) const {
  const auto& [basis, size] = stars_[edge];
  if (basis.size() > 0) {
    Map<VectorXd> all(x, unknowns_around(topology_.edges, edge));
    const VectorXd inside = basis.transpose() * all;
    all.head(size) = inside;
  }
  solve_tiles(factors_.get() + first_of_factor_[edge], size, x);
}

/// What an edge has for one of its faces: Z basis x.
Vector9d EdgeStars::of_face(int edge, int face, const double* x) const {
  const auto& [basis, size] = stars_[edge];
  const int bars_of_face = 6 + 3 * (face - topology_.edges.facet_start[edge]);
  Vector6d wrench;
  Vector3d bars;
  if (basis.size() > 0) {
    const Map<const VectorXd> inside(x, size);
    wrench = basis.topRows<6>() * inside;
    bars = basis.middleRows<3>(bars_of_face) * inside;
  } else {
    wrench = Map<const Vector6d>(x);
    bars = Map<const Vector3d>(x + bars_of_face);
  }
  Vector9d unknowns;
  unknowns << shifts_[face].times(wrench), bars;
  return unknowns;
}

void EdgeStars::operator()(const Matrix9Xd& g, Matrix9Xd& z) {
  const std::vector<int>& start = topology_.edges.facet_start;
#pragma omp parallel
  {
    VectorXd x = VectorXd::Zero(largest_);
#pragma omp for
    for (int e = 0; e < topology_.edges.count(); ++e) {
      if (stars_[e].size == 0) continue;
      restrict_to(e, g, x.data());
      solve(e, x.data());
      for (int i = start[e]; i < start[e + 1]; ++i)
        parts_.col(i) = of_face(e, i, x.data());
    }
#pragma omp for
    for (int f = 0; f < topology_.faces.count(); ++f)
      if (share_.face[f])
        z.col(f) = parts_.col(place_(0, f)) + parts_.col(place_(1, f)) +
                   parts_.col(place_(2, f));
      else
        z.col(f).setZero();
  }
}

}  // namespace ffcontact
