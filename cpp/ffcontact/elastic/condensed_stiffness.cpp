// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/condensed_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/sparse_cholesky.hpp"

extern "C" void dgemm_(const char* transpose_a, const char* transpose_b,
                       const int* rows, const int* columns, const int* depth,
                       const double* alpha, const double* a,
                       const int* stride_of_a, const double* b,
                       const int* stride_of_b, const double* beta, double* c,
                       const int* stride_of_c);

namespace ffcontact {

namespace {

/// Lower triangle of L L' for a lower triangular L, by blocks of columns: a row of L ends
/// at its diagonal.
MatrixXd lower_product(const MatrixXd& L) {
  constexpr int block = 256;
  const int n = static_cast<int>(L.rows());
  const double one = 1, zero = 0;
  MatrixXd product(n, n);
  for (int first = 0; first < n; first += block) {
    const int rows = n - first, columns = std::min(block, rows),
              depth = first + columns;
    dgemm_("N", "T", &rows, &columns, &depth, &one, &L(first, 0), &n,
           &L(first, 0), &n, &zero, &product(first, first), &n);
  }
  return product;
}

/// The free dofs of a system that are not kept, and the vertices that have any.
class Interior {
 public:
  Interior(const ElasticSystem& system, const std::vector<int>& kept)
      : system_(system), is_kept_(system.prescribed.size(), 0) {
    for (int dof : kept) is_kept_[dof] = 1;
    number_.assign(system.prescribed.size() / system.dimension, -1);
    for (int v = 0; v < static_cast<int>(number_.size()); ++v)
      if (!dofs_of(v).empty()) {
        number_[v] = static_cast<int>(vertices_.size());
        vertices_.push_back(v);
      }
  }

  const std::vector<int>& vertices() const { return vertices_; }

  std::vector<int> dofs_of(int vertex) const {
    std::vector<int> dofs;
    const int first = system_.dimension * vertex;
    for (int dof = first; dof < first + system_.dimension; ++dof)
      if (!system_.prescribed[dof] && !is_kept_[dof]) dofs.push_back(dof);
    return dofs;
  }

  /// A vertex sees another one when any of its rows does; the first row holds all of them
  /// unless it is prescribed.
  Graph graph() const {
    Graph graph;
    for (int v : vertices_) {
      add_neighbours(v, graph.neighbours);
      graph.start.push_back(static_cast<int>(graph.neighbours.size()));
    }
    return graph;
  }

 private:
  int first_free_dof(int vertex) const {
    int dof = system_.dimension * vertex;
    while (system_.prescribed[dof]) ++dof;
    return dof;
  }

  /// Those with a higher number.
  void add_neighbours(int vertex, std::vector<int>& neighbours) const {
    const RowMatrix& K = system_.stiffness;
    int last = -1;
    for (RowMatrix::InnerIterator e(K, first_free_dof(vertex)); e; ++e) {
      const int w = number_[e.col() / system_.dimension];
      if (w > number_[vertex] && w != last) neighbours.push_back(last = w);
    }
  }

  const ElasticSystem& system_;
  std::vector<char> is_kept_;
  std::vector<int> vertices_;
  std::vector<int>
      number_;  ///< of each vertex among those of the interior, or -1
};

/// Free dofs in elimination order: the interior by vertices, then the kept dofs.
std::vector<int> elimination_order(const ElasticSystem& system,
                                   const std::vector<int>& kept) {
  const Interior interior(system, kept);
  std::vector<int> order;
  for (int k : dissection_order(interior.graph()))
    for (int dof : interior.dofs_of(interior.vertices()[k]))
      order.push_back(dof);
  order.insert(order.end(), kept.begin(), kept.end());
  return order;
}

/// Place of each dof in the elimination order; prescribed ones -1.
std::vector<int> places(const std::vector<int>& order, std::size_t dofs) {
  std::vector<int> place(dofs, -1);
  for (std::size_t k = 0; k < order.size(); ++k)
    place[order[k]] = static_cast<int>(k);
  return place;
}

/// K_ii^-1/2 on the free dofs [all dofs]; 1 where nothing holds a dof, which shows in the
/// factor.
VectorXd inverse_roots(const ElasticSystem& system) {
  VectorXd roots = VectorXd::Ones(system.dof_count());
  for (int dof = 0; dof < system.dof_count(); ++dof) {
    const double own =
        system.prescribed[dof] ? 0 : system.stiffness.coeff(dof, dof);
    if (own > 0) roots[dof] = 1 / std::sqrt(own);
  }
  return roots;
}

/// D on the kept dofs [all dofs]: the diagonal of K.
std::vector<double> added_diagonal(const ElasticSystem& system,
                                   const std::vector<int>& kept) {
  std::vector<double> added(system.prescribed.size(), 0);
  for (const int dof : kept) {
    if (dof < 0 || dof >= system.dof_count() || system.prescribed[dof])
      refuse("kept dof ", dof, " is prescribed or does not exist");
    if (added[dof] != 0) refuse("kept dof ", dof, " is listed twice");
    added[dof] = system.stiffness.coeff(dof, dof);
  }
  return added;
}

/// R (K + D) R in elimination order.
struct Eliminated {
  const RowMatrix& K;
  const std::vector<int>& order;
  const std::vector<int>& place;
  const std::vector<double>& added;  ///< D
  const VectorXd& scale;             ///< R

  bool in_upper(const RowMatrix::InnerIterator& e) const {
    return place[e.col()] >= 0 && place[e.col()] <= place[e.row()];
  }

