// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// The dofs of [P1, P1] on the meshes of plane bodies, or of [P1, P1, P1] on those of
/// solids, one body after the other.
class BodyDofs {
 public:
  /// @param first_vertex  of each body, and the total at the end [bodies + 1]
  BodyDofs(int dimension, std::vector<int> first_vertex)
      : dimension_(dimension), first_vertex_(std::move(first_vertex)) {}

  int dimension() const { return dimension_; }
  int body_count() const { return static_cast<int>(first_vertex_.size()) - 1; }
  Index first_dof(int body) const { return dimension_ * first_vertex_[body]; }
  Index dof_count(int body) const {
    return first_dof(body + 1) - first_dof(body);
  }
  Index dof_count() const { return first_dof(body_count()); }

  /// @throws std::invalid_argument  if `count` is not the number of dofs of a body
  void require_dofs(const char* name, int body, Index count) const;

  /// @throws std::invalid_argument  if what a function takes of each body is not given
  ///                                for all of them
  void require_bodies(const char* names, std::size_t count) const;

 private:
  int dimension_;
  std::vector<int> first_vertex_;
};

}  // namespace ffcontact::plugin
