// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/contact_densities.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/mesh/edges.hpp"

namespace ffcontact {

/// The oscillation (facet_oscillation.hpp) of contact tractions along directions that turn:
/// r = r_n n(s) + r_t t(s) of moments_of_ends is quadratic, with what it has beyond linear
///     d = q (6 s^2 - 6 s + 1),   q = ((r_n,i - r_n,j) (n_i - n_j) + (r_t,i - r_t,j) (t_i - t_j)) / 6,
/// int d d' = l q q' / 5, on the triangle of each edge, and turned round on that of the edge
/// that it faces [(N mm)^(1/2) per unit of thickness]; 0 where no direction turns.
/// @param densities  r_hat
double line_oscillation(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const Hooke& hooke,
                        const ContactDensities& densities);

}  // namespace ffcontact
