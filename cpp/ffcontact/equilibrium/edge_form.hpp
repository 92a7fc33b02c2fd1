// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/face_forms.hpp"
#include "ffcontact/equilibrium/face_tractions.hpp"

namespace ffcontact {

/// The self-equilibrated corrections of the m faces around an edge: one wrench w that all
/// of them carry and three bars on each, x = (w, y_1, .., y_m) [6 + 3 m], which WrenchShift
/// makes the unknowns of the faces, Z x.
int unknowns_around(const Hinges<3>& edges, int edge);

/// The m faces.
std::vector<int> faces_around(const Hinges<3>& edges, int edge);

/// A tetrahedron at an edge with its two faces there.
struct Wedge {
  int cell;
  int place[2];  ///< among the faces around the edge
  int local[2];  ///< among those of the tetrahedron
};
std::vector<Wedge> wedges_of(const SolidTopology& topology, int edge);

/// A = Z' H Z, their energy.
MatrixXd edge_form(const SolidTopology& topology, int edge,
                   const FaceForms& forms);

/// Rows that are zero for corrections that leave known boundary tractions alone.
MatrixXd edge_conditions(const SolidTopology& topology, int edge,
                         const KnownComponents& known);

/// Z' g
VectorXd restricted(const SolidTopology& topology, int edge,
                    const Matrix9Xd& g);

/// Z x of the face at a place among those around the edge: its wrench and its bars.
Vector9d at_place(const SolidTopology& topology, int edge, int place,
                  const VectorXd& x);

}  // namespace ffcontact
