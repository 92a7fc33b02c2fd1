// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/equilibrium/boundary_relaxation.hpp"

namespace ffcontact {

namespace {

/// y = H^-1 y by Cholesky's method, which uses up the lower triangle of H; false if H is
/// not positive definite. For ten unknowns Eigen's kernels cost more than they save.
template <class Matrix, class Vector>
bool solve_in_place(Matrix& H, Vector& y) {
  const Index n = y.size();
  for (Index j = 0; j < n; ++j) {
    if (!(H(j, j) > 0)) return false;
    const double inverse = 1 / H(j, j);
    for (Index k = j + 1; k < n; ++k) {
      const double factor = H(k, j) * inverse;
      for (Index i = k; i < n; ++i) H(i, k) -= factor * H(i, j);
      y[k] -= factor * y[j];
    }
    H(j, j) = inverse;
  }
  for (Index j = n - 1; j >= 0; --j) {
    for (Index i = j + 1; i < n; ++i) y[j] -= H(i, j) * y[i];
    y[j] *= H(j, j);
  }
  return true;
}

/// An inner vertex; returns by how much e^2 fell.
template <int Max>
double relax_inner(const StarSetting& setting, int vertex, VectorXd& airy) {
  StarEnergy<Max> energy(setting, vertex, airy);
  auto y = energy.g;
  if (!solve_in_place(energy.H, y)) return 0;
  add_corrections(setting.space, setting.stars, vertex, -y, airy);
  return y.dot(energy.g);
}

double relax(const StarSetting& setting, int vertex, VectorXd& airy,
             FreeContact* contact) {
  constexpr int usual = 16;
  if (setting.stars.triangle_count(vertex) == 0) return 0;
  if (setting.stars.on_boundary(vertex))
    return relax_boundary(setting, {vertex}, airy, contact);
  return star_unknowns(setting.stars, vertex) <= usual
             ? relax_inner<usual>(setting, vertex, airy)
             : relax_inner<Dynamic>(setting, vertex, airy);
}

double relax(const StarSetting& setting, const std::vector<int>& group,
             VectorXd& airy, FreeContact* contact) {
  return relax_boundary(setting, group, airy, contact);
}

/// What is relaxed, single vertices or groups of them, by colours: members of one colour
/// share no triangle.
template <class Member>
using Colours = std::vector<std::vector<Member>>;

/// Vertices of a colour (about a millisecond of work) below which starting threads costs
/// more than it saves.
constexpr std::size_t worth_threads = 500;

/// Relaxes colour by colour; returns by how much e^2 fell.
template <class Member>
double relax_all(const StarSetting& setting, const Colours<Member>& colours,
                 VectorXd& airy, FreeContact* contact) {
  double fallen = 0;
  for (const std::vector<Member>& colour : colours) {
    std::vector<double> fall(colour.size());
#pragma omp parallel for schedule(static) if (colour.size() >= worth_threads)
    for (std::size_t k = 0; k < colour.size(); ++k)
      fall[k] = relax(setting, colour[k], airy, contact);
    for (double f : fall) fallen += f;  // in a fixed order
  }
  return fallen;
}

/// Groups of contact vertices, coloured greedily in the order of the line.
Colours<std::vector<int>> coloured_groups(const StarSetting& setting,
                                          const ContactLine& line) {
  Colours<std::vector<int>> colours;
  std::vector<std::set<int>> taken;  // triangles of each colour
  for (const std::vector<int>& group : contact_groups(line)) {
    std::set<int> triangles;
    for (int v : group)
      triangles.insert(
          setting.stars.triangle.begin() + setting.stars.triangle_start[v],
          setting.stars.triangle.begin() + setting.stars.triangle_start[v + 1]);
    const auto is_free = [&](const std::set<int>& colour) {
      return std::none_of(triangles.begin(), triangles.end(),
                          [&](int t) { return colour.count(t) > 0; });
    };
    const auto colour = static_cast<std::size_t>(
        std::find_if(taken.begin(), taken.end(), is_free) - taken.begin());
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
Colours<int> other_vertices(const StarSetting& setting,
                            const Colours<std::vector<int>>& groups) {
  std::vector<char> in_group(setting.space.mesh.vertex_count(), 0);
  for (const auto& colour : groups)
    for (const std::vector<int>& group : colour)
      for (int v : group) in_group[v] = 1;
  Colours<int> others = vertex_colours(setting.space.mesh, setting.stars);
  for (std::vector<int>& colour : others)
    colour.erase(std::remove_if(colour.begin(), colour.end(),
                                [&](int v) { return in_group[v]; }),
                 colour.end());
  return others;
}

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

/// The best combination of a sweep's corrections and the previous direction.
class Acceleration {
 public:
  /// @param before  the unknowns before the sweep; the memory is used up
  double operator()(const StarSetting& setting, VectorXd&& before,
                    VectorXd& airy) {
    VectorXd sweep = airy - before;
    if (direction_.size() == 0) direction_ = VectorXd::Zero(airy.size());
    const Products products = products_of(setting, sweep, airy);
    Matrix2d M;
    M << products[0], products[1], products[1], square_;
    const Vector2d slope(products[2], products[3]);
    const Vector2d step = -least_squares(M, slope);
    const double fall = -step.dot(M * step) - 2 * step.dot(slope);
    if (!(fall > 0) || step.cwiseAbs().maxCoeff() > longest_step) {
      direction_ = std::move(sweep);
      square_ = products[0];
      return 0;
    }
    airy += step[0] * sweep + step[1] * direction_;
    const Vector2d combined(1 + step[0], step[1]);
    direction_ = combined[0] * sweep + combined[1] * direction_;
    square_ = combined.dot(M * combined);
    return fall;
  }

 private:
  /// d'Kd, d'Kp, d'g, p'g for the sweep d and the direction p
  using Products = Eigen::Array4d;

  /// Sums over parts of the mesh that do not depend on the number of threads.
  Products products_of(const StarSetting& setting, const VectorXd& sweep,
                       const VectorXd& airy) const {
    constexpr int part = 1024;
    const int triangles = setting.space.mesh.cell_count(),
              parts = (triangles + part - 1) / part;
    std::vector<Products> sums(parts, Products::Zero());
#pragma omp parallel for
    for (int k = 0; k < parts; ++k)
      for (int t = k * part; t < std::min(triangles, (k + 1) * part); ++t)
        sums[k] += products_in(setting, t, sweep, airy);
    Products sum = Products::Zero();
    for (const Products& products : sums) sum += products;
    return sum;
  }
  Products products_in(const StarSetting& setting, int t, const VectorXd& sweep,
                       const VectorXd& airy) const {
    const AiryEnergy& energy = setting.energies[t];
    const LocalAiry d = local_airy(setting.space, sweep, t),
                    p = local_airy(setting.space, direction_, t);
    const LocalAiry K_d = energy.times(d),
                    K_x = energy.times(local_airy(setting.space, airy, t));
    return {dot(d, K_d), dot(p, K_d), dot(d, energy.slope) + dot(d, K_x),
            dot(p, energy.slope) + dot(p, K_x)};
  }

  /// Beyond it a direction is mostly rounding.
  static constexpr double longest_step = 1e3;

  VectorXd direction_;
  double square_ = 0;  ///< p'Kp
};

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
  const Colours<std::vector<int>> on_contact =
      contact ? coloured_groups(setting, contact->line)
              : Colours<std::vector<int>>{};
  const Colours<int> others = other_vertices(setting, on_contact);
  VectorXd airy = VectorXd::Zero(setting.space.unknowns());
  Acceleration accelerate;
  std::vector<double> falls;
  const double elastic = elastic_square(setting),
               on_contact_edges = contact_square(contact);
  const double first = elastic + std::abs(on_contact_edges);
  double square = elastic + on_contact_edges;
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
    VectorXd before = airy;
    double fall = relax_all(setting, others, airy, contact);
    fall += accelerate(setting, std::move(before), airy);
    fall += relax_all(setting, on_contact, airy, contact);
    falls.push_back(fall);
    if (fall <= rounding * first) break;
    const double e_before = std::sqrt(std::max(square, 0.0)),
                 e_after = std::sqrt(std::max(square - fall, 0.0));
    square -= fall;
    if (e_before - e_after < settings.tightness * e_before) break;
  }
  add_airy_loads(setting.space, airy, difference);
  return falls;
}

}  // namespace ffcontact
