// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/relaxation/star_relaxation.hpp"

#include <algorithm>
#include <set>

#include "ffcontact/equilibrium/cone/boundary_relaxation.hpp"
#include "ffcontact/equilibrium/cone/contact_groups.hpp"
#include "ffcontact/equilibrium/relaxation/facet_descent.hpp"
#include "ffcontact/equilibrium/relaxation/relaxation_progress.hpp"

namespace ffcontact {

namespace {

using Triangles = std::set<int>;

Triangles triangles_of(const FacetTopology<2>& topology,
                       const StarGroup& group) {
  Triangles triangles;
  for (int ridge : group.ridge)
    for (int edge : topology.ridges.facets_of(ridge))
      for (int t : topology.facets.cells.col(edge))
        if (t >= 0) triangles.insert(t);
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

std::vector<int> ridge_of_vertices(const FacetTopology<2>& topology) {
  std::vector<int> ridge(topology.mesh.vertex_count(), -1);
  for (int r = 0; r < topology.ridges.count(); ++r)
    ridge[topology.ridges.vertices(0, r)] = r;
  return ridge;
}

/// The groups of contact vertices by colours, greedily in the order of the line: those of
/// one colour share no triangle.
std::vector<std::vector<StarGroup>> groups_by_colours(
    const FacetTopology<2>& topology, const ContactLine& line) {
  const std::vector<int> ridge_of = ridge_of_vertices(topology);
  std::vector<std::vector<StarGroup>> colours;
  std::vector<Triangles> taken;  // by each colour
  for (std::vector<int> ridges : contact_groups(line)) {
    for (int& member : ridges) member = ridge_of[member];
    StarGroup group(topology, std::move(ridges));
    const Triangles own = triangles_of(topology, group);
    const std::size_t colour = free_colour(taken, own);
    taken.resize(std::max(taken.size(), colour + 1));
    colours.resize(taken.size());
    taken[colour].insert(own.begin(), own.end());
    colours[colour].push_back(std::move(group));
  }
  return colours;
}

/// The contact part of e^2 up to the constant of Tresca's.
double contact_square(const FreeContact* contact) {
  if (!contact) return 0;
  const FreeTractions& free = contact->tractions;
  return free.normal_cost.cwiseProduct(free.densities.normal).sum() +
         free.tangential_cost.cwiseProduct(free.densities.tangential).sum();
}

/// Without those of free contact edges.
KnownTractions<2> known_but_for(const FreeContact* contact,
                                KnownTractions<2> known) {
  for (Index e = 0; contact && e < known.cols(); ++e)
    if (contact->tractions.contact_edge[e] >= 0)
      known.col(e).setConstant(false);
  return known;
}

/// Steps of the descent in a sweep: two sweeps lower e as much as two of Gauss-Seidel over
/// the stars with the best combination after each.
constexpr int steps_of_a_sweep = 2;

/// The descent and the stars on free contact edges in turn.
class Relaxation {
 public:
  Relaxation(const LoadedFacets<2>& body, const EdgeMoments& moments,
             FreeContact* contact)
      : body_(body),
        contact_(contact),
        share_(whole_share<2>(body.topology)),
        descent_(body, moments, share_, none_) {
    if (contact) colours_ = groups_by_colours(body.topology, contact->line);
  }

  double begin() { return descent_.begin(); }

  /// Returns by how much e^2 fell.
  double sweep() {
    double fall = 0;
    for (int step = 0; step < steps_of_a_sweep; ++step) fall += descent_.step();
    for (const std::vector<StarGroup>& colour : colours_) fall += relax(colour);
    return fall;
  }

  const FacetColumns<2>& corrections() { return descent_.corrections(); }

 private:
  double relax(const std::vector<StarGroup>& colour) {
    std::vector<BoundaryChange> change(colour.size());
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < colour.size(); ++k)
      change[k] =
          relax_boundary(body_.topology, descent_.forms(), body_.boundary,
                         colour[k], descent_.residual(), *contact_);
    double fallen = 0;  // summed in a fixed order
    for (std::size_t k = 0; k < colour.size(); ++k) {
      fallen += change[k].fall;
      if (change[k].fall > 0) add(colour[k], change[k].y);
    }
    return fallen;
  }

  void add(const StarGroup& group, const VectorXd& y) {
    for (std::size_t s = 0; s < group.ridge.size(); ++s)
      add_around<2>(
          body_.topology, descent_.forms(), group.ridge[s],
          y.segment(group.first[s], group.first[s + 1] - group.first[s]),
          descent_.corrections(), descent_.residual());
  }

  const LoadedFacets<2>& body_;
  FreeContact* contact_;
  const FacetShare share_;
  const NoExchange<2> none_;
  FacetDescent<2> descent_;
  std::vector<std::vector<StarGroup>> colours_;
};

}  // namespace

std::vector<double> relax_stars(const LoadedFacets<2>& body,
                                const RelaxationSettings& settings,
                                EdgeMoments& moments, FreeContact* contact) {
  if (settings.sweeps == 0) return {};
  Relaxation relaxation(body, moments, contact);
  RelaxationProgress progress(relaxation.begin(), contact_square(contact));
  std::vector<double> falls;
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
    falls.push_back(relaxation.sweep());
    const bool goes_on = progress.goes_on(falls.back(), settings.tightness);
    tell(settings.report, {"relaxation", sweep + 1, "e", progress.e()});
    if (!goes_on) break;
  }
  add_corrections<2>(body.topology, known_but_for(contact, body.boundary.known),
                     relaxation.corrections(), moments);
  return falls;
}

}  // namespace ffcontact
