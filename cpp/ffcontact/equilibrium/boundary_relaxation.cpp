// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/boundary_relaxation.hpp"

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
    const auto columns = star.columns_of_spoke(number);
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

/// Known boundary tractions are left alone.
void fix_known(const Spoke& spoke, const BoundaryTractions& boundary,
               Conditions& conditions) {
  for (int c = 0; c < 2; ++c)
    if (boundary.known(c, spoke.edge()))
      conditions.fix(spoke, Vector2d::Unit(c));
}

/// Both bodies of a contact edge are loaded oppositely.
void balance_bodies(const Spoke& spoke, const std::vector<Spoke>& spokes, int e,
                    const FreeContact& contact, Conditions& conditions) {
  for (const Spoke& other : spokes)
    if (other.edge() != spoke.edge() && free_edge(other, &contact) == e)
      conditions.balance(spoke, other);
}

/// Basis of the corrections of known and of contact tractions that are allowed
/// [unknowns x n].
MatrixXd admissible_corrections(const Group& group,
                                const BoundaryTractions& boundary,
                                const FreeContact* contact) {
  Conditions conditions(group);
  const std::vector<Spoke> spokes = boundary_spokes(group);
  for (const Spoke& spoke : spokes) {
    const int e = free_edge(spoke, contact);
    if (e < 0) {
      fix_known(spoke, boundary, conditions);
    } else if (carries_multipliers(spoke, e, *contact)) {
      if (frictionless(*contact, e))
        conditions.fix(spoke, contact->line.edge_tangent(e));
      balance_bodies(spoke, spokes, e, *contact, conditions);
    }
  }
  return conditions.kernel();
}

/// The densities that the four unknowns of a spoke have on an edge, at its vertex and at
/// the other end.
Matrix4d spoke_densities(const Spoke& spoke, double length) {
  const Matrix4d moments = spoke.moments();
  Matrix4d density;
  for (int c = 0; c < 4; ++c)
    density.col(c) = density_of_moments(moments.col(c), length);
  return density;
}

/// What the corrections of a group do to the end values (r_n,i, r_t,i, r_n,j, r_t,j) of
/// one free contact edge.
struct EdgeEnds {
  int edge;
  Matrix<double, 4, Dynamic> change;  ///< [4 x unknowns]

  EdgeEnds(const Spoke& spoke, int e, const ContactLine& line, int unknowns)
      : edge(e) {
    const Matrix2d frame = edge_frame(line, e);
    const Matrix4d density = spoke_densities(spoke, line.length[e]);
    change.setZero(4, unknowns);
    for (int end = 0; end < 2; ++end) {
      const int place = spoke.runs_along_edge() ? end : 1 - end;
      spoke.spread(frame * density.middleRows<2>(2 * place),
                   change.middleRows<2>(2 * end));
    }
  }
};

std::vector<EdgeEnds> free_ends(const Group& group,
                                const FreeContact& contact) {
  std::vector<EdgeEnds> ends;
  for (const Spoke& spoke : boundary_spokes(group)) {
    const int e = free_edge(spoke, &contact);
    if (e >= 0 && carries_multipliers(spoke, e, contact))
      ends.emplace_back(spoke, e, contact.line, group.unknowns());
  }
  return ends;
}

/// Cost and cone of the free ends as functions of the corrections.
struct ContactTerms {
  VectorXd cost;  ///< linear part of e^2
  MatrixXd C;
  VectorXd d;
  Index rows = 0;

  void add(const EdgeEnds& ends, const FreeContact& contact) {
    const auto& [e, change] = ends;
    const FreeTractions& tractions = contact.tractions;
    const EdgeCone cone = edge_cone(contact.line, contact.law, e);
    cost += change.transpose() * interleaved(tractions.normal_cost.col(e),
                                             tractions.tangential_cost.col(e));
    C.middleRows(rows, cone.C.rows()) = cone.C * change;
    d.segment(rows, cone.d.size()) =
        // r is inside: the rest is rounding
        (cone.d - cone.C * end_values(tractions.densities, e)).cwiseMin(0);
    rows += cone.d.size();
  }
};

ContactTerms contact_terms(const std::vector<EdgeEnds>& ends, int unknowns,
                           const FreeContact* contact) {
  const auto most = EdgeCone::most_rows * static_cast<Index>(ends.size());
  ContactTerms terms{VectorXd::Zero(unknowns), MatrixXd(most, unknowns),
                     VectorXd(most)};
  for (const EdgeEnds& of_edge : ends) terms.add(of_edge, *contact);
  terms.C.conservativeResize(terms.rows, Eigen::NoChange);
  terms.d.conservativeResize(terms.rows);
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

/// By how much corrections y change e^2: y'Hy + slope'y.
struct EnergyChange {
  MatrixXd H;
  VectorXd slope;

  double fall(const VectorXd& y) const { return -y.dot(H * y) - y.dot(slope); }
};

EnergyChange energy_change(const StarSetting& setting, const Group& group,
                           const VectorXd& airy, const VectorXd& cost) {
  EnergyChange change{MatrixXd::Zero(cost.size(), cost.size()), cost};
  auto& [H, slope] = change;
  for (std::size_t s = 0; s < group.stars.size(); ++s) {
    const StarEnergy<Dynamic> energy(setting, group.stars[s].vertex(), airy);
    const Index first = group.first[s], size = energy.g.size();
    H.block(first, first, size, size) =
        energy.H.selfadjointView<Eigen::Lower>();
    slope.segment(first, size) += 2 * energy.g;
  }
  return change;
}

/// y = Z x that lowers e^2 most inside the cone.
std::optional<VectorXd> best_corrections(const EnergyChange& change,
                                         const MatrixXd& Z,
                                         ContactTerms terms) {
  restrict(Z, terms);
  const auto x =
      quadratic_minimum(2 * Z.transpose() * change.H * Z,
                        Z.transpose() * change.slope, terms.C, terms.d);
  if (!x) return std::nullopt;
  return Z * *x;
}

void add_corrections(const StarSetting& setting, const Group& group,
                     const VectorXd& y, VectorXd& airy) {
  for (std::size_t s = 0; s < group.stars.size(); ++s) {
    const StarCorrections& star = group.stars[s];
    add_corrections(setting.space, setting.stars, star.vertex(),
                    y.segment(group.first[s], star.unknowns()), airy);
  }
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
  const ContactTerms terms = contact_terms(ends, group.unknowns(), contact);
  const EnergyChange energy = energy_change(setting, group, airy, terms.cost);
  const auto y = best_corrections(energy, Z, terms);
  const double fall = y ? energy.fall(*y) : 0;
  if (!(fall > 0)) return 0;

  add_corrections(setting, group, *y, airy);
  for (const auto& [e, change] : ends) {
    ContactDensities& densities = contact->tractions.densities;
    set_end_values(densities, e, end_values(densities, e) + change * *y);
  }
  return fall;
}

MatrixXd corrections_with_known_tractions(const StarSetting& setting,
                                          int vertex) {
  return admissible_corrections(Group(setting, {vertex}), setting.boundary,
                                nullptr);
}

}  // namespace ffcontact
