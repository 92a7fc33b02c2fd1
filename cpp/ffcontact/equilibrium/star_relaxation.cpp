// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_relaxation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <set>

#include "ffcontact/equilibrium/boundary_relaxation.hpp"

namespace ffcontact {

namespace {

/// An inner vertex; returns by how much e^2 fell.
template <int Max>
double relax_inner(const StarSetting& setting, const StarCorrections& star, EdgeLoadsOfAll& difference) {
  StarEnergy<Max> energy(setting, star, difference);
  const auto llt = energy.H.template selfadjointView<Eigen::Lower>().llt();
  if (llt.info() != Eigen::Success) return 0;
  const Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, Max, 1> y = -llt.solve(energy.g);
  apply(star, y, difference);
  return -y.dot(energy.g);
}

double relax(const StarSetting& setting, int vertex, EdgeLoadsOfAll& difference, FreeContact* contact) {
  constexpr int usual = 16;
  if (setting.stars.triangle_count(vertex) == 0) return 0;
  if (setting.stars.on_boundary(vertex)) return relax_boundary(setting, {vertex}, difference, contact);
  const StarCorrections star(setting.mesh, setting.edges, setting.stars, vertex);
  return star.unknowns() <= usual ? relax_inner<usual>(setting, star, difference)
                                  : relax_inner<Eigen::Dynamic>(setting, star, difference);
}

double relax(const StarSetting& setting, const std::vector<int>& group, EdgeLoadsOfAll& difference,
             FreeContact* contact) {
  return relax_boundary(setting, group, difference, contact);
}

/// What is relaxed, single vertices or groups of them, by colours: members of one colour share no triangle.
template <class Member>
using Colours = std::vector<std::vector<Member>>;

/// Vertices of a colour (about a millisecond of work) below which starting threads costs more than it saves.
constexpr std::size_t worth_threads = 500;

/// Relaxes colour by colour; returns by how much e^2 fell.
template <class Member>
double relax_all(const StarSetting& setting, const Colours<Member>& colours, EdgeLoadsOfAll& difference,
                 FreeContact* contact) {
  double fallen = 0;
  for (const std::vector<Member>& colour : colours) {
    std::vector<double> fall(colour.size());
#pragma omp parallel for schedule(static) if (colour.size() >= worth_threads)
    for (std::size_t k = 0; k < colour.size(); ++k) fall[k] = relax(setting, colour[k], difference, contact);
    for (double f : fall) fallen += f;  // in a fixed order
  }
  return fallen;
}

/// Groups of contact vertices, coloured greedily in the order of the line.
Colours<std::vector<int>> coloured_groups(const StarSetting& setting, const ContactLine& line) {
  Colours<std::vector<int>> colours;
  std::vector<std::set<int>> taken;  // triangles of each colour
  for (const std::vector<int>& group : contact_groups(line)) {
    std::set<int> triangles;
    for (int v : group)
      triangles.insert(setting.stars.triangle.begin() + setting.stars.triangle_start[v],
                       setting.stars.triangle.begin() + setting.stars.triangle_start[v + 1]);
    const auto is_free = [&](const std::set<int>& colour) {
      return std::none_of(triangles.begin(), triangles.end(), [&](int t) { return colour.count(t) > 0; });
    };
    const auto colour = static_cast<std::size_t>(std::find_if(taken.begin(), taken.end(), is_free) - taken.begin());
    if (colour == taken.size()) {
      taken.emplace_back();
      colours.emplace_back();
    }
    taken[colour].insert(triangles.begin(), triangles.end());
    colours[colour].push_back(group);
  }
  return colours;
}

/// The vertices by colours, those in the groups left out.
Colours<int> other_vertices(const StarSetting& setting, const Colours<std::vector<int>>& groups) {
  std::vector<char> in_group(setting.mesh.vertex_count(), 0);
  for (const auto& colour : groups)
    for (const std::vector<int>& group : colour)
      for (int v : group) in_group[v] = 1;
  Colours<int> others = vertex_colours(setting.mesh, setting.stars);
  for (std::vector<int>& colour : others)
    colour.erase(std::remove_if(colour.begin(), colour.end(), [&](int v) { return in_group[v]; }), colour.end());
  return others;
}

/// e^2 up to the constant of Tresca's contact part: what `tightness` is relative to.
double square_of_error(const StarSetting& setting, const BodyLoadsOfAll& body_loads, const EdgeLoadsOfAll& difference,
                       const Hooke& hooke, const FreeContact* contact) {
  double square = 0;
  for (int t = 0; t < setting.mesh.triangle_count(); ++t) {
    const TriangleCorners corners = corners_of(setting.mesh, t);
    square += energy(corners, hooke[t].inverse(), composite_stress(corners, difference.col(t), body_loads.col(t)));
  }
  if (!contact) return square;
  const FreeTractions& free = contact->tractions;
  return square + free.normal_cost.cwiseProduct(free.densities.normal).sum() +
         free.tangential_cost.cwiseProduct(free.densities.tangential).sum();
}

/// The best combination of a sweep's corrections and the previous direction.
class Acceleration {
 public:
  /// @param sweep  the sweep's corrections; its memory is used up
  double operator()(const StarSetting& setting, EdgeLoadsOfAll&& sweep, EdgeLoadsOfAll& difference) {
    if (direction_.cols() == 0) direction_ = EdgeLoadsOfAll::Zero(12, sweep.cols());
    Eigen::Matrix<double, 6, Eigen::Dynamic> parts(6, sweep.cols());  // d'Ad, d'Ap, p'Ap, d'g, p'g, difference'g
#pragma omp parallel for
    for (Eigen::Index t = 0; t < sweep.cols(); ++t) {
      const EdgeLoads d = sweep.col(t), p = direction_.col(t), g = setting.gradient(difference, static_cast<int>(t));
      const EdgeLoads A_d = setting.energies[t].lazyProduct(d), A_p = setting.energies[t].lazyProduct(p);
      parts.col(t) << d.dot(A_d), p.dot(A_d), p.dot(A_p), d.dot(g), p.dot(g), g.dot(difference.col(t));
    }
    const Eigen::Matrix<double, 6, 1> sum = parts.rowwise().sum();
    energy_ = std::abs(sum[5]);
    Eigen::Matrix2d M;
    M << sum[0], sum[1], sum[1], sum[2];
    const Eigen::Vector2d slope(sum[3], sum[4]);
    const Eigen::Vector2d step = -M.completeOrthogonalDecomposition().solve(slope);
    const double fall = -step.dot(M * step) - 2 * step.dot(slope);
    if (!(fall > 0) || step.cwiseAbs().maxCoeff() > longest_step) {
      direction_ = std::move(sweep);
      return 0;
    }
    difference += step[0] * sweep + step[1] * direction_;
    direction_ *= step[1];
    direction_ += (1 + step[0]) * sweep;
    return fall;
  }

