// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/stress_terms.hpp"

#include <algorithm>

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

template <int dim>
double largest_stress_terms(const SimplexMesh<dim>& mesh,
                            const HookeTensors<dim>& hooke,
                            const VectorXd& displacement) {
  double largest = 0;
#pragma omp parallel for reduction(max : largest)
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const auto gradients = hat_gradients(mesh, t);
    double strain = 0;
    for (int k = 0; k <= dim; ++k)
      strain += gradients.col(k).norm() *
                vector_at<dim>(displacement, mesh.cells(k, t)).norm();
    largest = std::max(largest, max_norm(hooke[t]) * strain);
  }
  return largest;
}

template double largest_stress_terms(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                     const HookeTensors<FFCONTACT_DIMENSION>&,
                                     const VectorXd&);

}  // namespace ffcontact
