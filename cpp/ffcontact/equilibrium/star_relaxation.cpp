// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "ffcontact/base/over.hpp"
#include "ffcontact/equilibrium/boundary_relaxation.hpp"
#include "ffcontact/equilibrium/contact_groups.hpp"
#include "ffcontact/equilibrium/relaxation_progress.hpp"
#include "ffcontact/equilibrium/star_descent.hpp"

namespace ffcontact {

namespace {

using Group = std::vector<int>;
using Triangles = std::set<int>;

Triangles triangles_of(const Stars& stars, const Group& group) {
  Triangles triangles;
  for (int v : group)
    for (int t : stars.triangles_of(v)) triangles.insert(t);
  return triangles;
}

bool meet(const Triangles& some, const Triangles& others) {
  return std::any_of(some.begin(), some.end(),
                     [&](int t) { return others.count(t) > 0; });
}

/// The first colour that has not taken any of some triangles.
std::size_t free_colour(const std::vector<Triangles>& taken,
                        const Triangles& some) {
  std::size_t colour = 0;
  while (colour < taken.size() && meet(some, taken[colour])) ++colour;
  return colour;
}

/// The groups of contact vertices by colours, greedily in the order of the line: those of
/// one colour share no triangle.
struct ContactStars {
  std::vector<std::vector<Group>> colours;
  Triangles triangles;  ///< of all groups
};

ContactStars contact_stars(const Stars& stars, const ContactLine& line) {
  ContactStars result;
  std::vector<Triangles> taken;  // by each colour
  for (const Group& group : contact_groups(line)) {
    const Triangles own = triangles_of(stars, group);
    const std::size_t colour = free_colour(taken, own);
    taken.resize(std::max(taken.size(), colour + 1));
    result.colours.resize(taken.size());
    taken[colour].insert(own.begin(), own.end());
    result.triangles.insert(own.begin(), own.end());
    result.colours[colour].push_back(group);
  }
  return result;
}

/// Relaxes colour by colour; returns by how much e^2 fell.
double relax_all(const StarSetting& setting, const ContactStars& stars,
                 VectorXd& airy, FreeContact& contact) {
  double fallen = 0;
  for (const std::vector<Group>& colour : stars.colours) {
    std::vector<double> fall(colour.size());
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < colour.size(); ++k)
      fall[k] = relax_boundary(setting, colour[k], airy, contact);
    for (double f : fall) fallen += f;  // in a fixed order
  }
  return fallen;
}

/// The square of the elastic part before the relaxation.
double elastic_square(const StarSetting& setting) {
  return sum_over(setting.space.mesh.cell_count(),
                  [&](int t) { return setting.energies[t].before; });
}

/// The contact part of e^2 up to the constant of Tresca's.
double contact_square(const FreeContact* contact) {
  if (!contact) return 0;
  const FreeTractions& free = contact->tractions;
  return free.normal_cost.cwiseProduct(free.densities.normal).sum() +
         free.tangential_cost.cwiseProduct(free.densities.tangential).sum();
}

/// Steps of the descent in a sweep: two sweeps lower e as much as two of Gauss-Seidel over
/// the stars with the best combination after each.
constexpr int steps_of_a_sweep = 2;

/// The descent and the stars on free contact edges in turn.
class Relaxation {
 public:
  Relaxation(const StarSetting& setting, FreeContact* contact)
      : setting_(setting), contact_(contact), descent_(setting) {
    if (contact) on_contact_ = contact_stars(setting.stars, contact->line);
  }

  /// Returns by how much e^2 fell.
  double sweep() {
    double fall = 0;
    for (int step = 0; step < steps_of_a_sweep; ++step) fall += descent_.step();
    return contact_ ? fall + relax_contact() : fall;
  }

  const VectorXd& airy() const { return descent_.airy(); }

 private:
  double relax_contact() {
    return descent_.changed(on_contact_.triangles, [&](VectorXd& airy) {
      return relax_all(setting_, on_contact_, airy, *contact_);
    });
  }

  const StarSetting& setting_;
  FreeContact* contact_;
  StarDescent descent_;
  ContactStars on_contact_;
};

}  // namespace

std::vector<double> relax_stars(const Topology& topology, const Hooke& hooke,
                                const BoundaryTractions& boundary,
                                const BodyLoadsOfAll& body_loads,
                                const RelaxationSettings& settings,
                                EdgeLoadsOfAll& difference,
                                FreeContact* contact,
                                const std::vector<FreeSpring>& springs) {
  if (settings.sweeps == 0) return {};
  StarSetting setting =
      star_setting(topology, hooke, boundary, body_loads, difference);
  add_springs(springs, setting);
  Relaxation relaxation(setting, contact);
  RelaxationProgress progress(elastic_square(setting), contact_square(contact));
  std::vector<double> falls;
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
    falls.push_back(relaxation.sweep());
    const bool goes_on = progress.goes_on(falls.back(), settings.tightness);
    tell(settings.report, {"relaxation", sweep + 1, "e", progress.e()});
    if (!goes_on) break;
  }
  add_airy_loads(setting.space, relaxation.airy(), difference);
  return falls;
}

}  // namespace ffcontact