  /// The square of the elastic part after the sweep, up to the part of body forces.
  double energy() const { return energy_; }

 private:
  /// Beyond it a direction is mostly rounding, which does not keep equilibrium and would be multiplied.
  static constexpr double longest_step = 1e3;

  EdgeLoadsOfAll direction_;
  double energy_ = 0;
};

/// A sweep that lowers e^2 by less than this part of what it was at first changes no digit of it: the rest is rounding.
constexpr double rounding = 1e-15;

}  // namespace

std::vector<double> relax_stars(const Mesh& mesh, const Edges& edges, const Stars& stars, const Hooke& hooke,
                                const BoundaryTractions& boundary, const BodyLoadsOfAll& body_loads,
                                const RelaxationSettings& settings, EdgeLoadsOfAll& difference, FreeContact* contact) {
  const StarSetting setting = star_setting(mesh, edges, stars, hooke, boundary, body_loads);
  const Colours<std::vector<int>> on_contact =
      contact ? coloured_groups(setting, contact->line) : Colours<std::vector<int>>{};
  const Colours<int> others = other_vertices(setting, on_contact);
  Acceleration accelerate;
  std::vector<double> falls;
  double largest = 0;
  double square = settings.tightness > 0 ? square_of_error(setting, body_loads, difference, hooke, contact) : 0;
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
    EdgeLoadsOfAll change = -difference;
    double fall = relax_all(setting, others, difference, contact);
    change += difference;
    fall += accelerate(setting, std::move(change), difference);
    fall += relax_all(setting, on_contact, difference, contact);
    falls.push_back(fall);
    largest = std::max(largest, accelerate.energy() + fall);
    if (fall <= rounding * largest) break;
    const double e_before = std::sqrt(std::max(square, 0.0)), e_after = std::sqrt(std::max(square - fall, 0.0));
    square -= fall;
    if (e_before - e_after < settings.tightness * e_before) break;
  }
  return falls;
}

}  // namespace ffcontact
