// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/airy_energy.hpp"
#include "ffcontact/equilibrium/star_corrections.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// Everything the vertices need, fixed during the relaxation.
struct StarSetting {
  AirySpace space;
  const Stars& stars;
  const BoundaryTractions& boundary;
  /// per triangle, from the tractions before the relaxation
  std::unique_ptr<AiryEnergy[]> energies;
};

/// @param difference  edge loads of sigma_hat - C eps(u_hat) before the relaxation
/// @param body_loads  int f phi_i per triangle
StarSetting star_setting(const Topology& topology, const Hooke& hooke,
                         const BoundaryTractions& boundary,
                         const BodyLoadsOfAll& body_loads,
                         const EdgeLoadsOfAll& difference);

/// The energy of the corrections y of one star, y'Hy + 2 g'y. Stars of up to Max - 3
/// spokes need no memory of their own.
template <int Max>
struct StarEnergy {
  Matrix<double, Dynamic, Dynamic, Eigen::ColMajor, Max, Max>
      H;  ///< lower triangle
  Matrix<double, Dynamic, 1, Eigen::ColMajor, Max, 1> g;

  /// H alone.
  StarEnergy(const StarSetting& setting, int vertex) {
    const int n = star_unknowns(setting.stars, vertex);
    H.setZero(n, n);
    visit(setting, vertex, [&](const Place& place) {
      add_form(setting.energies[place.triangle], place);
    });
  }

  /// @param airy  the corrections made so far
  StarEnergy(const StarSetting& setting, int vertex, const VectorXd& airy)
      : StarEnergy(setting, vertex) {
    g.setZero(H.rows());
    visit(setting, vertex, [&](const Place& place) {
      add_slope(setting.energies[place.triangle],
                local_airy(setting.space, airy, place.triangle, place.local),
                place);
    });
  }

 private:
  /// A triangle with the vertex as its local vertex i, edge i + 2 as its right spoke and
  /// edge i + 1 as its left one; the unknowns of these.
  struct Place {
    int triangle, local;
    int right, left;
  };

  template <class Visit>
  static void visit(const StarSetting& setting, int vertex, Visit&& visit) {
    const Stars& stars = setting.stars;
    const int spokes = stars.spoke_count(vertex);
    for (int k = 0; k < stars.triangle_count(vertex); ++k) {
      const int place = stars.triangle_start[vertex] + k;
      visit(Place{stars.triangle[place], stars.local[place], 3 + k,
                  3 + (k + 1) % spokes});
    }
  }

  void add_form(const AiryEnergy& K, const Place& place) {
    const auto [triangle, i, right, left] = place;
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    for (int c = 0; c < 3; ++c) {
      for (int d = 0; d <= c; ++d) H(c, d) += K.own[i](c, d);
      H(right, c) += K.edge[b](c, 1);
      H(left, c) += K.edge[a](c, 2);
    }
    H(right, right) += K.edge_own[b];
    H(left, left) += K.edge_own[a];
    H(std::max(right, left), std::min(right, left)) += K.edge_next[a];
  }

  void add_slope(const AiryEnergy& K, const LocalAiry& x, const Place& place) {
    for (int c = 0; c < 3; ++c) g[c] += vertex_slope(K, x, place.local, c);
    g[place.right] += edge_slope(K, x, place.local, 2);
    g[place.left] += edge_slope(K, x, place.local, 1);
  }

  /// g + K x for unknown c of local vertex i.
  /// @param x  counted from there
  static double vertex_slope(const AiryEnergy& K, const LocalAiry& x, int i,
                             int c) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    double slope = K.slope.at_vertices(c, i) + K.edge[i](c, 0) * x.on_edges[0] +
                   K.edge[a](c, 2) * x.on_edges[1] +
                   K.edge[b](c, 1) * x.on_edges[2];
    for (int d = 0; d < 3; ++d)
      slope += K.own[i](c, d) * x.at_vertices(d, 0) +
               K.next[i](c, d) * x.at_vertices(d, 1) +
               K.next[b](d, c) * x.at_vertices(d, 2);
    return slope;
  }

  /// g + K x for local edge i + r.
  static double edge_slope(const AiryEnergy& K, const LocalAiry& x, int i,
                           int r) {
    const int k = (i + r) % 3, s = (r + 1) % 3, u = (r + 2) % 3;
    double slope = K.slope.on_edges[k];
    for (int c = 0; c < 3; ++c)
      slope += K.edge[k](c, 0) * x.at_vertices(c, r) +
               K.edge[k](c, 1) * x.at_vertices(c, s) +
               K.edge[k](c, 2) * x.at_vertices(c, u);
    return slope + K.edge_own[k] * x.on_edges[r] +
           K.edge_next[k] * x.on_edges[s] +
           K.edge_next[(k + 2) % 3] * x.on_edges[u];
  }
};

}  // namespace ffcontact
