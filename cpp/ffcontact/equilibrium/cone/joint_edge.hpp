// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/energy/facet_forms.hpp"
#include "ffcontact/equilibrium/tractions/contact_face.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// Edges of several bodies that lie on each other in matching contact faces, as one.
///
/// The corrections of the faces around it are those of ridge_form: one wrench w that goes
/// around through all bodies, and three modes of each face, which a contact face and the
/// one that it faces have in common, in opposite directions,
///     x = (w, y_1, .., y_M) [6 + 3 M],   x_e = sign_e . x(place_e) of the faces around edge e.
/// Wrenches are about the middle of each edge: bodies that are apart feel them alike. An
/// edge of one body alone is one part.
struct JointEdge {
  struct Part {
    int edge;
    VectorXi place;  ///< [6 + 3 m]
    VectorXd sign;   ///< [6 + 3 m]

    VectorXd of(const VectorXd& x) const { return sign.cwiseProduct(x(place)); }
  };
  std::vector<Part> parts;  ///< their edges ascending
  int size = 0;             ///< 6 + 3 M
};

/// The edges of contact faces, in the order of their middles, whatever their numbers.
std::vector<JointEdge> joint_edges(const Topology<3>& topology,
                                   const std::vector<ContactFace>& contact);

/// A = sum over the parts of Z' H Z.
MatrixXd joint_form(const Topology<3>& topology, const JointEdge& joint,
                    const FacetForms<3>& forms);

/// ridge_conditions of all parts.
MatrixXd joint_conditions(const Topology<3>& topology, const JointEdge& joint,
                          const KnownComponents& known);

/// Z' g, the sum over the parts.
VectorXd joint_restricted(const Topology<3>& topology, const JointEdge& joint,
                          const Matrix9Xd& g);

}  // namespace ffcontact
