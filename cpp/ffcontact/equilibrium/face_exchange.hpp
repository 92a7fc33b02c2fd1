// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Loads, slopes or energies by the four faces of each tetrahedron [36 x tetrahedra].
using FaceImages = Matrix<double, 36, Dynamic>;

/// How descents on the shares of one solid go together.
class FaceExchange {
 public:
  virtual ~FaceExchange() = default;
  /// Over all shares, with the same digits on each.
  virtual double sum(double of_share) const = 0;
  /// Columns of the halo become those of whose own tetrahedra they are.
  virtual void complete(FaceImages& images) const = 0;
};

/// Of a share that is all.
class NoExchange : public FaceExchange {
 public:
  double sum(double of_share) const override { return of_share; }
  void complete(FaceImages&) const override {}
};

}  // namespace ffcontact
