// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/boundary_corrections.hpp"

#include <utility>

#include "ffcontact/contact/law/cone_correction.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"

namespace ffcontact {

namespace {

/// Homogeneous linear conditions on the corrections of a group.
class Conditions {
 public:
  Conditions(const StarGroup& group, const FreeContact* contact)
      : rows_(MatrixXd::Zero(
            16 * group.ridge.size() + (contact ? contact->kept_work.cols() : 0),
            group.unknowns())) {}

  /// component . moment does not change at either end.
  void fix(const BoundarySpoke& spoke, const Vector2d& component) {
    for (int end = 0; end < 2; ++end)
      spoke.spread(component.transpose() * spoke.moments.middleRows<2>(2 * end),
                   rows_.row(count_++));
  }
  /// Both bodies feel opposite forces.
  void balance(const BoundarySpoke& one, const BoundarySpoke& other) {
    one.spread(one.moments, rows_.middleRows<4>(count_));
    other.spread(other.moments, rows_.middleRows<4>(count_));
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
    if (boundary.known(c, spoke.edge)) conditions.fix(spoke, Vector2d::Unit(c));
  const auto direction = boundary.known_direction.find(spoke.edge);
  if (direction != boundary.known_direction.end())
    conditions.fix(spoke, direction->second);
}

/// On a contact edge: is the body of the spoke the one with the multipliers?
bool carries_multipliers(const BoundarySpoke& spoke, int contact_edge,
                         const FreeContact& contact) {
  return contact.line.edge[contact_edge] == spoke.edge;
}

/// Both bodies of a contact edge are loaded oppositely.
void balance_bodies(const BoundarySpoke& spoke,
                    const std::vector<BoundarySpoke>& spokes, int e,
                    const FreeContact& contact, Conditions& conditions) {
  for (const BoundarySpoke& other : spokes)
    if (other.edge != spoke.edge && free_edge(other, &contact) == e)
      conditions.balance(spoke, other);
}

/// z at the vertex of a spoke on a contact edge, then at the other end.
Vector4d along_spoke(const BoundarySpoke& spoke, int e, const ContactLine& line,
                     const Ref<const VectorXd>& z) {
  Vector4d values;
  for (int end = 0; end < 2; ++end) {
    const int place = spoke.runs_along_edge ? end : 1 - end,
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
        along_spoke(spoke, e, contact.line, z).transpose() * spoke.moments;
    terms += work.norm();
    spoke.spread(work, row);
  }
  conditions.add(row, terms);
}

/// Of an edge by its unknowns at a vertex, its first end first.
Matrix4d moments_by_unknowns(const FacetTopology<2>& topology, int edge,
                             int ridge) {
  Matrix4d moments = wrench_basis<2>(topology.facet_corners(edge));
  moments.leftCols<3>() *= wrench_shift<2>(topology, edge, ridge).matrix();
  return moments;
}

/// @param first  unknown of the star
/// @param place  of the edge among those around the vertex
BoundarySpoke boundary_spoke(const FacetTopology<2>& topology, int ridge,
                             int first, int place) {
  const int edge = topology.ridges.facets_of(ridge)[place],
            vertex = topology.ridges.vertices(0, ridge);
  BoundarySpoke spoke{edge,
                      topology.facets.vertices(0, edge) == vertex,
                      moments_by_unknowns(topology, edge, ridge),
                      {first, first + 1, first + 2, first + 3 + place}};
  if (!spoke.runs_along_edge)
    spoke.moments.topRows<2>().swap(spoke.moments.bottomRows<2>());
  return spoke;
}

}  // namespace

StarGroup::StarGroup(const FacetTopology<2>& topology, std::vector<int> ridges)
    : ridge(std::move(ridges)), first(1, 0) {
  for (int r : ridge) {
    const auto around = topology.ridges.facets_of(r);
    for (int place = 0; place < around.size(); ++place)
      if (topology.facets.on_boundary(around[place]))
        spokes.push_back(boundary_spoke(topology, r, first.back(), place));
    first.push_back(first.back() + unknowns_around<2>(topology.ridges, r));
  }
}

int free_edge(const BoundarySpoke& spoke, const FreeContact* contact) {
  return contact ? contact->tractions.contact_edge[spoke.edge] : -1;
}

int own_edge(const BoundarySpoke& spoke, const FreeContact& contact) {
  const int e = free_edge(spoke, &contact);
  return e >= 0 && carries_multipliers(spoke, e, contact) ? e : -1;
}

MatrixXd admissible_corrections(const StarGroup& group,
                                const BoundaryTractions& boundary,
                                const FreeContact* contact) {
  Conditions conditions(group, contact);
  for (const BoundarySpoke& spoke : group.spokes) {
    const int e = free_edge(spoke, contact);
    if (e < 0) {
      fix_known(spoke, boundary, conditions);
    } else if (carries_multipliers(spoke, e, *contact)) {
      if (frictionless(*contact, e))
        conditions.fix(spoke, contact->line.edge_tangent(e));
      balance_bodies(spoke, group.spokes, e, *contact, conditions);
    }
  }
  for (Index k = 0; contact && k < contact->kept_work.cols(); ++k)
    keep_work(group.spokes, *contact, contact->kept_work.col(k),
              group.unknowns(), conditions);
  return conditions.kernel();
}

}  // namespace ffcontact
