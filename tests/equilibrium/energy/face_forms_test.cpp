// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "ffcontact/equilibrium/energy/facet_forms.hpp"
#include "support/balanced_unknowns.hpp"
#include "support/relaxed_solid.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Products of two balanced corrections are those of the whole form, and of its blocks.
RC_GTEST_PROP(FacetForms, are_the_energy_of_balanced_corrections,
              (Random random)) {
  const LoadedSolid solid = any_solid(random);
  const Topology<3>& topology = solid.topology;
  const FacetForms<3> forms(topology, solid.hooke);
  for (int t = 0; t < topology.mesh.cell_count(); t += 5) {
    const CellForm<3> H =
        facet_energy<3>(corners_of(topology.mesh, t), solid.hooke[t].inverse(),
                        wrench_bases<3>(topology, t));
    const CellVector<3> x = balanced_unknowns(topology, t, t % 4, random),
                        y = balanced_unknowns(topology, t, (t + 1) % 4, random),
                        image = forms.times(t, x);
    const double scale = std::sqrt(x.dot(H * x) * y.dot(H * y));
    RC_ASSERT(std::abs(y.dot(image) - y.dot(H * x)) < 1e-4 * scale);
    CellVector<3> by_blocks = CellVector<3>::Zero();
    for (int k = 0; k < 4; ++k)
      for (int l = 0; l < 4; ++l)
        by_blocks.segment<9>(9 * k) +=
            forms.block(t, k, l).cast<double>() * x.segment<9>(9 * l);
    RC_ASSERT((by_blocks - image).norm() <= 1e-12 * image.norm());
  }
}

}  // namespace
}  // namespace ffcontact
