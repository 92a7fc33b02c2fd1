// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// What a solve leaves at the contact nodes; the script reads them as C.pn, C.pt, ...
struct NodalResults {
  VectorXd pn, pt;  ///< pressures [MPa]
  VectorXd fn, ft;  ///< forces [N/mm]
  /// the same forces along x, y, on the body that comes first [N/mm]
  VectorXd fx, fy;
  VectorXd gap;   ///< opening, gap - u_n [mm]
  VectorXd slip;  ///< u_t - u_t of the load step before [mm]
  std::vector<long>
      state;  ///< 0 open, 1 stick, 2 slip along t, -2 slip against t
};

/// What a solve leaves at the contact nodes of solids, along n, t1, t2 of
/// ContactSurface::frame; the script reads them as C.pn, C.pt1, ...
struct SolidResults {
  VectorXd pn, pt1, pt2;    ///< pressures, forces over areas [MPa]
  VectorXd fn, ft1, ft2;    ///< forces [N]
  VectorXd fx, fy, fz;      ///< the same forces along x, y, z [N]
  VectorXd gap;             ///< opening, gap - u_n [mm]
  VectorXd slip1, slip2;    ///< u_t - u_t of the load step before [mm]
  std::vector<long> state;  ///< 0 open, 1 stick, 2 slip
};

/// Their arrays but for the states.
inline constexpr std::array arrays_of_plane_bodies = {
    &NodalResults::pn,  &NodalResults::pt,  &NodalResults::fn,
    &NodalResults::ft,  &NodalResults::fx,  &NodalResults::fy,
    &NodalResults::gap, &NodalResults::slip};
inline constexpr std::array arrays_of_solids = {
    &SolidResults::pn,  &SolidResults::pt1,   &SolidResults::pt2,
    &SolidResults::fn,  &SolidResults::ft1,   &SolidResults::ft2,
    &SolidResults::fx,  &SolidResults::fy,    &SolidResults::fz,
    &SolidResults::gap, &SolidResults::slip1, &SolidResults::slip2};

}  // namespace ffcontact::plugin
