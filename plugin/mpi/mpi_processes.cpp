// SPDX-License-Identifier: GPL-3.0-or-later
#include "mpi_processes.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "mumps_factor.hpp"

namespace ffcontact::plugin {

namespace {

constexpr int tag = 20010;
/// Bytes of one message: MPI counts them in int.
constexpr std::size_t most = std::size_t{1} << 30;

class MpiProcesses : public Processes {
 public:
  /// Messages of the script and of MUMPS go other ways.
  explicit MpiProcesses(MPI_Comm communicator) {
    MPI_Comm_dup(communicator, &communicator_);
    MPI_Comm_dup(communicator, &of_factors_);
    MPI_Comm_rank(communicator_, &rank_);
    MPI_Comm_size(communicator_, &count_);
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  void send(int rank, const Bytes& bytes) const override {
    unsigned long long size = bytes.size();
    MPI_Send(&size, 1, MPI_UNSIGNED_LONG_LONG, rank, tag, communicator_);
    for (std::size_t first = 0; first < bytes.size(); first += most)
      MPI_Send(bytes.data() + first, length(bytes.size() - first), MPI_BYTE,
               rank, tag, communicator_);
  }

  /// Waits without work.
  Bytes receive(int rank) const override {
    wait_for(rank);
    unsigned long long size = 0;
    MPI_Recv(&size, 1, MPI_UNSIGNED_LONG_LONG, rank, tag, communicator_,
             MPI_STATUS_IGNORE);
    Bytes bytes(size);
    for (std::size_t first = 0; first < bytes.size(); first += most)
      MPI_Recv(bytes.data() + first, length(bytes.size() - first), MPI_BYTE,
               rank, tag, communicator_, MPI_STATUS_IGNORE);
    return bytes;
  }

  std::unique_ptr<SharedFactor> factorised(MatrixPart part, int rows, int kept,
                                           Precision precision) const override {
    return mumps_factor(of_factors_, std::move(part), rows, kept, precision);
  }

 private:
  static int length(std::size_t left) {
    return static_cast<int>(std::min(left, most));
  }

  /// MPI itself waits by asking without end, which takes a processor from who works.
  void wait_for(int rank) const {
    using namespace std::chrono_literals;
    constexpr auto longest = std::chrono::microseconds(1ms);
    auto pause = std::chrono::microseconds(1us);
    int there = 0;
    while (true) {
      MPI_Iprobe(rank, tag, communicator_, &there, MPI_STATUS_IGNORE);
      if (there) return;
      std::this_thread::sleep_for(pause);
      pause = std::min(2 * pause, longest);
    }
  }

  MPI_Comm communicator_, of_factors_;
  int rank_ = 0, count_ = 1;
};

}  // namespace

std::unique_ptr<Processes> mpi_processes(void* communicator) {
  return std::make_unique<MpiProcesses>(*static_cast<MPI_Comm*>(communicator));
}

}  // namespace ffcontact::plugin
