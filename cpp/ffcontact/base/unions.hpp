// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace ffcontact {

/// Sets that are joined pair by pair; the root of a set is its lowest member.
class Unions {
 public:
  explicit Unions(int count) : above_(count) {
    std::iota(above_.begin(), above_.end(), 0);
  }
  int root(int k) {
    while (above_[k] != k) k = above_[k] = above_[above_[k]];
    return k;
  }
  void join(int a, int b) {
    a = root(a), b = root(b);
    above_[std::max(a, b)] = std::min(a, b);
  }
  /// The sets numbered from 0 on in the order of their roots, for each member.
  std::vector<int> numbers() {
    std::vector<int> number(above_.size());
    int next = 0;
    for (int k = 0; k < static_cast<int>(above_.size()); ++k)
      number[k] = root(k) == k ? next++ : number[root(k)];
    return number;
  }
  /// The sets that some members are of, without others, each by its root.
  std::map<int, std::set<int>> sets_of(const std::vector<int>& members) {
    std::map<int, std::set<int>> sets;
    for (int k : members) sets[root(k)].insert(k);
    return sets;
  }

 private:
  std::vector<int> above_;
};

}  // namespace ffcontact
