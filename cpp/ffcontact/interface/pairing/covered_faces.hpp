// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// The faces of one side of polygons of a common refinement, and the shares of their areas
/// that these have.
class CoveredFaces {
 public:
  /// @param place  of the corners of a polygon on the face, barycentric [3 x k]
  void add(int face, const Ref<const Matrix3Xd>& place);
  int count() const { return static_cast<int>(share_.size()); }
  /// Do the polygons have all of the face, of all faces?
  bool covers(int face) const;
  bool covers_all() const;

 private:
  std::map<int, double> share_;
};

}  // namespace ffcontact
