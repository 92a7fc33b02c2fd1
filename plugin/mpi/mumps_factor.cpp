// SPDX-License-Identifier: GPL-3.0-or-later
#include "mumps_factor.hpp"

#include <dmumps_c.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "ffcontact/base/symmetric.hpp"
#include "ffcontact/elastic/scaled_stiffness.hpp"

namespace ffcontact::plugin {

namespace {

enum Job { begin = -1, end = -2, analyse_and_factorise = 4, solve = 3 };
constexpr int positive_definite = 1, host_works = 1;

[[noreturn]] void fail(int info, int detail) {
  switch (info) {
    case -40:
    case -10: fail_as_singular();
    case -9:
    case -13:
    case -19: throw std::runtime_error("out of memory");
    default:
      throw std::runtime_error(
          "MUMPS failed with INFOG(1) = " + std::to_string(info) +
          ", INFOG(2) = " + std::to_string(detail));
  }
}

bool is_finalised() {
  int finalised = 0;
  MPI_Finalized(&finalised);
  return finalised != 0;
}

class MumpsFactor : public SharedFactor {
 public:
  MumpsFactor(MPI_Comm communicator, MatrixPart part, int rows, int kept)
      : rows_(rows), kept_(kept) {
    MPI_Comm_rank(communicator, &rank_);
    mumps_.par = host_works;
    mumps_.sym = positive_definite;
    mumps_.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(communicator));
    run(begin);
    settle();
    give(part);
    if (kept_ == 0) control(19) = 0;
    keep_last_rows();
    try {
      run(analyse_and_factorise);
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
    return std::move(schur_);
  }

  VectorXd condensed(const VectorXd& load) override {
    constexpr int reduce = 1;
    if (rank_ == 0) {
      solution_ = VectorXd::Zero(rows_ + 1);
      solution_.tail(rows_) = load;
    }
    reduced_ = VectorXd::Zero(rank_ == 0 ? std::max(kept_, 1) : 0);
    solve_with(reduce);
    return reduced_.head(rank_ == 0 ? kept_ : 0);
  }

  VectorXd extended(const VectorXd& kept) override {
    constexpr int expand = 2;
    if (rank_ == 0) reduced_.head(kept_) = kept;
    solve_with(expand);
    return rank_ == 0 ? solution_.tail(rows_) : VectorXd();
  }

 private:
  int& control(int k) { return mumps_.icntl[k - 1]; }

  void run(int job) {
    mumps_.job = job;
    dmumps_c(&mumps_);
    if (mumps_.infog[0] < 0) fail(mumps_.infog[0], mumps_.infog[1]);
  }

  void settle() {
    constexpr int silent = 0, distributed_entries = 3, metis = 5, on_host = 1,
                  sequential = 1, more_memory = 40;
    for (int output : {1, 2, 3, 4}) control(output) = silent;
    control(7) = metis;
    control(14) = more_memory;  // percent beyond what the analysis expects
    control(18) = distributed_entries;
    control(19) = on_host;
    control(28) = sequential;
  }

  /// A first row of its own, so that there is one which is not kept; MUMPS counts from 1.
  /// @param part  stays until the matrix is factorised
  void give(MatrixPart& part) {
    for (int& i : part.row) i += 2;
    for (int& j : part.column) j += 2;
    if (rank_ == 0) {
      part.row.push_back(1);
      part.column.push_back(1);
      part.value.push_back(1);
    }
    mumps_.n = rows_ + 1;
    mumps_.nnz_loc = static_cast<MUMPS_INT8>(part.value.size());
    mumps_.irn_loc = part.row.data();
    mumps_.jcn_loc = part.column.data();
    mumps_.a_loc = part.value.data();
  }

  void keep_last_rows() {
    list_.resize(kept_);
    std::iota(list_.begin(), list_.end(), rows_ - kept_ + 2);
    mumps_.size_schur = kept_;
    mumps_.listvar_schur = list_.data();
    if (rank_ == 0) schur_ = MatrixXd::Zero(kept_, kept_);
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
    dmumps_c(&mumps_);
  }

  DMUMPS_STRUC_C mumps_{};
  int rank_ = 0, rows_, kept_;
  std::vector<int> list_;
  MatrixXd schur_;
  VectorXd solution_, reduced_;
};

}  // namespace

std::unique_ptr<SharedFactor> mumps_factor(MPI_Comm communicator,
                                           MatrixPart part, int rows,
                                           int kept) {
  return std::make_unique<MumpsFactor>(communicator, std::move(part), rows,
                                       kept);
}

}  // namespace ffcontact::plugin
