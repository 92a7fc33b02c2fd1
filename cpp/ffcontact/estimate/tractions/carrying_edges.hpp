// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/law/contact_densities.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// What the first r_hat may be on an edge.
enum class Carrying : char {
  any,            ///< all of the cone
  slip_forward,   ///< r_t = -mu |r_n|, as all of the edge slips along +t
  slip_backward,  ///< r_t = mu |r_n|
  nothing,        ///< r_n = 0, and r_t = 0 where friction asks for contact
};

/// A traction of size |r| on an edge of length l changes e^2 by about |r|^2 l^2 / |C|, on a
/// part of it by that part of it, and costs in its contact part 2 l int (c |w_t| + r_t . w_t + r_n (w_n - gap)) per |r|. Where
/// the latter is far larger for tractions as large as the largest of the first r_hat,
///     mean of c |w_t| + r_t w_t + r_n (w_n - gap)  >  10 (l / |C|) |r_max| |r|,
/// no gain pays for it, nor above 3 of these where other edges, which cost less, have the ends
/// with tractions: they carry them. By the two directions d = (-1, +-mu) that span Coulomb's cone: an
/// edge on which both cost as much carries nothing (open, far from contact), one where
/// one does, and w_t has one sign, carries the other alone, r_t = -+mu |r_n| exactly (slip
/// that is large beside strains times l), and others are free. Tresca's bound has no such
/// directions: an edge that is open as far has r_n = 0.
///
/// r_hat is in the cone in any case, so that e remains a bound.
/// @param displacement  u_hat on all dofs [mm]
/// @param stiffness     |C| / l beside each edge [MPa/mm, m], l the length of the solved edge that
///                      it is a part of
/// @param traction      r_hat at the nodes [MPa, 2 x p]
std::vector<Carrying> carrying_edges(const ContactLine& line,
                                     const ContactLaw<2>& law,
                                     const Ref<const VectorXd>& displacement,
                                     const Ref<const VectorXd>& stiffness,
                                     const Ref<const Matrix2Xd>& traction);

}  // namespace ffcontact
