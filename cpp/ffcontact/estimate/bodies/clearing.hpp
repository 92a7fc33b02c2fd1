// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// Has a vertex a free component along a normal?
/// @param prescribed  1 where the dof is prescribed [dofs]
bool is_free_along(int vertex, const Vector3d& normal, const Flags& prescribed);

/// How far a vertex moves to come clear at most [mm]: 1000 times the largest displacement
/// or gap.
double largest_clearing(const ContactLaw<3>& law,
                        const Ref<const VectorXd>& displacement);

/// The smallest change of the free components of a vertex that moves it along each of the
/// directions `away` by at least `deep` [mm]; 0 if there is none that is not above
/// `largest`, or none is needed.
Vector3d clearing(int vertex, const Ref<const Matrix3Xd>& away,
                  const VectorXd& deep, const Flags& prescribed,
                  double largest);

}  // namespace ffcontact
