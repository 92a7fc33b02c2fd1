// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/boundary_corrections.hpp"

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/contact/cone_correction.hpp"

namespace ffcontact {

namespace {

/// Homogeneous linear conditions on the corrections of a group.
class Conditions {
 public:
  Conditions(const StarGroup& group, const FreeContact* contact)
      : rows_(MatrixXd::Zero(
            16 * group.stars.size() + (contact ? contact->kept_work.cols() : 0),
            group.unknowns())) {}

  /// component . moment does not change at either end: psi_i and psi_m vanish exactly
  /// when b_i and b_j do.
  void fix(const BoundarySpoke& spoke, const Vector2d& component) {
    for (int end = 0; end < 2; ++end)
      spoke.spread(
          component.transpose() * spoke.moments().middleRows<2>(2 * end),
          rows_.row(count_++));
  }
  /// Both bodies feel opposite forces.
  void balance(const BoundarySpoke& one, const BoundarySpoke& other) {
    one.spread(one.moments(), rows_.middleRows<4>(count_));
    other.spread(other.moments(), rows_.middleRows<4>(count_));
    count_ += 4;
  }
  /// row . corrections = 0, unless that is rounding of what it is summed from.
  void add(const Eigen::RowVectorXd& row, double terms) {
    if (row.norm() > negligible_change * terms) rows_.row(count_++) = row;
  }
  MatrixXd kernel() const {
    if (count_ == 0) return MatrixXd::Identity(rows_.cols(), rows_.cols());
    return kernel_basis(rows_.topRows(count_), {negligible_change});
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
void fix_known(const BoundarySpoke& spoke, const BoundaryTractions& boundary,
               Conditions& conditions) {
  for (int c = 0; c < 2; ++c)
    if (boundary.known(c, spoke.edge()))
      conditions.fix(spoke, Vector2d::Unit(c));
  const auto direction = boundary.known_direction.find(spoke.edge());
  if (direction != boundary.known_direction.end())
    conditions.fix(spoke, direction->second);
}

/// Both bodies of a contact edge are loaded oppositely.
void balance_bodies(const BoundarySpoke& spoke,
                    const std::vector<BoundarySpoke>& spokes, int e,
                    const FreeContact& contact, Conditions& conditions) {
  for (const BoundarySpoke& other : spokes)
    if (other.edge() != spoke.edge() && free_edge(other, &contact) == e)
      conditions.balance(spoke, other);
}

/// z at the vertex of a spoke on a contact edge, then at the other end.
Vector4d along_spoke(const BoundarySpoke& spoke, int e, const ContactLine& line,
                     const Ref<const VectorXd>& z) {
  Vector4d values;
  for (int end = 0; end < 2; ++end) {
    const int place = spoke.runs_along_edge() ? end : 1 - end,
              vertex = line.vertex[line.edge_node(end, e)];
    values.segment<2>(2 * place) = z.segment<2>(2 * vertex);
  }
  return values;
}

/// int r_hat . z does not change. But where a support takes part it does not anyway, as the
/// corrections of a star have no resultant.
void keep_work(const std::vector<BoundarySpoke>& spokes,
               const FreeContact& contact, const Ref<const VectorXd>& z,
               Index unknowns, Conditions& conditions) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(unknowns);
  double terms = 0;
  for (const BoundarySpoke& spoke : spokes) {
    const int e = own_edge(spoke, contact);
    if (e < 0) continue;
    const Eigen::RowVector4d work =
        along_spoke(spoke, e, contact.line, z).transpose() * spoke.moments();
    terms += work.norm();
    spoke.spread(work, row);
  }
  conditions.add(row, terms);
}

}  // namespace

std::vector<BoundarySpoke> boundary_spokes(const StarGroup& group) {
  std::vector<BoundarySpoke> spokes;
  for (std::size_t s = 0; s < group.stars.size(); ++s)
    for (int k : {0, group.stars[s].spoke_count() - 1})
      spokes.push_back({group.stars[s], k, group.first[s]});
  return spokes;
}

int free_edge(const BoundarySpoke& spoke, const FreeContact* contact) {
  return contact ? contact->tractions.contact_edge[spoke.edge()] : -1;
}

bool carries_multipliers(const BoundarySpoke& spoke, int contact_edge,
                         const FreeContact& contact) {
  return contact.line.edge[contact_edge] == spoke.edge();
}

int own_edge(const BoundarySpoke& spoke, const FreeContact& contact) {
  const int e = free_edge(spoke, &contact);
  return e >= 0 && carries_multipliers(spoke, e, contact) ? e : -1;
}

MatrixXd admissible_corrections(const StarGroup& group,
                                const BoundaryTractions& boundary,
                                const FreeContact* contact) {
  Conditions conditions(group, contact);
  const std::vector<BoundarySpoke> spokes = boundary_spokes(group);
  for (const BoundarySpoke& spoke : spokes) {
    const int e = free_edge(spoke, contact);
    if (e < 0) {
      fix_known(spoke, boundary, conditions);
    } else if (carries_multipliers(spoke, e, *contact)) {
      if (frictionless(*contact, e))
        conditions.fix(spoke, contact->line.edge_tangent(e));
      balance_bodies(spoke, spokes, e, *contact, conditions);
    }
  }
  for (Index k = 0; contact && k < contact->kept_work.cols(); ++k)
    keep_work(spokes, *contact, contact->kept_work.col(k), group.unknowns(),
              conditions);
  return conditions.kernel();
}

}  // namespace ffcontact
