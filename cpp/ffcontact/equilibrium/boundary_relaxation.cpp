// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/boundary_relaxation.hpp"

#include <algorithm>
#include <map>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/base/quadratic_minimum.hpp"
#include "ffcontact/equilibrium/star_corrections.hpp"

namespace ffcontact {

namespace {

/// A condition that corrections change by less than this part of what they could is not
/// changed by them: coordinates far from the origin are known to little more.
constexpr double negligible = 1e-10;

/// The vertices that are relaxed together: one, or those that contact edges join across
/// two bodies. The unknowns of their stars follow each other.
struct Group {
  std::vector<StarCorrections> stars;
  std::vector<int> first;  ///< unknown of each star, and the number of all

  Group(const StarSetting& setting, const std::vector<int>& vertices)
      : first(1, 0) {
    for (int v : vertices) {
      stars.emplace_back(setting.space, setting.stars, v);
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
  /// The outward normal is to the right of the first spoke and to the left of the last
  /// one, which runs against its edge.
  bool runs_along_edge() const { return number == 0; }
  /// Moments of the traction at the vertex and at the other end for the four unknowns of
  /// the spoke.
  Matrix4d moments() const {
    return (runs_along_edge() ? 1 : -1) * star.moments(number);
  }
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
    for (int k : {0, group.stars[s].spoke_count() - 1})
      spokes.push_back({group.stars[s], k, group.first[s]});
  return spokes;
}

/// The contact edge that a boundary spoke is on either body, or -1.
int free_edge(const Spoke& spoke, const FreeContact* contact) {
  return contact ? contact->tractions.contact_edge[spoke.edge()] : -1;
}

bool carries_multipliers(const Spoke& spoke, int contact_edge,
                         const FreeContact& contact) {
  return contact.line.edge[contact_edge] == spoke.edge();
}

/// Homogeneous linear conditions on the corrections of a group.
class Conditions {
 public:
  Conditions(const Group& group)
      : rows_(MatrixXd::Zero(16 * group.stars.size(), group.unknowns())) {}

  /// component . moment does not change at either end: psi_i and psi_m vanish exactly
  /// when b_i and b_j do.
  void fix(const Spoke& spoke, const Vector2d& component) {
    for (int end = 0; end < 2; ++end)
      spoke.spread(
          component.transpose() * spoke.moments().middleRows<2>(2 * end),
          rows_.row(count_++));
  }
  /// Both bodies feel opposite forces.
  void balance(const Spoke& one, const Spoke& other) {
    one.spread(one.moments(), rows_.middleRows<4>(count_));
    other.spread(other.moments(), rows_.middleRows<4>(count_));
    count_ += 4;
  }
  MatrixXd kernel() const {
    if (count_ == 0) return MatrixXd::Identity(rows_.cols(), rows_.cols());
    return kernel_basis(rows_.topRows(count_), {negligible});
  }

 private:
  MatrixXd rows_;
  Index count_ = 0;
};

/// Where friction may vanish at an end of the edge, r_t is left as it is.
bool frictionless(const FreeContact& contact, int e) {
  const ConesAtEnds cones = least_cones(contact.line, contact.law, e);
  return cones[0].frictionless() || cones[1].frictionless();
}

/// Basis of the corrections that leave known boundary tractions alone and load both
/// bodies of a contact edge oppositely [unknowns x n].
MatrixXd admissible_corrections(const Group& group,
                                const BoundaryTractions& boundary,
                                const FreeContact* contact) {
  Conditions conditions(group);
  const std::vector<Spoke> spokes = boundary_spokes(group);
  for (const Spoke& spoke : spokes) {
    const int e = free_edge(spoke, contact);
    if (e < 0) {
      for (int c = 0; c < 2; ++c)
        if (boundary.known(c, spoke.edge()))
          conditions.fix(spoke, Vector2d::Unit(c));
    } else if (carries_multipliers(spoke, e, *contact)) {
      if (frictionless(*contact, e))
        conditions.fix(spoke, contact->line.edge_tangent(e));
      for (const Spoke& other : spokes)
        if (other.edge() != spoke.edge() && free_edge(other, contact) == e)
          conditions.balance(spoke, other);
    }
  }
  return conditions.kernel();
}

/// What the corrections of a group do to the end values (r_n,i, r_t,i, r_n,j, r_t,j) of
/// one free contact edge.
struct EdgeEnds {
  int edge;
  Matrix<double, 4, Dynamic> change;  ///< [4 x unknowns]
};

std::vector<EdgeEnds> free_ends(const Group& group,
                                const FreeContact& contact) {
  std::vector<EdgeEnds> result;
  for (const Spoke& spoke : boundary_spokes(group)) {
    const int e = free_edge(spoke, &contact);
    if (e < 0 || !carries_multipliers(spoke, e, contact)) continue;
    Matrix2d frame;
    frame << contact.line.edge_normal(e).transpose(),
        contact.line.edge_tangent(e).transpose();
    const Matrix4d moments = spoke.moments();
    Matrix4d density;
    for (int c = 0; c < 4; ++c)
      density.col(c) =
          density_of_moments(moments.col(c), contact.line.length[e]);
    EdgeEnds ends{e, {}};
    ends.change.setZero(4, group.unknowns());
    for (int end = 0; end < 2; ++end)
      spoke.spread(frame * density.middleRows<2>(
                               2 * (spoke.runs_along_edge() ? end : 1 - end)),
                   ends.change.middleRows<2>(2 * end));
    result.push_back(ends);
  }
  return result;
}

/// Cost and cone of the free ends as functions of the corrections.
struct ContactTerms {
  VectorXd cost;  ///< linear part of e^2
  MatrixXd C;
  VectorXd d;
};

ContactTerms contact_terms(const std::vector<EdgeEnds>& ends, int unknowns,
                           const FreeContact* contact) {
  const auto most = EdgeCone::most_rows * static_cast<Index>(ends.size());
  ContactTerms terms{VectorXd::Zero(unknowns), MatrixXd(most, unknowns),
                     VectorXd(most)};
  Index row = 0;
  for (const auto& [e, change] : ends) {
    const FreeTractions& tractions = contact->tractions;
    const EdgeCone cone = edge_cone(contact->line, contact->law, e);
    terms.cost +=
        change.transpose() * interleaved(tractions.normal_cost.col(e),
                                         tractions.tangential_cost.col(e));
    terms.C.middleRows(row, cone.C.rows()) = cone.C * change;
    terms.d.segment(row, cone.d.size()) =
        // r is inside: the rest is rounding
        (cone.d - cone.C * end_values(tractions.densities, e)).cwiseMin(0);
    row += cone.d.size();
  }
  terms.C.conservativeResize(row, Eigen::NoChange);
  terms.d.conservativeResize(row);
  return terms;
}

/// The conditions on x for y = Z x, without those that no x can change.
void restrict(const MatrixXd& Z, ContactTerms& terms) {
  Index kept = 0;
  const MatrixXd C = terms.C * Z;
  const double size = Z.norm();
  for (Index row = 0; row < C.rows(); ++row)
    if (C.row(row).norm() > negligible * size * terms.C.row(row).norm()) {
      terms.d[kept] = terms.d[row];
      terms.C.row(kept++) = terms.C.row(row);
    }
  terms.C = (terms.C.topRows(kept) * Z).eval();
  terms.d.conservativeResize(kept);
}

}  // namespace

double relax_boundary(const StarSetting& setting,
                      const std::vector<int>& vertices, VectorXd& airy,
                      FreeContact* contact) {
  const Group group(setting, vertices);
  const MatrixXd Z = admissible_corrections(group, setting.boundary, contact);
  if (Z.cols() == 0) return 0;
  const std::vector<EdgeEnds> ends =
      contact ? free_ends(group, *contact) : std::vector<EdgeEnds>{};
  ContactTerms terms = contact_terms(ends, group.unknowns(), contact);
  restrict(Z, terms);

  MatrixXd H = MatrixXd::Zero(group.unknowns(), group.unknowns());
  VectorXd slope = terms.cost;
  for (std::size_t s = 0; s < group.stars.size(); ++s) {
    const StarEnergy<Dynamic> energy(setting, group.stars[s].vertex(), airy);
    H.block(group.first[s], group.first[s], energy.g.size(), energy.g.size()) =
        energy.H.selfadjointView<Eigen::Lower>();
    slope.segment(group.first[s], energy.g.size()) += 2 * energy.g;
  }
  const std::optional<VectorXd> x = quadratic_minimum(
      2 * Z.transpose() * H * Z, Z.transpose() * slope, terms.C, terms.d);
  if (!x) return 0;
  const VectorXd y = Z * *x;
  const double fall = -y.dot(H * y) - y.dot(slope);
  if (!(fall > 0)) return 0;
  for (std::size_t s = 0; s < group.stars.size(); ++s)
    add_corrections(setting.space, setting.stars, group.stars[s].vertex(),
                    y.segment(group.first[s], group.stars[s].unknowns()), airy);
  for (const auto& [e, change] : ends) {
    ContactDensities& densities = contact->tractions.densities;
    set_end_values(densities, e, end_values(densities, e) + change * y);
  }
  return fall;
}

MatrixXd corrections_with_known_tractions(const StarSetting& setting,
                                          int vertex) {
  return admissible_corrections(Group(setting, {vertex}), setting.boundary,
                                nullptr);
}

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
    visit_opposite(
        line, i, [&](int vertex, double) { join(vertex, groups.size() - 1); });
  }
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                              [](const auto& group) { return group.empty(); }),
               groups.end());
  return groups;
}

}  // namespace ffcontact
