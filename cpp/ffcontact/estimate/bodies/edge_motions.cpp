// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/edge_motions.hpp"

namespace ffcontact {

LineMotions::LineMotions(const ContactLine& line, const ContactLaw<2>& law,
                         const Ref<const VectorXd>& displacement)
    : line_(line),
      at_nodes_(displacement_against_foundation(line, law, displacement)),
      given_(Matrix2Xd::Zero(2, line.node_count())) {
  if (law.gap.size() > 0) given_.row(0) = law.gap;
  if (law.previous.size() > 0) given_.row(1) = law.previous;
}

EdgeMotions LineMotions::on(int edge) const {
  const int i = line_.edge_node(0, edge), j = line_.edge_node(1, edge);
  Vector2d middle = (at(i) + at(j)) / 2;
  if (turns(line_, edge)) {
    const Matrix2d turn = line_.frame(j).transpose() * line_.frame(i);
    const Vector2d wi = at(i) + given_.col(i), wj = at(j) + given_.col(j);
    middle =
        (turn * wi + turn.transpose() * wj - given_.col(i) - given_.col(j)) / 2;
  }
  return {{at(i)[0], middle[0], at(j)[0]}, {at(i)[1], middle[1], at(j)[1]}};
}

}  // namespace ffcontact
