// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/interface/pairing/facing_polygons.hpp"

namespace ffcontact {

/// A contact surface against another body.
struct FacingSurface {
  ContactSurface surface;
  VectorXd gap;  ///< (1/A_i) int psi_i s, s the distance along n [mm, p]
};

/// The part of a surface that faces another body, and how it is coupled to that
/// [Wohlmuth 2000; Popp, Wohlmuth, Gee, Wall 2012].
///
/// On each face chi are the hats phi of its corners, of what is faced alone; psi are
/// their dual functions there,
///     psi = diag(int chi) (int chi chi')^-1 chi,   int psi_i chi_k = delta_ik int chi_i,   sum psi_i = 1,
/// so that F_i, the force of the node i alone on its own body, is A_i times the
/// coefficient of psi_i in a traction that both bodies feel, and
///     v_i = 1/A_i int psi_i [u],   A_i = int psi_i,
/// is exact on the common refinement for any mesh of either body: a uniform pressure and
/// a displacement linear in x pass as they are.
///
/// Where the other body ends within a face, corners whose hat does not reach 1/2 on what
/// is faced carry no multiplier, and give their hat to the others; so do those without
/// which the others are all but dependent there, and vertices of both bodies, as at the
/// front of a crack, where the jump is 0 by itself. Nodes that carry none are left out,
/// faces that face less than 1e-6 of their area too.
/// @param glued  1 at vertices of which another multiplier holds the jump; none: nowhere
FacingSurface facing_surface(const SolidMesh& mesh, const Facets<3>& faces,
                             const ContactSurface& surface,
                             const std::vector<FacingPolygon>& polygons,
                             const Flags& glued = {});

}  // namespace ffcontact
