// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// What a solve leaves at the contact nodes.
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
/// ContactSurface::frame.
struct SolidResults {
  VectorXd pn, pt1, pt2;    ///< pressures, forces over areas [MPa]
  VectorXd fn, ft1, ft2;    ///< forces [N]
  VectorXd fx, fy, fz;      ///< the same forces along x, y, z [N]
  VectorXd gap;             ///< opening, gap - u_n [mm]
  VectorXd slip1, slip2;    ///< u_t - u_t of the load step before [mm]
  std::vector<long> state;  ///< 0 open, 1 stick, 2 slip
};

/// An array of theirs by its name in scripts; null where plane bodies or solids have none.
struct NodalArray {
  const char* name;
  VectorXd NodalResults::*plane;
  VectorXd SolidResults::*solid;

  template <class Results>
  auto* in(Results& results) const {
    if constexpr (std::is_same_v<std::remove_const_t<Results>, NodalResults>)
      return plane ? &(results.*plane) : nullptr;
    else
      return solid ? &(results.*solid) : nullptr;
  }
};

/// All of them: C.pn, ... and the outputs pn=, ... of contactsolve.
inline constexpr std::array<NodalArray, 15> nodal_arrays = {{
    {"pn", &NodalResults::pn, &SolidResults::pn},
    {"pt", &NodalResults::pt, nullptr},
    {"pt1", nullptr, &SolidResults::pt1},
    {"pt2", nullptr, &SolidResults::pt2},
    {"fn", &NodalResults::fn, &SolidResults::fn},
    {"ft", &NodalResults::ft, nullptr},
    {"ft1", nullptr, &SolidResults::ft1},
    {"ft2", nullptr, &SolidResults::ft2},
    {"fx", &NodalResults::fx, &SolidResults::fx},
    {"fy", &NodalResults::fy, &SolidResults::fy},
    {"fz", nullptr, &SolidResults::fz},
    {"gap", &NodalResults::gap, &SolidResults::gap},
    {"slip", &NodalResults::slip, nullptr},
    {"slip1", nullptr, &SolidResults::slip1},
    {"slip2", nullptr, &SolidResults::slip2},
}};

}  // namespace ffcontact::plugin