  Index upper_entries() const {
    Index entries = 0;
    for (int dof : order)
      for (RowMatrix::InnerIterator e(K, dof); e; ++e) entries += in_upper(e);
    return entries;
  }

  /// By columns; by symmetry column j is read from the row of its dof.
  SparseMatrix upper_triangle() const {
    const auto n = static_cast<Index>(order.size());
    SparseMatrix upper(n, n);
    upper.reserve(std::max<Index>(1, upper_entries()));
    for (Index j = 0; j < n; ++j) {
      const int dof = order[j];
      upper.startVec(j);
      for (RowMatrix::InnerIterator e(K, dof); e; ++e) {
        if (!in_upper(e)) continue;
        const double sum = e.value() + (e.col() == dof ? added[dof] : 0);
        upper.insertBackByOuterInnerUnordered(j, place[e.col()]) =
            scale[dof] * sum * scale[e.col()];
      }
    }
    upper.finalize();
    return upper;
  }
};

SparseCholesky factorised(const SparseMatrix& upper) {
  SparseCholesky factor(upper);
  if (factor.reciprocal_condition() < 1e-15)
    throw std::runtime_error(
        "the stiffness matrix is singular: a part of the body is held neither "
        "by "
        "prescribed "
        "displacements nor by contact");
  return factor;
}

}  // namespace

struct CondensedStiffness::Factor {
  std::vector<int> kept;
  VectorXd scale;  ///< R, so that R K R has a diagonal of 1 [all dofs]
  std::vector<int>
      order;  ///< the free dofs as they are eliminated, the kept ones last
  std::vector<int> place;  ///< of each dof in it; -1 where prescribed
  SparseCholesky cholesky;
  MatrixXd trailing_factor;  ///< L_cc, lower triangular
  MatrixXd schur;

  Factor(const ElasticSystem& system, const std::vector<int>& kept_dofs,
         const std::vector<double>& added)
      : kept(kept_dofs),
        scale(inverse_roots(system)),
        order(elimination_order(system, kept)),
        place(places(order, system.prescribed.size())),
        cholesky(
            factorised(Eliminated{system.stiffness, order, place, added, scale}
                           .upper_triangle())),
        trailing_factor(
            cholesky.trailing_block(static_cast<int>(kept.size()))) {
    compute_schur(added);
  }

  Index kept_count() const { return static_cast<Index>(kept.size()); }

  void compute_schur(const std::vector<double>& added) {
    const Index size = kept_count();
    const MatrixXd product = lower_product(trailing_factor);
    schur.resize(size, size);
    for (Index j = 0; j < size; ++j) {
      for (Index i = 0; i < size; ++i) {
        const auto [low, high] = std::minmax(i, j);
        schur(i, j) = product(high, low) / (scale[kept[i]] * scale[kept[j]]);
      }
      schur(j, j) -= added[kept[j]];
    }
  }

  /// R^-1 x on the kept dofs.
  VectorXd unscaled(const VectorXd& x) const {
    VectorXd result(kept_count());
    for (Index k = 0; k < kept_count(); ++k) result[k] = x[k] / scale[kept[k]];
    return result;
  }

  /// L^-1 R b on the free dofs in elimination order.
  VectorXd forward(const Ref<const VectorXd>& load) const {
    require_size("load", load.size(), static_cast<Index>(place.size()));
    VectorXd b(static_cast<Index>(order.size()));
    for (std::size_t k = 0; k < order.size(); ++k)
      b[k] = scale[order[k]] * load[order[k]];
    return cholesky.half_solve(b);
  }

  /// R L'^-1 y on all dofs, 0 on prescribed ones.
  VectorXd backward(const VectorXd& y) const {
    const VectorXd x = cholesky.other_half_solve(y);
    VectorXd u = VectorXd::Zero(static_cast<Index>(place.size()));
    for (std::size_t k = 0; k < order.size(); ++k)
      u[order[k]] = scale[order[k]] * x[k];
    return u;
  }
};

CondensedStiffness::CondensedStiffness(const ElasticSystem& system,
                                       const std::vector<int>& kept)
    : factor_(std::make_unique<Factor>(system, kept,
                                       added_diagonal(system, kept))) {}

CondensedStiffness::~CondensedStiffness() = default;
CondensedStiffness::CondensedStiffness(CondensedStiffness&&) noexcept = default;
CondensedStiffness& CondensedStiffness::operator=(
    CondensedStiffness&&) noexcept = default;

const MatrixXd& CondensedStiffness::schur() const { return factor_->schur; }

CondensedStiffness::Load CondensedStiffness::condensed(
    const Ref<const VectorXd>& load) const {
  const Factor& f = *factor_;
  VectorXd y = f.forward(load);
  const auto L_cc = f.trailing_factor.triangularView<Eigen::Lower>();
  VectorXd g = f.unscaled(L_cc * y.tail(f.kept_count()));
  return {std::move(y), std::move(g)};
}

VectorXd CondensedStiffness::extended(
    Load load, const Ref<const VectorXd>& kept_displacement) const {
  const Factor& f = *factor_;
  require_size("kept displacement", kept_displacement.size(), f.kept_count());
  const VectorXd u_c = f.unscaled(kept_displacement);
  // L' x = y has the trailing part L_cc' u_c = y_c: overwriting y_c prescribes u_c.
  load.eliminated.tail(f.kept_count()) =
      f.trailing_factor.transpose().triangularView<Eigen::Upper>() * u_c;
  return f.backward(load.eliminated);
}

}  // namespace ffcontact
