// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/labelled_facets.hpp"

#include <algorithm>
#include <set>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

template <int dim>
[[noreturn]] void refuse_label(const SimplexMesh<dim>& mesh, int label) {
  using Words = MeshWords<dim>;
  const auto& all = mesh.boundary_label;
  if (std::find(all.begin(), all.end(), label) == all.end())
    refuse("label ", label, " is on no boundary ", Words::facet,
           " of the mesh");
  refuse("label ", label, " is on ", Words::facet,
         "s inside the body alone: if bodies touch there, their vertices were "
         "taken for the same, as FreeFEM's trunc and + do; take the mesh as "
         "gmshmesh reads it, or one mesh a body");
}

}  // namespace

template <int dim>
std::vector<int> labelled_facets(const SimplexMesh<dim>& mesh,
                                 const Facets<dim>& facets,
                                 const std::vector<int>& labels) {
  std::vector<int> found;
  std::set<int> used;
  for (int f = 0; f < facets.count(); ++f) {
    if (!facets.on_boundary(f)) continue;
    const int label = mesh.boundary_label[facets.boundary_index[f]];
    if (std::find(labels.begin(), labels.end(), label) == labels.end())
      continue;
    found.push_back(f);
    used.insert(label);
  }
  for (int label : labels)
    if (!used.count(label)) refuse_label(mesh, label);
  return found;
}

template std::vector<int> labelled_facets(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Facets<FFCONTACT_DIMENSION>&,
    const std::vector<int>&);

}  // namespace ffcontact
