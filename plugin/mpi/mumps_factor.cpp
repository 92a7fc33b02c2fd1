// SPDX-License-Identifier: GPL-3.0-or-later
#include "mumps_factor.hpp"

#include <dmumps_c.h>
#include <smumps_c.h>

#include <algorithm>
#include <new>
#include <numeric>
#include <string>
#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/factor/scaled_stiffness.hpp"
#include "ffcontact/linear/dense/symmetric.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact::plugin {

namespace {

enum Job { begin = -1, end = -2, analyse = 1, factorise = 2, solve = 3 };
constexpr int positive_definite = 1, host_works = 1;

[[noreturn]] void fail(int info, int detail) {
  switch (info) {
    case -40:
    case -10: fail_as_singular();
    case -9:
    case -13:
    case -19: throw Failure("out of memory");
    default:
      throw Failure("MUMPS failed with INFOG(1) = " + std::to_string(info) +
                    ", INFOG(2) = " + std::to_string(detail));
  }
}

bool is_finalised() {
  int finalised = 0;
  MPI_Finalized(&finalised);
  return finalised != 0;
}

/// MUMPS in one of its precisions.
template <class Scalar>
struct Mumps;
template <>
struct Mumps<double> {
  using Data = DMUMPS_STRUC_C;
  static void run(Data& data) { dmumps_c(&data); }
};
template <>
struct Mumps<float> {
  using Data = SMUMPS_STRUC_C;
  static void run(Data& data) { smumps_c(&data); }
};

template <class Scalar>
class MumpsFactor : public SharedFactor {
 public:
  MumpsFactor(MPI_Comm communicator, MatrixPart part, int rows, int kept)
      : communicator_(communicator), rows_(rows), kept_(kept) {
    MPI_Comm_rank(communicator, &rank_);
    mumps_.par = host_works;
    mumps_.sym = positive_definite;
    mumps_.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(communicator));
    run(begin);
    settle();
    if (kept_ == 0) control(19) = 0;
    try {
      factorise_matrix(std::move(part));
    } catch (...) {
      release();
      throw;
    }
  }
  ~MumpsFactor() override { release(); }
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;

  /// Of a symmetric matrix MUMPS gives one triangle, by rows the lower one.
  MatrixXd take_schur() override {
    if (rank_ != 0) return {};
    schur_.transposeInPlace();
    mirror_lower(schur_);
    const auto schur = std::move(schur_);
    return schur.template cast<double>();
  }

  /// The load on the kept rows goes past MUMPS, which would round it.
  VectorXd condensed(const VectorXd& load) override {
    constexpr int reduce = 1;
    if (rank_ == 0) {
      const auto eliminated = load.head(rows_ - kept_);
      size_ = eliminated.isZero(0) ? 1 : max_norm(eliminated);
      solution_ = Values::Zero(rows_ + 1);
      solution_.segment(1, eliminated.size()) =
          (eliminated / size_).template cast<Scalar>();
    }
    reduced_ = Values::Zero(rank_ == 0 ? std::max(kept_, 1) : 0);
    solve_with(reduce);
    if (rank_ != 0) return {};
    return load.tail(kept_) +
           size_ * reduced_.head(kept_).template cast<double>();
  }

  VectorXd extended(const VectorXd& kept) override {
    constexpr int expand = 2;
    if (rank_ == 0)
      reduced_.head(kept_) = (kept / size_).template cast<Scalar>();
    solve_with(expand);
    if (rank_ != 0) return {};
    return size_ * solution_.tail(rows_).template cast<double>();
  }

 private:
  using Values = Matrix<Scalar, Dynamic, 1>;

  int& control(int k) { return mumps_.icntl[k - 1]; }

  void run(int job) {
    run_or_not(job);
    require_success();
  }
  void require_success() const {
    if (mumps_.infog[0] < 0) fail(mumps_.infog[0], mumps_.infog[1]);
  }
  void run_or_not(int job) {
    mumps_.job = job;
    Mumps<Scalar>::run(mumps_);
  }

