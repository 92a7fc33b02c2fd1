// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "ffcontact/equilibrium/boundary_relaxation.hpp"
#include "ffcontact/equilibrium/star_descent.hpp"

namespace ffcontact {

namespace {

/// Groups of vertices that are relaxed together, by colours: groups of one colour share no
/// triangle.
using Colours = std::vector<std::vector<std::vector<int>>>;

/// Relaxes colour by colour; returns by how much e^2 fell.
double relax_all(const StarSetting& setting, const Colours& colours,
                 VectorXd& airy, FreeContact* contact) {
  double fallen = 0;
  for (const auto& colour : colours) {
    std::vector<double> fall(colour.size());
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < colour.size(); ++k)
      fall[k] = relax_boundary(setting, colour[k], airy, contact);
    for (double f : fall) fallen += f;  // in a fixed order
  }
  return fallen;
}

std::set<int> triangles_beside(const Stars& stars,
                               const std::vector<int>& vertices) {
  std::set<int> triangles;
  for (int v : vertices)
    triangles.insert(stars.triangle.begin() + stars.triangle_start[v],
                     stars.triangle.begin() + stars.triangle_start[v + 1]);
  return triangles;
}

/// Groups of contact vertices, coloured greedily in the order of the line, and the
/// triangles that they change.
struct ContactStars {
  Colours colours;
  std::vector<int> triangles;

  ContactStars(const Stars& stars, const ContactLine& line) {
    std::vector<std::set<int>> taken;  // triangles of each colour
    std::set<int> all;
    for (const std::vector<int>& group : contact_groups(line)) {
      const std::set<int> beside = triangles_beside(stars, group);
      const std::size_t colour = first_free(taken, beside);
      if (colour == taken.size()) {
        taken.emplace_back();
        colours.emplace_back();
      }
      taken[colour].insert(beside.begin(), beside.end());
      all.insert(beside.begin(), beside.end());
      colours[colour].push_back(group);
    }
    triangles.assign(all.begin(), all.end());
  }

 private:
  static std::size_t first_free(const std::vector<std::set<int>>& taken,
                                const std::set<int>& triangles) {
    const auto is_free = [&](const std::set<int>& colour) {
      return std::none_of(triangles.begin(), triangles.end(),
                          [&](int t) { return colour.count(t) > 0; });
    };
    return static_cast<std::size_t>(
        std::find_if(taken.begin(), taken.end(), is_free) - taken.begin());
  }
};

/// The square of the elastic part before the relaxation.
double elastic_square(const StarSetting& setting) {
  double square = 0;
  for (int t = 0; t < setting.space.mesh.cell_count(); ++t)
    square += setting.energies[t].before;
  return square;
}

/// The contact part of e^2 up to the constant of Tresca's.
double contact_square(const FreeContact* contact) {
  if (!contact) return 0;
  const FreeTractions& free = contact->tractions;
  return free.normal_cost.cwiseProduct(free.densities.normal).sum() +
         free.tangential_cost.cwiseProduct(free.densities.tangential).sum();
}

/// Steps of the descent in a sweep: two sweeps lower e as much as two of Gauss-Seidel over
/// the stars with the best combination after each, at half the cost.
constexpr int steps_of_a_sweep = 2;

/// A sweep that lowers e^2 by less than this part of what it was at first changes no
/// digit of it: the rest is rounding.
constexpr double rounding = 1e-15;

}  // namespace

std::vector<double> relax_stars(const Topology& topology, const Hooke& hooke,
                                const BoundaryTractions& boundary,
                                const BodyLoadsOfAll& body_loads,
                                const RelaxationSettings& settings,
                                EdgeLoadsOfAll& difference,
                                FreeContact* contact) {
  if (settings.sweeps == 0) return {};
  const StarSetting setting =
      star_setting(topology, hooke, boundary, body_loads, difference);
  StarDescent descent(setting);
  std::optional<ContactStars> on_contact;
  if (contact) on_contact.emplace(setting.stars, contact->line);
  std::vector<double> falls;
  const double elastic = elastic_square(setting),
               on_contact_edges = contact_square(contact);
  const double first = elastic + std::abs(on_contact_edges);
  double square = elastic + on_contact_edges;
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
    double fall = 0;
    for (int step = 0; step < steps_of_a_sweep; ++step) fall += descent.step();
    if (contact)
      fall += descent.changed(on_contact->triangles, [&](VectorXd& airy) {
        return relax_all(setting, on_contact->colours, airy, contact);
      });
    falls.push_back(fall);
    if (fall <= rounding * first) break;
    const double e_before = std::sqrt(std::max(square, 0.0)),
                 e_after = std::sqrt(std::max(square - fall, 0.0));
    square -= fall;
    if (e_before - e_after < settings.tightness * e_before) break;
  }
  add_airy_loads(setting.space, descent.airy(), difference);
  return falls;
}

}  // namespace ffcontact
