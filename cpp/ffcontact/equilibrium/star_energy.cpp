// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_energy.hpp"

#include <Eigen/LU>

namespace ffcontact {

StarSetting star_setting(const Topology& topology, const Hooke& hooke,
                         const BoundaryTractions& boundary,
                         const BodyLoadsOfAll& body_loads,
                         const EdgeLoadsOfAll& difference) {
  const auto& [mesh, edges, stars] = topology;
  const int triangles = topology.mesh.cell_count();
  // Not a vector, which would be filled with zeros by one thread first.
  StarSetting setting{AirySpace(mesh, edges), stars, boundary,
                      std::unique_ptr<AiryEnergy[]>(new AiryEnergy[triangles])};
#pragma omp parallel for
  for (int t = 0; t < triangles; ++t)
    setting.energies[t] = airy_energy(setting.space, t, hooke[t].inverse(),
                                      difference.col(t), body_loads.col(t));
  return setting;
}

}  // namespace ffcontact
