// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_energy.hpp"

#include <Eigen/LU>

namespace ffcontact {

StarSetting star_setting(const Mesh& mesh, const Edges& edges, const Stars& stars,
                         const Hooke& hooke, const BoundaryTractions& boundary,
                         const BodyLoadsOfAll& body_loads,
                         const EdgeLoadsOfAll& difference) {
  // Not a vector, which would be filled with zeros by one thread first.
  StarSetting setting{AirySpace(mesh, edges), stars, boundary,
                      std::unique_ptr<AiryEnergy[]>(new AiryEnergy[mesh.cell_count()])};
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t)
    setting.energies[t] = airy_energy(setting.space, t, hooke[t].inverse(),
                                      difference.col(t), body_loads.col(t));
  return setting;
}

}  // namespace ffcontact
