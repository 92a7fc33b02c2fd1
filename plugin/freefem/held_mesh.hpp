// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>
#include <vector>

#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

/// FreeFEM's mesh of a plane body or a solid.
template <int d>
using FemMesh = std::conditional_t<d == 2, Fem2D::Mesh, Fem2D::Mesh3>;
template <int d>
using FemMeshes = std::vector<const FemMesh<d>*>;

/// A mesh of FreeFEM that stays as long as this does, also when the script changes its
/// variable.
template <int d>
class HeldMesh {
 public:
  explicit HeldMesh(const FemMesh<d>* mesh) : mesh_(mesh) {
    mesh_->increment();
  }
  HeldMesh(const HeldMesh& other) : HeldMesh(other.mesh_) {}
  HeldMesh& operator=(const HeldMesh&) = delete;
  ~HeldMesh() { mesh_->destroy(); }
  const FemMesh<d>& operator*() const { return *mesh_; }

 private:
  const FemMesh<d>* mesh_;
};

}  // namespace ffcontact::plugin
