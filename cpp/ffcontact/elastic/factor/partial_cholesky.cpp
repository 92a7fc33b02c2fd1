// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/partial_cholesky.hpp"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <utility>
#include <vector>

#include "ffcontact/elastic/factor/factor_blocks.hpp"
#include "ffcontact/elastic/factor/panel.hpp"
#include "ffcontact/linear/dense/dense_factors.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"
#include "ffcontact/linear/dense/symmetric.hpp"

namespace ffcontact {

namespace {

/// Columns that are updated at once where threads share a supernode or S.
constexpr int shared_width = 128, schur_width = 256;
/// What a thread needs for itself.
template <class Scalar>
struct Workspace {
  Matrix<Scalar, Dynamic, 1> product;
  std::vector<int> place;
};

}  // namespace

template <class Scalar>
struct PartialCholesky<Scalar>::Factor : FactorBlocks<Scalar> {
  using Work = std::vector<Workspace<Scalar>>;
  using FactorBlocks<Scalar>::nodes;
  using FactorBlocks<Scalar>::thread_count;
  using FactorBlocks<Scalar>::tree;
  using FactorBlocks<Scalar>::values_of;

  int eliminated, kept;
  /// those that have rows among the columns of each, ascending; of S the last
  std::vector<std::vector<int>> descendants;
  Square schur;
  ProgressReport report;     ///< none once it is factored
  std::atomic<int> done{0};  ///< columns

  Factor(const SparseMatrix& lower, int kept_columns, ProgressReport told)
      : FactorBlocks<Scalar>(
            supernodes(lower, static_cast<int>(lower.cols()) - kept_columns)),
        eliminated(static_cast<int>(lower.cols()) - kept_columns),
        kept(kept_columns),
        descendants(nodes.count() + 1),
        report(std::move(told)) {
    find_descendants();
    factorise(lower);
    report = nullptr;
  }

  int size() const { return eliminated + kept; }

