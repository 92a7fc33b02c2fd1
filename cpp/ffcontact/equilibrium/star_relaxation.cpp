// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_relaxation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ffcontact/base/quadratic_minimum.hpp"

namespace ffcontact {

namespace {

/// Everything the vertices need, fixed during the relaxation.
struct Setting {
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

Setting make_setting(const Mesh& mesh, const Edges& edges, const Stars& stars, const Hooke& hooke,
                     const BoundaryTractions& boundary, const BodyLoadsOfAll& body_loads) {
  Setting setting{mesh, edges, stars, boundary, std::vector<EnergyMatrix>(mesh.triangle_count()), {}};
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

/// The energy of the corrections of one star, y'Hy + 2 g'y. Stars of up to Max - 3 spokes need no memory of their own.
template <int Max>
struct StarEnergy {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, Max, Max> H;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, Max, 1> g;

  StarEnergy(const Setting& setting, const StarCorrections& star, const EdgeLoadsOfAll& difference) {
    const int n = star.unknowns();
    H.setZero(n, n);
    g.setZero(n);
    for (int k = 0; k < star.triangle_count(); ++k) {
      const int t = star.triangle(k);
      const Eigen::Matrix<double, 8, 5> loads = star.triangle_loads(k);
      const std::array<int, 8> rows = star.rows(k);
      const std::array<int, 5> columns = star.columns(k);
      const EdgeLoads gradient = setting.gradient(difference, t);
      Eigen::Matrix<double, 8, 8> A;
      Eigen::Matrix<double, 8, 1> gradient_rows;
      for (int c = 0; c < 8; ++c) {
        for (int r = 0; r < 8; ++r) A(r, c) = setting.energies[t](rows[r], rows[c]);
        gradient_rows[c] = gradient[rows[c]];
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

/// An inner vertex; returns by how much e^2 fell.
template <int Max>
double relax_inner(const Setting& setting, const StarCorrections& star, EdgeLoadsOfAll& difference) {
  StarEnergy<Max> energy(setting, star, difference);
  const auto llt = energy.H.template selfadjointView<Eigen::Lower>().llt();
  if (llt.info() != Eigen::Success) return 0;
  const Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, Max, 1> y = -llt.solve(energy.g);
  apply(star, y, difference);
  return -y.dot(energy.g);
}

/// The vertices that are relaxed together: one, or those that contact edges join across two bodies. The unknowns of their stars
/// follow each other.
struct Group {
  std::vector<StarCorrections> stars;
  std::vector<int> first;  ///< unknown of each star, and the number of all

  Group(const Setting& setting, const std::vector<int>& vertices) : first(1, 0) {
    for (int v : vertices) {
      stars.emplace_back(setting.mesh, setting.edges, setting.stars, v);
      first.push_back(first.back() + stars.back().unknowns());
    }
  }
  int unknowns() const { return first.back(); }
};

/// A boundary edge at the vertex of a star.
struct Spoke {
  const StarCorrections& star;
  int number;
  int first;  ///< unknown of the star

  int edge() const { return star.spoke(number); }
  /// The outward normal is to the right of the first spoke and to the left of the last one, which runs against its edge.
  bool runs_along_edge() const { return number == 0; }
  /// Moments of the traction at the vertex and at the other end for the four unknowns of the spoke.
  Eigen::Matrix4d moments() const { return (runs_along_edge() ? 1 : -1) * star.moments(number); }
  /// Adds the four columns of a matrix for the spoke's unknowns to one for all unknowns.
  template <class Local, class All>
  void spread(const Local& local, All&& all) const {
    const std::array<int, 4> columns = star.columns_of_spoke(number);
    for (int c = 0; c < 4; ++c) all.col(first + columns[c]) += local.col(c);
  }
};

std::vector<Spoke> boundary_spokes(const Group& group) {
  std::vector<Spoke> spokes;
  for (std::size_t s = 0; s < group.stars.size(); ++s)
    for (int k : {0, group.stars[s].spoke_count() - 1}) spokes.push_back({group.stars[s], k, group.first[s]});
  return spokes;
}

/// The contact edge that a boundary spoke is on either body, or -1.
int free_edge(const Spoke& spoke, const FreeContact* contact) {
  return contact ? contact->tractions.contact_edge[spoke.edge()] : -1;
}

bool carries_multipliers(const Spoke& spoke, int contact_edge, const FreeContact& contact) {
  return contact.line.edge[contact_edge] == spoke.edge();
}

/// Homogeneous linear conditions on the corrections of a group.
class Conditions {
 public:
  Conditions(const Group& group) : rows_(Eigen::MatrixXd::Zero(16 * group.stars.size(), group.unknowns())) {}

  /// component . moment does not change at either end: psi_i and psi_m vanish exactly when b_i and b_j do.
  void fix(const Spoke& spoke, const Eigen::Vector2d& component) {
    for (int end = 0; end < 2; ++end)
      spoke.spread(component.transpose() * spoke.moments().middleRows<2>(2 * end), rows_.row(count_++));
  }
  /// Both bodies feel opposite forces.
  void balance(const Spoke& one, const Spoke& other) {
    one.spread(one.moments(), rows_.middleRows<4>(count_));
    other.spread(other.moments(), rows_.middleRows<4>(count_));
    count_ += 4;
  }
  Eigen::MatrixXd kernel() const {
    if (count_ == 0) return Eigen::MatrixXd::Identity(rows_.cols(), rows_.cols());
    Eigen::FullPivLU<Eigen::MatrixXd> lu(rows_.topRows(count_));
    lu.setThreshold(1e-10);
    if (lu.dimensionOfKernel() == 0) return Eigen::MatrixXd(rows_.cols(), 0);
    return lu.kernel();
  }

 private:
  Eigen::MatrixXd rows_;
  Eigen::Index count_ = 0;
};

/// r_t = 0 on the whole edge.
bool frictionless(const FreeContact& contact, int e) {
  return cone_conditions(contact.law, contact.line.edge_node(0, e)).frictionless ||
         cone_conditions(contact.law, contact.line.edge_node(1, e)).frictionless;
}

/// Basis of the corrections that leave known boundary tractions alone and load both bodies of a contact edge oppositely
/// [unknowns x n].
Eigen::MatrixXd admissible_corrections(const Group& group, const BoundaryTractions& boundary,
                                       const FreeContact* contact) {
  Conditions conditions(group);
  const std::vector<Spoke> spokes = boundary_spokes(group);
  for (const Spoke& spoke : spokes) {
    const int e = free_edge(spoke, contact);
    if (e < 0) {
      for (int c = 0; c < 2; ++c)
        if (boundary.known(c, spoke.edge())) conditions.fix(spoke, Eigen::Vector2d::Unit(c));
    } else if (carries_multipliers(spoke, e, *contact)) {
      if (frictionless(*contact, e)) conditions.fix(spoke, contact->line.edge_tangent(e));
      for (const Spoke& other : spokes)
        if (other.edge() != spoke.edge() && free_edge(other, contact) == e) conditions.balance(spoke, other);
    }
  }
  return conditions.kernel();
}

/// What the corrections of a group do to the end values (r_n, r_t) of one free contact edge.
struct EdgeEnds {
  int edge;
  Eigen::Matrix<double, 2, Eigen::Dynamic> change[2];  ///< per end of the contact edge [2 x unknowns]
};

std::vector<EdgeEnds> free_ends(const Group& group, const FreeContact& contact) {
  std::vector<EdgeEnds> result;
  for (const Spoke& spoke : boundary_spokes(group)) {
    const int e = free_edge(spoke, &contact);
    if (e < 0 || !carries_multipliers(spoke, e, contact)) continue;
    Eigen::Matrix2d frame;
    frame << contact.line.edge_normal(e).transpose(), contact.line.edge_tangent(e).transpose();
    const Eigen::Matrix4d moments = spoke.moments();
    Eigen::Matrix4d density;
    for (int c = 0; c < 4; ++c) density.col(c) = density_of_moments(moments.col(c), contact.line.length[e]);
    EdgeEnds ends{e, {}};
    for (int end = 0; end < 2; ++end) {
      ends.change[end].setZero(2, group.unknowns());
      spoke.spread(frame * density.middleRows<2>(2 * (spoke.runs_along_edge() ? end : 1 - end)), ends.change[end]);
    }
    result.push_back(ends);
  }
  return result;
}

/// Cost and cone of the free ends as functions of the corrections.
struct ContactTerms {
  Eigen::VectorXd cost;  ///< linear part of e^2
  Eigen::MatrixXd C;
  Eigen::VectorXd d;
};

ContactTerms contact_terms(const std::vector<EdgeEnds>& ends, int unknowns, const FreeContact* contact) {
  const auto most = 6 * static_cast<Eigen::Index>(ends.size());
  ContactTerms terms{Eigen::VectorXd::Zero(unknowns), Eigen::MatrixXd(most, unknowns), Eigen::VectorXd(most)};
  Eigen::Index row = 0;
  for (const EdgeEnds& edge : ends)
    for (int end = 0; end < 2; ++end) {
      const FreeTractions& tractions = contact->tractions;
      const Eigen::Vector2d r(tractions.densities.normal(end, edge.edge),
                              tractions.densities.tangential(end, edge.edge));
      const Eigen::Vector2d cost(tractions.normal_cost(end, edge.edge), tractions.tangential_cost(end, edge.edge));
      const ConeConditions cone = cone_conditions(contact->law, contact->line.edge_node(end, edge.edge));
      terms.cost += edge.change[end].transpose() * cost;
      terms.C.middleRows(row, cone.C.rows()) = cone.C * edge.change[end];
      terms.d.segment(row, cone.d.size()) = (cone.d - cone.C * r).cwiseMin(0);  // r is inside: the rest is rounding
      row += cone.d.size();
    }
  terms.C.conservativeResize(row, Eigen::NoChange);
  terms.d.conservativeResize(row);
  return terms;
}

/// The conditions on x for y = Z x, without those that no x can change.
void restrict(const Eigen::MatrixXd& Z, ContactTerms& terms) {
  constexpr double rounding = 1e-13;
  Eigen::Index kept = 0;
  const Eigen::MatrixXd C = terms.C * Z;
  const double size = Z.norm();
  for (Eigen::Index row = 0; row < C.rows(); ++row)
    if (C.row(row).norm() > rounding * size * terms.C.row(row).norm()) {
      terms.d[kept] = terms.d[row];
      terms.C.row(kept++) = terms.C.row(row);
    }
  terms.C = (terms.C.topRows(kept) * Z).eval();
  terms.d.conservativeResize(kept);
}

/// Vertices on the boundary; free contact edges at them stay in the cone.
double relax(const Setting& setting, const std::vector<int>& vertices, EdgeLoadsOfAll& difference,
             FreeContact* contact) {
  const Group group(setting, vertices);
  const Eigen::MatrixXd Z = admissible_corrections(group, setting.boundary, contact);
  if (Z.cols() == 0) return 0;
  const std::vector<EdgeEnds> ends = contact ? free_ends(group, *contact) : std::vector<EdgeEnds>{};
  ContactTerms terms = contact_terms(ends, group.unknowns(), contact);
  restrict(Z, terms);

  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(group.unknowns(), group.unknowns());
  Eigen::VectorXd slope = terms.cost;
  for (std::size_t s = 0; s < group.stars.size(); ++s) {
    const StarEnergy<Eigen::Dynamic> energy(setting, group.stars[s], difference);
    H.block(group.first[s], group.first[s], energy.g.size(), energy.g.size()) = energy.H;
    slope.segment(group.first[s], energy.g.size()) += 2 * energy.g;
  }
  const std::optional<Eigen::VectorXd> x =
      quadratic_minimum(2 * Z.transpose() * H * Z, Z.transpose() * slope, terms.C, terms.d);
  if (!x) return 0;
  const Eigen::VectorXd y = Z * *x;
  const double fall = -y.dot(H * y) - y.dot(slope);
  if (!(fall > 0)) return 0;
  for (std::size_t s = 0; s < group.stars.size(); ++s)
    apply(group.stars[s], y.segment(group.first[s], group.stars[s].unknowns()), difference);
  for (const EdgeEnds& edge : ends)
    for (int end = 0; end < 2; ++end) {
      const Eigen::Vector2d change = edge.change[end] * y;
      contact->tractions.densities.normal(end, edge.edge) += change[0];
      contact->tractions.densities.tangential(end, edge.edge) += change[1];
    }
  return fall;
}

double relax(const Setting& setting, int vertex, EdgeLoadsOfAll& difference, FreeContact* contact) {
  constexpr int usual = 16;
  if (setting.stars.triangle_count(vertex) == 0) return 0;
  if (setting.stars.on_boundary(vertex)) return relax(setting, std::vector<int>{vertex}, difference, contact);
  const StarCorrections star(setting.mesh, setting.edges, setting.stars, vertex);
  return star.unknowns() <= usual ? relax_inner<usual>(setting, star, difference)
                                  : relax_inner<Eigen::Dynamic>(setting, star, difference);
}

/// What is relaxed, single vertices or groups of them, by colours: members of one colour share no triangle.
template <class Member>
using Colours = std::vector<std::vector<Member>>;

/// Vertices of a colour (about a millisecond of work) below which starting threads costs more than it saves.
constexpr std::size_t worth_threads = 500;

/// Relaxes colour by colour; returns by how much e^2 fell.
template <class Member>
double relax_all(const Setting& setting, const Colours<Member>& colours, EdgeLoadsOfAll& difference,
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

/// The vertices of each free contact node and what it faces, joined where nodes share a vertex.
std::vector<std::vector<int>> contact_groups(const ContactLine& line) {
  std::vector<std::vector<int>> groups;
  std::map<int, std::size_t> group_of;
  const auto join = [&](int vertex, std::size_t group) {
    const auto [place, is_new] = group_of.emplace(vertex, group);
    if (is_new) {
      groups[group].push_back(vertex);
    } else if (place->second != group) {
      const std::size_t old = place->second;
      for (int v : groups[old]) {
        group_of[v] = group;
        groups[group].push_back(v);
      }
      groups[old].clear();
    }
  };
  for (int i = 0; i < line.node_count(); ++i) {
    groups.emplace_back();
    join(line.vertex[i], groups.size() - 1);
    visit_opposite(line, i, [&](int vertex, double) { join(vertex, groups.size() - 1); });
  }
  groups.erase(std::remove_if(groups.begin(), groups.end(), [](const auto& group) { return group.empty(); }),
               groups.end());
  return groups;
}

/// Groups of contact vertices, coloured greedily in the order of the line.
Colours<std::vector<int>> coloured_groups(const Setting& setting, const ContactLine& line) {
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
Colours<int> other_vertices(const Setting& setting, const Colours<std::vector<int>>& groups) {
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
double square_of_error(const Setting& setting, const BodyLoadsOfAll& body_loads, const EdgeLoadsOfAll& difference,
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
  double operator()(const Setting& setting, EdgeLoadsOfAll&& sweep, EdgeLoadsOfAll& difference) {
    if (direction_.cols() == 0) direction_ = EdgeLoadsOfAll::Zero(12, sweep.cols());
    Eigen::Matrix<double, 5, Eigen::Dynamic> parts(5, sweep.cols());  // d'Ad, d'Ap, p'Ap, d'g, p'g
#pragma omp parallel for
    for (Eigen::Index t = 0; t < sweep.cols(); ++t) {
      const EdgeLoads d = sweep.col(t), p = direction_.col(t), g = setting.gradient(difference, static_cast<int>(t));
      const EdgeLoads A_d = setting.energies[t].lazyProduct(d), A_p = setting.energies[t].lazyProduct(p);
      parts.col(t) << d.dot(A_d), p.dot(A_d), p.dot(A_p), d.dot(g), p.dot(g);
    }
    const Eigen::Matrix<double, 5, 1> sum = parts.rowwise().sum();
    Eigen::Matrix2d M;
    M << sum[0], sum[1], sum[1], sum[2];
    const Eigen::Vector2d slope(sum[3], sum[4]);
    const Eigen::Vector2d step = -M.completeOrthogonalDecomposition().solve(slope);
    const double fall = -step.dot(M * step) - 2 * step.dot(slope);
    if (!(fall > 0)) return 0;
    difference += step[0] * sweep + step[1] * direction_;
    direction_ *= step[1];
    direction_ += (1 + step[0]) * sweep;
    return fall;
  }

 private:
  EdgeLoadsOfAll direction_;
};

}  // namespace

TriangleCorners corners_of(const Mesh& mesh, int triangle) {
  TriangleCorners corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = mesh.corner(triangle, k);
  return corners;
}

EdgeLoadsOfAll difference_loads(const Mesh& mesh, const Edges& edges, const EdgeMoments& moments,
                                const Eigen::Ref<const Eigen::Matrix3Xd>& stress) {
  EdgeLoadsOfAll loads(12, mesh.triangles.cols());
#pragma omp parallel for
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int edge = edges.of_triangle(k, t);
      const double eta = edges.eta(k, t);
      const Eigen::Vector4d b = eta * moments.col(edge);
      const Eigen::Vector2d side = eta * edge_vector(mesh, edges, edge);  // from vertex k+1 to k+2
      const Eigen::Vector2d half = 0.5 * traction(stress.col(t), Eigen::Vector2d(side.y(), -side.x()));
      loads.block<2, 1>(4 * k, t) = (eta > 0 ? b.head<2>() : b.tail<2>()) - half;
      loads.block<2, 1>(4 * k + 2, t) = (eta > 0 ? b.tail<2>() : b.head<2>()) - half;
    }
  return loads;
}

void take_known_tractions(const Mesh& mesh, const Edges& edges, const BoundaryTractions& boundary,
                          const Eigen::Ref<const Eigen::Matrix3Xd>& stress, EdgeLoadsOfAll& difference) {
  for (int edge = 0; edge < edges.count(); ++edge) {
    if (!edges.on_boundary(edge)) continue;
    const int t = edges.triangles(0, edge);
    int k = 0;
    while (edges.of_triangle(k, t) != edge) ++k;
    const Eigen::Vector2d side = edge_vector(mesh, edges, edge);
    const Eigen::Vector2d half = 0.5 * traction(stress.col(t), Eigen::Vector2d(side.y(), -side.x()));
    for (int end = 0; end < 2; ++end)
      for (int c = 0; c < 2; ++c)
        if (boundary.known(c, edge)) difference(4 * k + 2 * end + c, t) = boundary.moments(2 * end + c, edge) - half[c];
  }
}

std::vector<double> relax_stars(const Mesh& mesh, const Edges& edges, const Stars& stars, const Hooke& hooke,
                                const BoundaryTractions& boundary, const BodyLoadsOfAll& body_loads,
                                const RelaxationSettings& settings, EdgeLoadsOfAll& difference, FreeContact* contact) {
  const Setting setting = make_setting(mesh, edges, stars, hooke, boundary, body_loads);
  const Colours<std::vector<int>> on_contact =
      contact ? coloured_groups(setting, contact->line) : Colours<std::vector<int>>{};
  const Colours<int> others = other_vertices(setting, on_contact);
  Acceleration accelerate;
  std::vector<double> falls;
  double square = settings.tightness > 0 ? square_of_error(setting, body_loads, difference, hooke, contact) : 0;
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
    EdgeLoadsOfAll change = -difference;
    double fall = relax_all(setting, others, difference, contact);
    change += difference;
    fall += accelerate(setting, std::move(change), difference);
    fall += relax_all(setting, on_contact, difference, contact);
    falls.push_back(fall);
    const double e_before = std::sqrt(std::max(square, 0.0)), e_after = std::sqrt(std::max(square - fall, 0.0));
    square -= fall;
    if (e_before - e_after < settings.tightness * e_before) break;
  }
  return falls;
}

}  // namespace ffcontact
