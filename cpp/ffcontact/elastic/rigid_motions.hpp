// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Basis of the rigid motions that no prescribed dof stops, one column each [2 * vertices
/// x k], k = 0 to 3 per connected part. A motion (a + w (c_y - y), b + w (x - c_x)) about
/// the part's centre c is scaled to a largest displacement of about 1.
/// @param prescribed  1 where the dof is prescribed [2 * vertices]
MatrixXd free_rigid_motions(const Mesh& mesh, const std::vector<char>& prescribed);

/// "translation along (0, 1)" or "rotation about (10, 5)": a rigid motion in words.
/// @param motion  a combination of columns of free_rigid_motions [2 * vertices]
std::string motion_in_words(const Mesh& mesh, const Ref<const VectorXd>& motion);

}  // namespace ffcontact