  void settle() {
    constexpr int silent = 0, distributed_entries = 3, given_order = 1,
                  on_host = 1, sequential = 1;
    for (int output : {1, 2, 3, 4}) control(output) = silent;
    control(7) = given_order;
    control(14) = first_reserve;
    control(18) = distributed_entries;
    control(19) = on_host;
    control(28) = sequential;
  }

  /// Where the memory that the analysis expects is not enough, with more of it.
  void factorise_matrix(MatrixPart part) {
    const std::vector<Scalar> values = give(part);
    keep_last_rows();
    std::vector<int> order(rows_ + 1);
    std::iota(order.begin(), order.end(), 1);
    mumps_.perm_in = order.data();
    run(analyse);
    make_room_for_schur();
    run_or_not(factorise);
    while (is_short_of_reserve() && control(14) < most_reserve) {
      control(14) *= 2;
      run_or_not(factorise);
    }
    require_success();
  }

  bool is_short_of_reserve() const {
    constexpr int integers = -8, reals = -9;
    return mumps_.infog[0] == integers || mumps_.infog[0] == reals;
  }

  /// A first row of its own, so that there is one which is not kept; MUMPS counts from 1.
  /// @param part  stays until the matrix is factorised, as do the values
  std::vector<Scalar> give(MatrixPart& part) {
    for (int& i : part.row) i += 2;
    for (int& j : part.column) j += 2;
    if (rank_ == 0) {
      part.row.push_back(1);
      part.column.push_back(1);
      part.value.push_back(1);
    }
    const std::vector<double> given = std::move(part.value);
    std::vector<Scalar> values(given.begin(), given.end());
    mumps_.n = rows_ + 1;
    mumps_.nnz_loc = static_cast<MUMPS_INT8>(values.size());
    mumps_.irn_loc = part.row.data();
    mumps_.jcn_loc = part.column.data();
    mumps_.a_loc = values.data();
    return values;
  }

  void keep_last_rows() {
    list_.resize(kept_);
    std::iota(list_.begin(), list_.end(), rows_ - kept_ + 2);
    mumps_.size_schur = kept_;
    mumps_.listvar_schur = list_.data();
  }

  /// Process 0, if it has no memory, says so to all, who would wait for it.
  void make_room_for_schur() {
    const Index host = rank_ == 0 ? kept_ : 0;
    int there = 1, everywhere = 1;
    try {
      schur_.setZero(host, host);
    } catch (const std::bad_alloc&) {
      there = 0;
    }
    MPI_Allreduce(&there, &everywhere, 1, MPI_INT, MPI_MIN, communicator_);
    if (!everywhere) throw Failure("out of memory");
    mumps_.schur_lld = std::max(1, static_cast<int>(schur_.rows()));
    mumps_.schur = schur_.data();
  }

  void solve_with(int way) {
    control(26) = kept_ > 0 ? way : 0;
    // without kept rows the first half is the whole solution
    if (kept_ == 0 && way == 2) return;
    mumps_.nrhs = 1;
    mumps_.rhs = solution_.data();
    mumps_.lrhs = rows_ + 1;
    mumps_.redrhs = reduced_.data();
    mumps_.lredrhs = std::max(kept_, 1);
    run(solve);
  }

  void release() noexcept {
    if (is_finalised()) return;
    mumps_.job = end;
    Mumps<Scalar>::run(mumps_);
  }

  /// Percent beyond the memory that the analysis expects.
  static constexpr int first_reserve = 20, most_reserve = 1000;

  MPI_Comm communicator_;
  typename Mumps<Scalar>::Data mumps_{};
  int rank_ = 0, rows_, kept_;
  std::vector<int> list_;
  Matrix<Scalar, Dynamic, Dynamic> schur_;
  Values solution_, reduced_;
  double size_ = 1;  ///< of the last load, by which it is divided
};

}  // namespace

std::unique_ptr<SharedFactor> mumps_factor(MPI_Comm communicator,
                                           MatrixPart part, int rows, int kept,
                                           Precision precision) {
  if (precision == Precision::single)
    return std::make_unique<MumpsFactor<float>>(communicator, std::move(part),
                                                rows, kept);
  return std::make_unique<MumpsFactor<double>>(communicator, std::move(part),
                                               rows, kept);
}

}  // namespace ffcontact::plugin