  void find_descendants() {
    for (int d = 0; d < nodes.count(); ++d) add_descendant(d);
  }
  /// One of each supernode that has a row of it among its columns.
  void add_descendant(int d) {
    const int *row = nodes.rows_below(d), *end = nodes.end_of_rows(d);
    while (row != end) {
      const int s = supernode_of(*row);
      descendants[s].push_back(d);
      row = std::lower_bound(row, end, end_of_columns(s));
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

  Work work_of_threads() const {
    Work work(thread_count());
    for (Workspace<Scalar>& own : work) {
      own.product.resize(largest_product());
      own.place.resize(size());
    }
    return work;
  }

  void factorise(const SparseMatrix& lower) {
    const SerialBlas serial;
    Work work = work_of_threads();
    factorise_subtrees(lower, work);
    for (int s : tree.above) factorise_above(lower, s, work);
    compute_schur(lower, work);
  }

  /// Columns of L_ii or S that are done; the thread that asked for the factor tells.
  void count_columns(const char* phase, int more, int all) {
    const int columns = done += more;
    if (omp_get_thread_num() == 0)
      tell(report, {phase, columns, "of", static_cast<double>(all)});
  }

  Index largest_product() const {
    Index rows = 0;
    for (int s = 0; s < nodes.count(); ++s)
      rows = std::max<Index>(rows, nodes.row_count(s) - nodes.column_count(s));
    return rows * std::max(widest_supernode, schur_width);
  }

  void factorise_subtrees(const SparseMatrix& lower, Work& work) {
    const int count = static_cast<int>(tree.supernodes.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(work.size())
    for (int k = 0; k < count; ++k) {
      Workspace<Scalar>& own = work[omp_get_thread_num()];
      for (int s : tree.supernodes[k]) {
        assemble(lower, s);
        put_places(s, own.place);
        subtract_products(s, panel_of(s, 0, widest_supernode, own.place),
                          own.product);
        factorise_block(s);
        count_columns("factorisation, column", nodes.column_count(s),
                      eliminated);
      }
    }
  }

  /// The columns are shared.
  void factorise_above(const SparseMatrix& lower, int s, Work& work) {
    assemble(lower, s);
    put_places(s, work[0].place);
#pragma omp parallel for schedule(dynamic, 1) num_threads(work.size())
    for (int first = 0; first < nodes.column_count(s); first += shared_width)
      subtract_products(s, panel_of(s, first, shared_width, work[0].place),
                        work[omp_get_thread_num()].product);
    factorise_block(s);
    count_columns("factorisation, column", nodes.column_count(s), eliminated);
  }

  void compute_schur(const SparseMatrix& lower, Work& work) {
    done = 0;
    schur = Square::Zero(kept, kept);
    for (int j = 0; j < kept; ++j)
      for (SparseMatrix::InnerIterator e(lower, eliminated + j); e; ++e)
        schur(e.row() - eliminated, j) = static_cast<Scalar>(e.value());
    for (int row = eliminated; row < size(); ++row)
      work[0].place[row] = row - eliminated;
#pragma omp parallel for schedule(dynamic, 1) num_threads(work.size())
    for (int first = 0; first < kept; first += schur_width) {
      subtract_products(nodes.count(), schur_panel(first, work[0].place),
                        work[omp_get_thread_num()].product);
      count_columns("Schur complement, column",
                    std::min(schur_width, kept - first), kept);
    }
    mirror_lower(schur);
  }

  /// The columns of A.
  void assemble(const SparseMatrix& lower, int s) {
    const int *rows = nodes.begin_of_rows(s), *end = nodes.end_of_rows(s);
    Scalar* column = values_of(s);
    std::fill(column, values_of(s + 1), Scalar(0));
    for (int j = 0; j < nodes.column_count(s); ++j, column += end - rows)
      for (SparseMatrix::InnerIterator e(lower, nodes.first_column[s] + j); e;
           ++e)
        column[std::lower_bound(rows, end, e.row()) - rows] =
            static_cast<Scalar>(e.value());
  }

  void put_places(int s, std::vector<int>& place) const {
    int next = 0;
    for (const int* row = nodes.begin_of_rows(s); row != nodes.end_of_rows(s);
         ++row)
      place[*row] = next++;
  }

  Panel<Scalar> panel_of(int s, int first, int most,
                         const std::vector<int>& place) const {
    const int stride = nodes.row_count(s),
              width = std::min(most, nodes.column_count(s) - first),
              column = nodes.first_column[s] + first;
    return {column, column + width,
            values_of(s) + static_cast<Index>(first) * stride, stride,
            place.data()};
  }

  Panel<Scalar> schur_panel(int first, const std::vector<int>& place) {
    const int width = std::min(schur_width, kept - first),
              column = eliminated + first;
    return {column, column + width, &schur(0, first), kept, place.data()};
  }

  /// - L_d L_d' of all descendants d; above the diagonal it leaves what nothing reads.
  void subtract_products(int s, const Panel<Scalar>& panel,
                         Matrix<Scalar, Dynamic, 1>& product) const {
    for (int d : descendants[s]) {
      const int *rows = nodes.rows_below(d), *end = nodes.end_of_rows(d),
                *first = std::lower_bound(rows, end, panel.first),
                *last = std::lower_bound(first, end, panel.end);
      if (first == last) continue;
      const FactorRows<Scalar> L{
          values_of(d) + (first - nodes.begin_of_rows(d)),
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
    const int rows = nodes.row_count(s);
    Scalar* L = values_of(s);
    if (!factorise_columns(rows, nodes.column_count(s), L, rows)) L[0] = 0;
  }
};

template <class Scalar>
PartialCholesky<Scalar>::PartialCholesky(const SparseMatrix& lower, int kept,
                                         const ProgressReport& report)
    : factor_(std::make_unique<Factor>(lower, kept, report)) {}

template <class Scalar>
PartialCholesky<Scalar>::~PartialCholesky() = default;
template <class Scalar>
PartialCholesky<Scalar>::PartialCholesky(PartialCholesky&&) noexcept = default;
template <class Scalar>
PartialCholesky<Scalar>& PartialCholesky<Scalar>::operator=(
    PartialCholesky&&) noexcept = default;

template <class Scalar>
double PartialCholesky<Scalar>::reciprocal_condition() const {
  return factor_->reciprocal_condition();
}

template <class Scalar>
typename PartialCholesky<Scalar>::Square PartialCholesky<Scalar>::take_schur() {
  return std::move(factor_->schur);
}

template <class Scalar>
VectorXd PartialCholesky<Scalar>::half_solve(const VectorXd& right) const {
  return factor_->half_solve(right);
}

template <class Scalar>
VectorXd PartialCholesky<Scalar>::other_half_solve(
    const VectorXd& right) const {
  return factor_->other_half_solve(right);
}

template class PartialCholesky<double>;
template class PartialCholesky<float>;

}  // namespace ffcontact
