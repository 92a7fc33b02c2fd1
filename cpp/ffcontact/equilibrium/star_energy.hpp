// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/difference_loads.hpp"
#include "ffcontact/equilibrium/star_corrections.hpp"

namespace ffcontact {

/// Everything the vertices need, fixed during the relaxation.
struct StarSetting {
  const Mesh& mesh;
  const Edges& edges;
  const Stars& stars;
  const BoundaryTractions& boundary;
  std::vector<EnergyMatrix> energies;
  EdgeLoadsOfAll body_gradient;  ///< no columns when there is no body force

  EdgeLoads gradient(const EdgeLoadsOfAll& difference, int t) const {
    const EdgeLoads g = energies[t].lazyProduct(EdgeLoads(difference.col(t)));
    return body_gradient.cols() > 0 ? EdgeLoads(g + body_gradient.col(t)) : g;
  }
};

StarSetting star_setting(const Mesh& mesh, const Edges& edges, const Stars& stars, const Hooke& hooke,
                         const BoundaryTractions& boundary, const BodyLoadsOfAll& body_loads);

/// The energy of the corrections of one star, y'Hy + 2 g'y. Stars of up to Max - 3 spokes need no memory of their own.
template <int Max>
struct StarEnergy {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, Max, Max> H;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, Max, 1> g;

  StarEnergy(const StarSetting& setting, const StarCorrections& star, const EdgeLoadsOfAll& difference) {
    const int n = star.unknowns();
    H.setZero(n, n);
    g.setZero(n);
    const bool loaded = setting.body_gradient.cols() > 0;
    for (int k = 0; k < star.triangle_count(); ++k) {
      const int t = star.triangle(k);
      const Eigen::Matrix<double, 8, 5> loads = star.triangle_loads(k);
      const std::array<int, 8> rows = star.rows(k);
      const std::array<int, 5> columns = star.columns(k);
      const EdgeLoads own = difference.col(t);
      Eigen::Matrix<double, 8, 8> A;
      Eigen::Matrix<double, 8, 1> gradient_rows;
      for (int c = 0; c < 8; ++c) {
        const EdgeLoads column = setting.energies[t].col(rows[c]);
        for (int r = 0; r < 8; ++r) A(r, c) = column[rows[r]];
        gradient_rows[c] = column.dot(own) + (loaded ? setting.body_gradient(rows[c], t) : 0);
      }
      const Eigen::Matrix<double, 8, 5> A_loads = A.lazyProduct(loads);
      const Eigen::Matrix<double, 5, 5> H_local = loads.transpose().lazyProduct(A_loads);
      const Eigen::Matrix<double, 5, 1> g_local = loads.transpose().lazyProduct(gradient_rows);
      for (int a = 0; a < 5; ++a) {
        g[columns[a]] += g_local[a];
        for (int b = 0; b < 5; ++b) H(columns[b], columns[a]) += H_local(b, a);
      }
    }
  }
};

/// Adds the corrections y of a star to the edge loads.
void apply(const StarCorrections& star, const Eigen::Ref<const Eigen::VectorXd>& y, EdgeLoadsOfAll& difference);

}  // namespace ffcontact
