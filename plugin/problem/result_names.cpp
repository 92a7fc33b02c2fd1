// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/result_names.hpp"

#include "ffcontact/base/require.hpp"
//
#include "problem/nodal_results.hpp"

namespace ffcontact::plugin {

void require_plane_results(const NamedArguments& named) {
  for (const NodalArray& array : nodal_arrays)
    if (!array.plane && named.given(array.name)) refuse_result_of_solids();
}

void require_solid_results(const NamedArguments& named) {
  for (const NodalArray& array : nodal_arrays)
    if (!array.solid && named.given(array.name))
      refuse_result_of_plane_bodies();
  if (named.given("abscissa")) refuse_result_of_plane_bodies();
}

void refuse_result_of_solids() {
  refuse(
      "the contact is that of plane bodies: pt, ft, slip are in place of pt1, "
      "pt2, ft1, ft2, slip1, slip2, and fz, nz are of a mesh3");
}

void refuse_result_of_plane_bodies() {
  refuse(
      "the contact is that of a mesh3: pt1, pt2, ft1, ft2, slip1, slip2 are in "
      "place of pt, ft, slip, and there is no abscissa");
}

void refuse_unsolved() {
  refuse("the contact is not solved: call contactsolve first");
}

}  // namespace ffcontact::plugin
