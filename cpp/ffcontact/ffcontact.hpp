// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// ffcontact: frictional contact in two dimensions by mixed finite elements, with an
/// error estimate from admissible fields and the mesh sizes that reach a wanted error.
///
/// Source: [CHH01] P. Coorevits, P. Hild, M. Hjiaj, A posteriori error control of finite
/// element approximations for Coulomb's frictional contact, SIAM J. Sci. Comput. 23(3),
/// 2001. Equation numbers in the headers are its own.
///
/// Modules, each using only those before it:
///   base         refusals, lists, sums
///   linear       linear algebra, dense and sparse, small quadratic problems
///   mesh         triangles and tetrahedra, their facets (edges, faces) and ridges, stars, several bodies as one joined mesh,
///                boundary parts and curves; the planes, smooth surfaces and curves of a solid; a rectangle; other cells split
///   elastic      numbering of dofs, Hooke's law, the linear system with its prescribed dofs, rigid motions, condensation on a
///                few dofs; as meshes and facets for plane bodies and solids
///   interface    the contact line, facing traces, their common refinement; the contact surface of a solid
///   contact      the laws of contact and friction, the solver, tractions brought into the cone, the constant of Coulomb's law
///                and the coefficient at which solutions branch; the law and the solver on a surface
///   equilibrium  edge tractions in equilibrium, stresses linear on triangles, the composite stress, star relaxation
///   estimate     the error in the constitutive relation of an admissible pair
///   bounds       strict bounds of quantities of interest
///   sizing       optimal sizes for a wanted error, of plane bodies and solids
///   parallel     what several processes need
///
/// Units: mm, N, MPa; plane problems of thickness 1 mm. Signs: n outward, t = (-n2, n1)
/// (of solids ContactSurface::frame), compression negative, u_n <= 0 does not penetrate.
#include "ffcontact/bounds/quantity_bounds.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/contact/uniqueness/coulomb_constant.hpp"
#include "ffcontact/contact/uniqueness/critical_friction.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/elastic/loads_and_supports.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/estimate/stress_on_triangles.hpp"
#include "ffcontact/interface/joined_contact.hpp"
#include "ffcontact/interface/line_ends.hpp"
#include "ffcontact/interface/pairing/facing_line.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "ffcontact/mesh/rectangle.hpp"
#include "ffcontact/sizing/local_rates.hpp"
#include "ffcontact/sizing/optimal_size.hpp"
