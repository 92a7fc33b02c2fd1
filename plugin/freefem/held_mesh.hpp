// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

/// A mesh of FreeFEM that stays as long as this does, also when the script changes its
/// variable.
template <class FemMesh>
class HeldMesh {
 public:
  explicit HeldMesh(const FemMesh* mesh) : mesh_(mesh) { mesh_->increment(); }
  HeldMesh(const HeldMesh& other) : HeldMesh(other.mesh_) {}
  HeldMesh& operator=(const HeldMesh&) = delete;
  ~HeldMesh() { mesh_->destroy(); }
  const FemMesh& operator*() const { return *mesh_; }

 private:
  const FemMesh* mesh_;
};

}  // namespace ffcontact::plugin
