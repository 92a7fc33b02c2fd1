// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/forces_of_matrix.hpp"
#include "ffcontact/estimate/checks/law_of_matrix.hpp"

namespace ffcontact {

void require_law_of_matrix(const SolidMesh& mesh, const ElasticSystem& system,
                           const HookeTensors<3>& hooke) {
  const auto nothing_else = [](const Comparison&, Index) {};
  require_forces_of_matrix<3>(
      mesh, system,
      [&](const VectorXd& u) { return forces_of_law<3>(mesh, hooke, u); },
      nothing_else);
}

}  // namespace ffcontact
