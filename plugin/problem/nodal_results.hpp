// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// What a solve leaves at the contact nodes of bodies in d dimensions, along n and t, of
/// solids along n, t1, t2 of ContactSurface::frame.
struct NodalResults {
  /// one row a node; columns are pressures [MPa], forces [N/mm, of solids N], the same forces
  /// along x, y (z), on the body that comes first, the opening gap - u_n and the slip
  /// u_t - u_t of the load step before [mm]: nodal_names [p x 4 d]
  MatrixXd values;
  std::vector<long>
      state;  ///< 0 open, 1 stick, 2 slip along t, of solids in any direction, -2 slip against t

  NodalResults() = default;
  NodalResults(Index nodes, int d) : values(nodes, 4 * d) {}

  int dimension() const { return static_cast<int>(values.cols()) / 4; }
  auto pressure() { return values.leftCols(dimension()); }
  auto pressure() const { return values.leftCols(dimension()); }
  auto force() { return values.middleCols(dimension(), dimension()); }
  auto force() const { return values.middleCols(dimension(), dimension()); }
  auto vector() { return values.middleCols(2 * dimension(), dimension()); }
  auto gap() { return values.col(3 * dimension()); }
  auto gap() const { return values.col(3 * dimension()); }
  auto slip() { return values.rightCols(dimension() - 1); }
  auto slip() const { return values.rightCols(dimension() - 1); }
};

/// Names of the columns in scripts: C.pn, ... and the outputs pn=, ... of contactsolve.
template <int d>
inline constexpr std::array<const char*, 4 * d> nodal_names;
template <>
inline constexpr std::array<const char*, 8> nodal_names<2> = {
    "pn", "pt", "fn", "ft", "fx", "fy", "gap", "slip"};
template <>
inline constexpr std::array<const char*, 12> nodal_names<3> = {
    "pn", "pt1", "pt2", "fn",  "ft1",   "ft2",
    "fx", "fy",  "fz",  "gap", "slip1", "slip2"};

/// All names of both.
inline const std::vector<const char*>& all_nodal_names() {
  static const std::vector<const char*> all = [] {
    std::vector<const char*> names(nodal_names<3>.begin(),
                                   nodal_names<3>.end());
    names.insert(names.end(), {"pt", "ft", "slip"});
    return names;
  }();
  return all;
}

/// The column of a name, or -1.
inline int nodal_column(int dimension, const std::string& name) {
  const auto found = [&](const auto& names) {
    const auto at = std::find(names.begin(), names.end(), name);
    return at == names.end() ? -1 : static_cast<int>(at - names.begin());
  };
  return dimension == 2 ? found(nodal_names<2>) : found(nodal_names<3>);
}

}  // namespace ffcontact::plugin
