// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/equilibrium/boundary_relaxation.hpp"
#include "ffcontact/equilibrium/contact_groups.hpp"

namespace ffcontact {

namespace {

/// Eliminates unknown j from those below it. @return 1 / H_jj
template <class Matrix, class Vector>
double eliminate(Index j, Matrix& H, Vector& y) {
  const double inverse = 1 / H(j, j);
  for (Index k = j + 1; k < y.size(); ++k) {
    const double factor = H(k, j) * inverse;
    for (Index i = k; i < y.size(); ++i) H(i, k) -= factor * H(i, j);
    y[k] -= factor * y[j];
  }
  return inverse;
}

/// H with the inverse pivots on its diagonal.
template <class Matrix, class Vector>
void substitute_back(const Matrix& H, Vector& y) {
  const Index n = y.size();
  for (Index j = n - 1; j >= 0; --j) {
    for (Index i = j + 1; i < n; ++i) y[j] -= H(i, j) * y[i];
    y[j] *= H(j, j);
  }
}

/// y = H^-1 y by Cholesky's method, which uses up the lower triangle of H; false if H is
/// not positive definite. For ten unknowns Eigen's kernels cost more than they save.
template <class Matrix, class Vector>
bool solve_in_place(Matrix& H, Vector& y) {
  for (Index j = 0; j < y.size(); ++j) {
    if (!(H(j, j) > 0)) return false;
    H(j, j) = eliminate(j, H, y);
  }
  substitute_back(H, y);
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

using Group = std::vector<int>;
using Triangles = std::set<int>;

Triangles triangles_of(const Stars& stars, const Group& group) {
  Triangles triangles;
  const auto all = stars.triangle.begin();
  for (int v : group)
    triangles.insert(all + stars.triangle_start[v],
                     all + stars.triangle_start[v + 1]);
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

/// Groups of contact vertices, coloured greedily in the order of the line.
Colours<Group> coloured_groups(const StarSetting& setting,
                               const ContactLine& line) {
  Colours<Group> colours;
  std::vector<Triangles> taken;  // by each colour
  for (const Group& group : contact_groups(line)) {
    const Triangles own = triangles_of(setting.stars, group);
    const std::size_t colour = free_colour(taken, own);
    colours.resize(std::max(colours.size(), colour + 1));
    taken.resize(colours.size());
    taken[colour].insert(own.begin(), own.end());
    colours[colour].push_back(group);
  }
  return colours;
}

/// 1 for the vertices in groups.
std::vector<char> grouped_vertices(int vertex_count,
                                   const Colours<Group>& groups) {
  std::vector<char> in_group(vertex_count, 0);
  for (const auto& colour : groups)
    for (const Group& group : colour)
      for (int v : group) in_group[v] = 1;
  return in_group;
}

/// The vertices by colours, those in the groups left out.
Colours<int> other_vertices(const StarSetting& setting,
                            const Colours<Group>& groups) {
  const std::vector<char> in_group =
      grouped_vertices(setting.space.mesh.vertex_count(), groups);
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
    combine(sweep, {1 + step[0], step[1]}, M);
    return fall;
  }

 private:
  void combine(const VectorXd& sweep, const Vector2d& combined,
               const Matrix2d& M) {
    direction_ = combined[0] * sweep + combined[1] * direction_;
    square_ = combined.dot(M * combined);
  }

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

/// e^2 from sweep to sweep.
class Descent {
 public:
  Descent(double elastic, double on_contact)
      : first_(elastic + std::abs(on_contact)), square_(elastic + on_contact) {}

  /// Takes the fall of a sweep off. @return whether the next one is worth its time
  bool goes_on(double fall, double tightness) {
    if (fall <= rounding * first_) return false;
    const double e_before = e();
    square_ -= fall;
    return e_before - e() >= tightness * e_before;
  }

 private:
  double e() const { return std::sqrt(std::max(square_, 0.0)); }

  /// A sweep that lowers e^2 by less than this part of what it was at first changes no
  /// digit of it: the rest is rounding.
  static constexpr double rounding = 1e-15;

  double first_, square_;
};

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
  const Colours<Group> on_contact =
      contact ? coloured_groups(setting, contact->line) : Colours<Group>{};
  const Colours<int> others = other_vertices(setting, on_contact);
  VectorXd airy = VectorXd::Zero(setting.space.unknowns());
  Acceleration accelerate;
  Descent descent(elastic_square(setting), contact_square(contact));
  std::vector<double> falls;
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
    VectorXd before = airy;
    double fall = relax_all(setting, others, airy, contact);
    fall += accelerate(setting, std::move(before), airy);
    fall += relax_all(setting, on_contact, airy, contact);
    falls.push_back(fall);
    if (!descent.goes_on(fall, settings.tightness)) break;
  }
  add_airy_loads(setting.space, airy, difference);
  return falls;
}

}  // namespace ffcontact
