// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/solved_body.hpp"

namespace ffcontact {

LinearStresses total_stresses(const Mesh& mesh, const SolvedBody& body,
                              const Ref<const VectorXd>& displacement) {
  return LinearStresses(stresses(mesh, body.hooke, displacement)) +
         body.initial;
}

}  // namespace ffcontact
