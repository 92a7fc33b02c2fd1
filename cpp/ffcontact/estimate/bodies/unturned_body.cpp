// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/unturned_body.hpp"

#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/estimate/bodies/contact_subset.hpp"

namespace ffcontact {

SolvedBody<2> unturned_body(const SolvedProblem<2>& solved,
                            const UnturnedLine& unturned) {
  const ContactLine &old = solved.contact, &line = unturned.line;
  const Matrix2Xd force = forces_of(old, solved.body.multipliers);
  const VectorXd length = nodal_lengths(line), whole = nodal_lengths(old);
  Matrix2Xd shared(2, line.node_count());
  for (int i = 0; i < line.node_count(); ++i) {
    const int parent = unturned.parent[i];
    shared.col(i) = length[i] / whole[parent] * line.frame(i).transpose() *
                    (old.frame(parent) * force.col(parent));
  }
  SolvedBody<2> body = solved.body;
  body.multipliers =
      consistent_pressures(line, solved.system.prescribed, shared);
  body.law =
      law_of<2>(body.law, {unturned.parent.begin(), unturned.parent.end()});
  return body;
}

}  // namespace ffcontact
