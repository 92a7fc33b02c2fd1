// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_solves.hpp"

#include <algorithm>

#include "ffcontact/base/congruent.hpp"
#include "ffcontact/equilibrium/boundary_corrections.hpp"

namespace ffcontact {

namespace {

/// Stars of up to so many unknowns need no memory of their own.
constexpr int usual = 16;

/// H = L D L' in place, L below the diagonal and 1 / D on it; false if H is not positive
/// definite. For ten unknowns Eigen's kernels cost more than they save.
template <class Matrix>
bool factorise_in_place(Matrix& H) {
  const Index n = H.rows();
  for (Index j = 0; j < n; ++j) {
    if (!(H(j, j) > 0)) return false;
    const double inverse = 1 / H(j, j);
    for (Index k = j + 1; k < n; ++k) {
      const double factor = H(k, j) * inverse;
      for (Index i = k; i < n; ++i) H(i, k) -= factor * H(i, j);
    }
    H.col(j).tail(n - j - 1) *= inverse;
    H(j, j) = inverse;
  }
  return true;
}

/// Packs what factorise_in_place has left.
template <class Matrix>
void pack(const Matrix& H, float* below, double* inverse_pivot) {
  for (Index j = 0; j < H.rows(); ++j) {
    inverse_pivot[j] = H(j, j);
    for (Index i = j + 1; i < H.rows(); ++i)
      *below++ = static_cast<float>(H(i, j));
  }
}

}  // namespace

StarSolves::StarSolves(const StarSetting& setting)
    : setting_(setting), on_boundary_(setting.space.mesh.vertex_count()) {
  const int vertices = setting.space.mesh.vertex_count();
  first_below_.assign(vertices + 1, 0);
  for (int v = 0; v < vertices; ++v) {
    const Index n = star_unknowns(setting.stars, v);
    first_below_[v + 1] = first_below_[v] + n * (n - 1) / 2;
  }
  // Not vectors, which would be filled with zeros by one thread first.
  below_.reset(new float[first_below_[vertices]]);
  inverse_pivot_.reset(new double[first_unknown(vertices)]);
#pragma omp parallel for schedule(dynamic, 1024)
  for (int v = 0; v < vertices; ++v)
    if (setting.stars.on_boundary(v))
      factorise_on_boundary(v);
    else
      factorise(v);
}

void StarSolves::factorise(int vertex) {
  double* inverse_pivot = inverse_pivot_.get() + first_unknown(vertex);
  float* below = below_.get() + first_below_[vertex];
  const int n = star_unknowns(setting_.stars, vertex);
  const auto keep = [&](auto energy) {
    if (factorise_in_place(energy.H)) {
      pack(energy.H, below, inverse_pivot);
    } else {
      std::fill_n(below, n * (n - 1) / 2, 0.0f);
      std::fill_n(inverse_pivot, n, 0);
    }
  };
  if (n <= usual)
    keep(StarEnergy<usual>(setting_, vertex));
  else
    keep(StarEnergy<Dynamic>(setting_, vertex));
}

void StarSolves::factorise_on_boundary(int vertex) {
  MatrixXd Z = admissible_corrections(StarGroup(setting_, {vertex}),
                                      setting_.boundary, nullptr);
  if (Z.cols() == 0) return;
  const StarEnergy<Dynamic> energy(setting_, vertex);
  const MatrixXd H = energy.H.selfadjointView<Eigen::Lower>();
  Cholesky factor(congruent(H, Z));
  if (factor.is_positive_definite())
    on_boundary_[vertex].reset(
        new BoundaryStar{std::move(Z), std::move(factor)});
}

void StarSolves::solve_inside(int vertex, int n, double* y) const {
  const float* column = below_.get() + first_below_[vertex];
  const double* inverse_pivot = inverse_pivot_.get() + first_unknown(vertex);
  for (int j = 0; j < n; ++j)
    for (int i = j + 1; i < n; ++i) y[i] -= *column++ * y[j];
  for (int j = n - 1; j >= 0; --j) {
    column -= n - 1 - j;
    y[j] *= inverse_pivot[j];
    for (int i = j + 1; i < n; ++i) y[j] -= column[i - j - 1] * y[i];
  }
}

void StarSolves::solve(int vertex, double* y) const {
  const int n = star_unknowns(setting_.stars, vertex);
  if (!setting_.stars.on_boundary(vertex)) {
    solve_inside(vertex, n, y);
    return;
  }
  Map<VectorXd> all(y, n);
  if (const BoundaryStar* star = on_boundary_[vertex].get())
    all = star->Z * star->energy.solve(star->Z.transpose() * all);
  else
    all.setZero();
}

VectorXd StarSolves::operator()(const VectorXd& r) const {
  const auto& space = setting_.space;
  const Stars& stars = setting_.stars;
  VectorXd z(r.size());
  Matrix2Xd on_spokes(2, space.edges.count());  // of the star of either vertex
#pragma omp parallel
  {
    std::vector<double> y;
#pragma omp for
    for (int v = 0; v < space.mesh.vertex_count(); ++v) {
      const int first = stars.spoke_start[v], spokes = stars.spoke_count(v);
      y.resize(3 + spokes);
      std::copy_n(r.data() + space.of_vertex(v), 3, y.data());
      for (int k = 0; k < spokes; ++k)
        y[3 + k] = r[space.of_edge(stars.spoke[first + k])];
      solve(v, y.data());
      std::copy_n(y.data(), 3, z.data() + space.of_vertex(v));
      for (int k = 0; k < spokes; ++k) {
        const int e = stars.spoke[first + k];
        on_spokes(space.edges.vertices(0, e) == v ? 0 : 1, e) = y[3 + k];
      }
    }
#pragma omp for
    for (int e = 0; e < space.edges.count(); ++e)
      z[space.of_edge(e)] = on_spokes(0, e) + on_spokes(1, e);
  }
  return z;
}

}  // namespace ffcontact
