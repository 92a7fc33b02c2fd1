// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/estimate/admissible_tractions.hpp"
#include "ffcontact/mesh/stars.hpp"

namespace ffcontact {

/// Consecutive edges of the contact line, first to last.
struct LineWindow {
  int first, last;
  int count() const { return last - first + 1; }
};

/// Contact tractions in the cone that differ from those of the solver in a few places
/// only.
///
/// As AdmissibleTractions, but where (4.1) finds no answer the densities of a window of
/// edges, the edge itself and some neighbours, are those in the cone nearest to lambda_h
/// in L2 with the same force and the same moment:
///     min sum over the window of int |r - lambda_h|^2,   int r = int lambda_h,   int x cross r = int x cross lambda_h.
/// The change of the nodal forces is then in equilibrium by itself, and so are stresses
/// in the triangles near the window that balance it: no system of the whole body has to
/// be solved again.
struct LocalMending {
  AdmissibleTractions tractions;
  std::vector<LineWindow> windows;  ///< apart from each other
};

/// @return nothing if no window of at most 16 edges around one of the edges has such
///         tractions
std::optional<LocalMending> mend_locally(const Mesh& mesh, const ContactLine& line,
                                         const ContactLaw& law,
                                         const ContactDensities& computed);

/// Adds to the stresses of u_h those that balance the windows' change of forces: of the
/// displacement u on the triangles within three layers of a window with K u = change of
/// the nodal forces, free of any support.
/// @param stress  Voigt, per triangle [MPa]
void add_balancing_stresses(const Mesh& mesh, const Stars& stars, const Hooke& hooke,
                            const ContactLine& line, const ContactDensities& computed,
                            const LocalMending& mending, Matrix3Xd& stress);

}  // namespace ffcontact
