// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"
#include "ffcontact/equilibrium/tractions/facet_term.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"

namespace ffcontact {

/// A facet whose springs answer what relaxation asks of them.
template <int d>
struct FreeSpring {
  int facet;             ///< of the mesh
  MatrixOf<d> answers;   ///< projector on the directions that are free
  SpringError<d> error;  ///< by the changes of the facet's moments
};

/// Spring tractions that take part in the relaxation: on facets without contact, in the
/// directions that springs answer and no support does. Where springs are inclined to a
/// support on the same facet they stay as they are.
/// @param boundary      all given and spring tractions
/// @param displacement  u_hat
/// @param tractions     moments of the springs' tractions [d^2 x SimplexMesh::boundary]
template <int d>
std::vector<FreeSpring<d>> free_springs(const SimplexMesh<d>& mesh,
                                        const Facets<d>& facets,
                                        const BoundarySprings<d>& springs,
                                        const FacetTractions<d>& boundary,
                                        const Ref<const VectorXd>& displacement,
                                        const FacetColumns<d>& tractions);

/// The boundary tractions without those that the springs may change.
template <int d>
FacetTractions<d> released(FacetTractions<d> boundary,
                           const std::vector<FreeSpring<d>>& springs);

/// The springs' error by the moments of their facets.
template <int d>
std::vector<FacetTerm<d>> terms_of(const std::vector<FreeSpring<d>>& springs) {
  std::vector<FacetTerm<d>> terms;
  for (const auto& [facet, answers, error] : springs)
    terms.push_back({facet, error.H, error.g, error.before});
  return terms;
}

/// Adds to the springs' tractions what the relaxation has changed them by, in the
/// directions that are free.
/// @param boundary   tractions before
/// @param moments    of sigma_hat on all facets
/// @param tractions  [d^2 x SimplexMesh::boundary]
template <int d>
void add_spring_changes(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                        const std::vector<FreeSpring<d>>& springs,
                        const FacetTractions<d>& boundary,
                        const FacetColumns<d>& moments,
                        FacetColumns<d>& tractions);

}  // namespace ffcontact
