// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/partial_cholesky.hpp"

#include <omp.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ffcontact/base/serial_blas.hpp"
#include "ffcontact/base/symmetric.hpp"
#include "ffcontact/elastic/panel.hpp"
#include "ffcontact/elastic/subtrees.hpp"

extern "C" {
void dpotrf_(const char* triangle, const int* n, double* a, const int* stride,
             int* info);
void dtrsm_(const char* side, const char* triangle, const char* transpose,
            const char* diagonal, const int* rows, const int* columns,
            const double* alpha, const double* a, const int* stride_of_a,
            double* b, const int* stride_of_b);
}

namespace ffcontact {

namespace {

/// Columns that are updated at once where threads share a supernode or S.
constexpr int shared_width = 128, schur_width = 256;
/// A subtree is at most this share of a thread's work.
constexpr double subtree_share = 0.125;

/// Products from which on threads pay.
constexpr double least_shared_work = 1e8;

/// What a thread needs for itself.
struct Workspace {
  VectorXd product;
  std::vector<int> place;
};

}  // namespace

struct PartialCholesky::Factor {
  int eliminated, kept;
  Supernodes nodes;
  std::vector<std::size_t> start;  ///< of the values of each supernode
  /// of the supernodes, each [rows x columns]
  std::unique_ptr<double[]> values;
  /// those that have rows among the columns of each, ascending; of S the last
  std::vector<std::vector<int>> descendants;
  MatrixXd schur;

  Factor(const SparseMatrix& lower, int kept_columns)
      : eliminated(static_cast<int>(lower.cols()) - kept_columns),
        kept(kept_columns),
        nodes(supernodes(lower, eliminated)),
        descendants(nodes.count() + 1) {
    allocate();
    find_descendants();
    factorise(lower);
  }

  int size() const { return eliminated + kept; }
  double* values_of(int s) const { return values.get() + start[s]; }

  /// Each page is first touched by the thread that fills it.
  void allocate() {
    start.push_back(0);
    for (int s = 0; s < nodes.count(); ++s)
      start.push_back(start.back() +
                      static_cast<std::size_t>(nodes.row_count(s)) *
                          nodes.column_count(s));
    values.reset(new double[start.back()]);
  }

  void find_descendants() {
    for (int d = 0; d < nodes.count(); ++d) {
      const int *row = nodes.rows_below(d), *end = nodes.end_of_rows(d);
      while (row != end) {
        const int s = supernode_of(*row);
        descendants[s].push_back(d);
        row = std::lower_bound(row, end, end_of_columns(s));
      }
    }
  }

  /// That of S is the number of supernodes.
  int supernode_of(int row) const {
    const auto& first = nodes.first_column;
    if (row >= eliminated) return nodes.count();
    return static_cast<int>(std::upper_bound(first.begin(), first.end(), row) -
                            first.begin()) -
           1;
  }
  int end_of_columns(int s) const {
    return s < nodes.count() ? nodes.first_column[s + 1] : size();
  }

  void factorise(const SparseMatrix& lower) {
    const int threads = thread_count();
    const Subtrees tree = subtrees(nodes, subtree_share / threads);
    std::vector<Workspace> work(threads);
    for (Workspace& own : work) {
      own.product.resize(largest_product());
      own.place.resize(size());
    }
    factorise_subtrees(lower, tree, work);
    for (int s : tree.above) factorise_above(lower, s, work);
    compute_schur(lower, work);
  }

  int thread_count() const {
    double work = 0;
    for (int s = 0; s < nodes.count(); ++s) work += work_of(nodes, s);
    return work < least_shared_work ? 1 : omp_get_max_threads();
  }

  Index largest_product() const {
    Index rows = 0;
    for (int s = 0; s < nodes.count(); ++s)
      rows = std::max<Index>(rows, nodes.row_count(s) - nodes.column_count(s));
    return rows * std::max(widest_supernode, schur_width);
  }

