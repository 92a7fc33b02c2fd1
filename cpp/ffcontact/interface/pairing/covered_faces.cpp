// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/covered_faces.hpp"

#include <algorithm>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

namespace {

/// Parts of a face below this are rounding.
constexpr double nothing_left = 1e-9;

bool is_whole(double share) { return share > 1 - nothing_left; }

}  // namespace

void CoveredFaces::add(int face, const Ref<const Matrix3Xd>& place) {
  share_[face] += share_of(place);
}

bool CoveredFaces::covers(int face) const {
  return is_whole(entry_of(share_, face, "share of a face"));
}

bool CoveredFaces::covers_all() const {
  return std::all_of(share_.begin(), share_.end(),
                     [](const auto& face) { return is_whole(face.second); });
}

}  // namespace ffcontact
