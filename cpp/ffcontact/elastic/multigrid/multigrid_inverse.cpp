// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/multigrid_inverse.hpp"

#include <memory>

#include "ffcontact/elastic/multigrid/body_grid.hpp"
#include "ffcontact/elastic/multigrid/row_product.hpp"
#include "ffcontact/elastic/multigrid/smoothed_aggregation.hpp"
#include "ffcontact/linear/iterative/conjugate_gradients.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

// one solve is then enough where what is left is balanced otherwise (sweep_to_roots)
constexpr ConjugateGradientLimits limits{1e-6, 150};

}  // namespace

LinearMap multigrid_inverse(const ElasticSystem& system,
                            const Matrix3Xd& vertices) {
  const auto multigrid = std::make_shared<const SmoothedAggregation<3>>(
      body_grid<3>(system, vertices, VertexFrames<3>(system)));
  const LinearMap K = [&system](const VectorXd& u) {
    return on_free_dofs(system, row_product(system.stiffness, u));
  };
  const LinearMap M = [multigrid](const VectorXd& r) -> VectorXd {
    // single numbers have no room for some units
    const double size = max_norm(r);
    if (size == 0) return r;
    const VectorXf near = (*multigrid)((r / size).cast<float>());
    return size * near.cast<double>();
  };
  return [K, M](const VectorXd& forces) {
    return conjugate_gradients(K, M, forces, limits)
        .value_or(VectorXd::Zero(forces.size()));
  };
}

}  // namespace ffcontact
