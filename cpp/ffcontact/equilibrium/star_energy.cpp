// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_energy.hpp"

#include <Eigen/LU>

namespace ffcontact {

StarSetting star_setting(const Mesh& mesh, const Edges& edges, const Stars& stars, const Hooke& hooke,
                         const BoundaryTractions& boundary, const BodyLoadsOfAll& body_loads) {
  StarSetting setting{mesh, edges, stars, boundary, std::vector<EnergyMatrix>(mesh.triangle_count()), {}};
  const bool loaded = !body_loads.isZero(0);
  if (loaded) setting.body_gradient.resize(12, mesh.triangles.cols());
#pragma omp parallel for
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix3d compliance = hooke[t].inverse();
    setting.energies[t] = composite_energy(corners_of(mesh, t), compliance);
    if (loaded) setting.body_gradient.col(t) = body_gradient(corners_of(mesh, t), compliance, body_loads.col(t));
  }
  return setting;
}

void apply(const StarCorrections& star, const Eigen::Ref<const Eigen::VectorXd>& y, EdgeLoadsOfAll& difference) {
  for (int k = 0; k < star.triangle_count(); ++k) {
    const std::array<int, 5> columns = star.columns(k);
    const std::array<int, 8> rows = star.rows(k);
    Eigen::Matrix<double, 5, 1> y_local;
    for (int a = 0; a < 5; ++a) y_local[a] = y[columns[a]];
    const Eigen::Matrix<double, 8, 1> change = star.triangle_loads(k).lazyProduct(y_local);
    for (int r = 0; r < 8; ++r) difference(rows[r], star.triangle(k)) += change[r];
  }
}

}  // namespace ffcontact
