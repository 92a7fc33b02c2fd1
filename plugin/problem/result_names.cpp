// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/result_names.hpp"

#include "ffcontact/base/require.hpp"
//
#include "problem/nodal_results.hpp"

namespace ffcontact::plugin {

void require_results_of(int dimension, const NamedArguments& named) {
  for (const char* name : all_nodal_names())
    if (named.given(name) && nodal_column(dimension, name) < 0)
      refuse_result_of_others(dimension);
  if (dimension == 3 && named.given("abscissa"))
    refuse_result_of_others(dimension);
}

void refuse_result_of_others(int dimension) {
  if (dimension == 2)
    refuse(
        "the contact is that of plane bodies: pt, ft, slip are in place of "
        "pt1, pt2, ft1, ft2, slip1, slip2, and fz, nz are of a mesh3");
  refuse(
      "the contact is that of a mesh3: pt1, pt2, ft1, ft2, slip1, slip2 are in "
      "place of pt, ft, slip, and there is no abscissa");
}

void refuse_unsolved() {
  refuse("the contact is not solved: call contactsolve first");
}

}  // namespace ffcontact::plugin