  void factorise_subtrees(const SparseMatrix& lower, const Subtrees& tree,
                          std::vector<Workspace>& work) {
    const SerialBlas serial;
    const int count = static_cast<int>(tree.supernodes.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(work.size())
    for (int k = 0; k < count; ++k) {
      Workspace& own = work[omp_get_thread_num()];
      for (int s : tree.supernodes[k]) {
        assemble(lower, s);
        put_places(s, own.place);
        subtract_products(s, panel_of(s, 0, widest_supernode, own.place),
                          own.product);
        factorise_block(s);
      }
    }
  }

  /// The columns are shared.
  void factorise_above(const SparseMatrix& lower, int s,
                       std::vector<Workspace>& work) {
    assemble(lower, s);
    put_places(s, work[0].place);
    {
      const SerialBlas serial;
#pragma omp parallel for schedule(dynamic, 1) num_threads(work.size())
      for (int first = 0; first < nodes.column_count(s); first += shared_width)
        subtract_products(s, panel_of(s, first, shared_width, work[0].place),
                          work[omp_get_thread_num()].product);
    }
    factorise_block(s);
  }

  void compute_schur(const SparseMatrix& lower, std::vector<Workspace>& work) {
    schur = MatrixXd::Zero(kept, kept);
    for (int j = 0; j < kept; ++j)
      for (SparseMatrix::InnerIterator e(lower, eliminated + j); e; ++e)
        schur(e.row() - eliminated, j) = e.value();
    for (int row = eliminated; row < size(); ++row)
      work[0].place[row] = row - eliminated;
    {
      const SerialBlas serial;
#pragma omp parallel for schedule(dynamic, 1) num_threads(work.size())
      for (int first = 0; first < kept; first += schur_width)
        subtract_products(nodes.count(), schur_panel(first, work[0].place),
                          work[omp_get_thread_num()].product);
    }
    mirror_lower(schur);
  }

  /// The columns of A.
  void assemble(const SparseMatrix& lower, int s) {
    const int *rows = nodes.begin_of_rows(s), *end = nodes.end_of_rows(s);
    double* column = values_of(s);
    std::fill(column, values_of(s + 1), 0.0);
    for (int j = 0; j < nodes.column_count(s); ++j, column += end - rows)
      for (SparseMatrix::InnerIterator e(lower, nodes.first_column[s] + j); e;
           ++e)
        column[std::lower_bound(rows, end, e.row()) - rows] = e.value();
  }

  void put_places(int s, std::vector<int>& place) const {
    int next = 0;
    for (const int* row = nodes.begin_of_rows(s); row != nodes.end_of_rows(s);
         ++row)
      place[*row] = next++;
  }

  Panel panel_of(int s, int first, int most,
                 const std::vector<int>& place) const {
    const int stride = nodes.row_count(s),
              width = std::min(most, nodes.column_count(s) - first),
              column = nodes.first_column[s] + first;
    return {column, column + width,
            values_of(s) + static_cast<Index>(first) * stride, stride,
            place.data()};
  }

  Panel schur_panel(int first, const std::vector<int>& place) {
    const int width = std::min(schur_width, kept - first),
              column = eliminated + first;
    return {column, column + width, &schur(0, first), kept, place.data()};
  }

  /// - L_d L_d' of all descendants d; above the diagonal it leaves what nothing reads.
  void subtract_products(int s, const Panel& panel, VectorXd& product) const {
    for (int d : descendants[s]) {
      const int *rows = nodes.rows_below(d), *end = nodes.end_of_rows(d),
                *first = std::lower_bound(rows, end, panel.first),
                *last = std::lower_bound(first, end, panel.end);
      if (first == last) continue;
      const FactorRows L{values_of(d) + (first - nodes.begin_of_rows(d)),
                         nodes.row_count(d),
                         nodes.column_count(d),
                         first,
                         static_cast<int>(end - first),
                         static_cast<int>(last - first)};
      subtract_product(L, panel, product);
    }
  }

  /// L_ss and the rows below it; a first entry of 0 tells that there is none.
  void factorise_block(int s) {
    const int n = nodes.column_count(s), stride = nodes.row_count(s),
              rows = stride - n;
    double* L = values_of(s);
    int info = 0;
    dpotrf_("L", &n, L, &stride, &info);
    const double one = 1;
    if (info != 0)
      L[0] = 0;
    else if (rows > 0)
      dtrsm_("R", "L", "T", "N", &rows, &n, &one, L, &stride, L + n, &stride);
  }

  using Block = Map<const MatrixXd>;
  Block block(int s) const {
    return {values_of(s), nodes.row_count(s), nodes.column_count(s)};
  }
};

PartialCholesky::PartialCholesky(const SparseMatrix& lower, int kept)
    : factor_(std::make_unique<Factor>(lower, kept)) {}

PartialCholesky::~PartialCholesky() = default;
PartialCholesky::PartialCholesky(PartialCholesky&&) noexcept = default;
PartialCholesky& PartialCholesky::operator=(PartialCholesky&&) noexcept =
    default;

double PartialCholesky::reciprocal_condition() const {
  double least = 1, largest = 1;
  for (int s = 0; s < factor_->nodes.count(); ++s) {
    const auto diagonal = factor_->block(s).diagonal();
    if (!diagonal.allFinite()) return 0;
    least = s == 0 ? diagonal.minCoeff() : std::min(least, diagonal.minCoeff());
    largest =
        s == 0 ? diagonal.maxCoeff() : std::max(largest, diagonal.maxCoeff());
  }
  const double ratio = std::max(least, 0.0) / largest;
  return ratio * ratio;
}

MatrixXd PartialCholesky::take_schur() { return std::move(factor_->schur); }

VectorXd PartialCholesky::half_solve(VectorXd b) const {
  const Supernodes& nodes = factor_->nodes;
  for (int s = 0; s < nodes.count(); ++s) {
    const auto L = factor_->block(s);
    const Index n = L.cols(), below = L.rows() - n;
    auto x = b.segment(nodes.first_column[s], n);
    L.topRows(n).triangularView<Eigen::Lower>().solveInPlace(x);
    const VectorXd product = L.bottomRows(below) * x;
    const int* row = nodes.rows_below(s);
    for (Index i = 0; i < below; ++i) b[row[i]] -= product[i];
  }
  return b;
}

VectorXd PartialCholesky::other_half_solve(VectorXd y) const {
  const Supernodes& nodes = factor_->nodes;
  for (int s = nodes.count() - 1; s >= 0; --s) {
    const auto L = factor_->block(s);
    const Index n = L.cols(), below = L.rows() - n;
    const Map<const VectorXi> rows(nodes.rows_below(s), below);
    auto x = y.segment(nodes.first_column[s], n);
    const VectorXd known = y(rows);
    x.noalias() -= L.bottomRows(below).transpose() * known;
    L.topRows(n).transpose().triangularView<Eigen::Upper>().solveInPlace(x);
  }
  return y;
}

}  // namespace ffcontact
