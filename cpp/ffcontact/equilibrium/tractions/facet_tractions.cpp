// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"

#include <array>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

/// Per label: which components are prescribed at every vertex of every facet that
/// carries it.
template <int d>
using PrescribedLabels = std::map<int, std::array<bool, d>>;

/// @param prescribed  1 where the dof is prescribed [dofs]
template <int d>
PrescribedLabels<d> prescribed_labels(const SimplexMesh<d>& mesh,
                                      const Flags& prescribed) {
  std::array<bool, d> all;
  all.fill(true);
  PrescribedLabels<d> labels;
  for (const int label : mesh.boundary_label) labels[label] = all;
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    for (const int vertex : mesh.boundary.col(f))
      for (int c = 0; c < d; ++c)
        if (!prescribed[dof_of<d>(vertex, c)])
          labels[mesh.boundary_label[f]][c] = false;
  return labels;
}

/// What one boundary facet carries.
/// @param free    components that the support answers
/// @param column  of SimplexMesh::boundary
template <int d>
void put_facet(const SimplexMesh<d>& mesh, const Facets<d>& facets, int facet,
               int column, const std::array<bool, d>& free,
               const Ref<const FacetColumns<d>>& neumann,
               FacetTractions<d>& given) {
  for (int k = 0; k < d; ++k) {
    const int place = facets.place_of(mesh.boundary(k, column), facet);
    for (int c = 0; c < d; ++c) {
      given.known(c, facet) = !free[c];
      if (!free[c])
        given.moments(d * place + c, facet) = neumann(d * k + c, column);
    }
  }
}

}  // namespace

template <int d>
FacetTractions<d> given_tractions(const SimplexMesh<d>& mesh,
                                  const Facets<d>& facets,
                                  const Flags& prescribed,
                                  const Ref<const FacetColumns<d>>& neumann) {
  require_size("prescribed dofs", static_cast<Index>(prescribed.size()),
               d * mesh.vertices.cols());
  require_size("tractions", neumann.cols(), mesh.boundary.cols());
  require_finite("traction", neumann.reshaped());
  const PrescribedLabels<d> labels = prescribed_labels(mesh, prescribed);
  FacetTractions<d> given;
  given.known.setConstant(d, facets.count(), false);
  given.moments.setZero(d * d, facets.count());
  for (int f = 0; f < facets.count(); ++f) {
    if (!facets.on_boundary(f)) continue;
    const int column = facets.boundary_index[f];
    put_facet<d>(
        mesh, facets, f, column,
        entry_of(labels, mesh.boundary_label[column], "facet with a label"),
        neumann, given);
  }
  return given;
}

template FacetTractions<FFCONTACT_DIMENSION> given_tractions(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Facets<FFCONTACT_DIMENSION>&,
    const Flags&, const Ref<const FacetColumns<FFCONTACT_DIMENSION>>&);

}  // namespace ffcontact
