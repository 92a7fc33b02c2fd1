// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/unheld_bodies.hpp"

#include <string>

#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/dense/singular_values.hpp"

namespace ffcontact {

template <int dim>
void refuse_unheld(const SimplexMesh<dim>& mesh, const MatrixXd& motions,
                   const MatrixXd& traces) {
  const std::string glued =
      "the bodies are not held, even with their contact sides glued to each "
      "other";
  if (motions.cols() == 0) throw Failure(glued);
  const SingularValues apart = singular_values(traces);
  const VectorXd together =
      product(motions, apart.V.rightCols(1));  // the least apart
  throw Failure(glued + ": prescribe displacements that stop their " +
                motion_in_words(mesh, together));
}

template void refuse_unheld(const SimplexMesh<FFCONTACT_DIMENSION>&,
                            const MatrixXd&, const MatrixXd&);

}  // namespace ffcontact
