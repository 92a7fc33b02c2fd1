// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "ffcontact/parallel/shared_relaxation.hpp"

/// Processes that are threads of one.
namespace ffcontact::test {

/// What is on its way between all of them. A message waits until it is received, and so
/// does who sends it.
class Post {
 public:
  void put(int from, int to, Messages::Bytes bytes) {
    std::unique_lock<std::mutex> lock(mutex_);
    auto& box = boxes_[{from, to}];
    box.push_back(std::move(bytes));
    changed_.notify_all();
    changed_.wait(lock, [&] { return box.empty(); });
  }
  Messages::Bytes take(int from, int to) {
    std::unique_lock<std::mutex> lock(mutex_);
    auto& box = boxes_[{from, to}];
    changed_.wait(lock, [&] { return !box.empty(); });
    Messages::Bytes bytes = std::move(box.front());
    box.pop_front();
    changed_.notify_all();
    return bytes;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::pair<int, int>, std::deque<Messages::Bytes>> boxes_;
};

class MessagesByPost : public Messages {
 public:
  MessagesByPost(Post& post, int rank, int count)
      : post_(post), rank_(rank), count_(count) {}
  int rank() const override { return rank_; }
  int count() const override { return count_; }
  void send(int rank, const Bytes& bytes) const override {
    post_.put(rank_, rank, bytes);
  }
  Bytes receive(int rank) const override { return post_.take(rank, rank_); }

 private:
  Post& post_;
  int rank_, count_;
};

/// The process of each tetrahedron, by bands of their numbers (parts) or at random
/// (everything is halo).
inline std::vector<int> owners(int cells, int processes, bool bands,
                               std::mt19937& random) {
  std::vector<int> owner(cells);
  for (int t = 0; t < cells; ++t)
    owner[t] = bands ? static_cast<int>(1.0 * t * processes / cells)
                     : static_cast<int>(random() % processes);
  return owner;
}

/// relax_facets<3> by so many.
inline RelaxFacets<3> relaxed_by(int processes, bool bands, unsigned seed) {
  return [=](const FacetSetting<3>& setting, const RelaxationSettings& settings,
             FaceMoments& moments) {
    std::mt19937 random(seed);
    Post post;
    const MessagesByPost first(post, 0, processes);
    LeadingRelaxation leading(setting, moments,
                              owners(setting.body.topology.mesh.cell_count(),
                                     processes, bands, random),
                              first);
    std::vector<std::thread> others;
    for (int r = 1; r < processes; ++r)
      others.emplace_back([&, r, part = leading.part_of(r)] {
        const MessagesByPost messages(post, r, processes);
        PartRelaxation relaxation(part, messages);
        follow(relaxation, messages, settings);
      });
    leading.prepare();
    const std::vector<double> falls = leading.relax(settings, moments);
    for (std::thread& other : others) other.join();
    return falls;
  };
}

}  // namespace ffcontact::test
