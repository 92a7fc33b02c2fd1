// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/contact_star.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/cone/inner_cone.hpp"
#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/minimum/quadratic_minimum.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Conditions on the corrections of an edge that depend on others but for this part.
constexpr PivotThreshold dependent_on_others{1e-9};
/// Tractions outside the cone by this part of the largest are in it but for rounding,
/// which contact_faces takes off. Less, and the digits of sums say which stars stay.
constexpr double cone_rounding = 1e-12;

/// Tractions at the vertices of a contact face from its nine unknowns.
Matrix9d tractions_of_unknowns(const Topology<3>& topology,
                               const ContactFace& face) {
  const Matrix3d corners =
      facet_points(topology.mesh, topology.facets, face.face);
  Matrix9d tractions = wrench_basis<3>(corners);
  for (int k = 0; k < 9; ++k)
    tractions.col(k) =
        traction_of(face, tractions.col(k).reshaped(3, 3)).reshaped();
  return tractions;
}

/// The same of the face at one place around an edge from the outside unknowns of a joint.
MatrixXd tractions_of_joint(const Topology<3>& topology,
                            const ContactFace& face,
                            const JointEdge::Part& part, int place,
                            const std::vector<int>& outside, int size) {
  const Matrix9d of_face = tractions_of_unknowns(topology, face);
  MatrixXd tractions(9, outside.size());
  for (Index j = 0; j < tractions.cols(); ++j)
    tractions.col(j) =
        of_face * at_place<3>(topology, part.edge, place,
                              part.of(VectorXd::Unit(size, outside[j])));
  return tractions;
}

/// Half the slope of the contact part of e^2 by the tractions at the vertices.
Matrix3d contact_slope(const ContactFace& face, const Matrix3d& traction) {
  Matrix3d slope = face.work;
  for (int i = 0; i < 3; ++i)
    if (!face.paid[i].at_limit(traction(0, i)))
      slope(0, i) -= face.paid[i].friction * face.slip[i];
  return slope;
}

/// x that leave known tractions alone, and r_t = 0 where there is no friction.
/// @param P  tractions at the vertices of each contact face by x
MatrixXd free_basis(const MatrixXd& conditions, const std::vector<MatrixXd>& P,
                    const std::vector<const ContactFace*>& faces) {
  MatrixXd rows = conditions;
  for (std::size_t k = 0; k < P.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      if (!faces[k]->cone[i].frictionless()) continue;
      rows.conservativeResize(rows.rows() + 2, conditions.cols());
      // a moment, as the others
      rows.bottomRows<2>() =
          faces[k]->area / 12 * P[k].middleRows<2>(3 * i + 1);
    }
  if (rows.rows() == 0)
    return MatrixXd::Identity(conditions.cols(), conditions.cols());
  return kernel_basis(rows, dependent_on_others);
}

}  // namespace

ContactStar::ContactStar(const Topology<3>& topology, JointEdge joint,
                         const KnownComponents& known,
                         const FacetForms<3>& forms,
                         const std::vector<ContactFace>& contact,
                         const std::vector<int>& contact_index)
    : joint_(std::move(joint)) {
  find_places(topology);
  find_basis(topology, known, contact, contact_index);
  if (is_free()) reduce(joint_form(topology, joint_, forms));
}

void ContactStar::find_places(const Topology<3>& topology) {
  Flags is_outside(joint_.size, 0);
  std::fill_n(is_outside.begin(), 6, 1);
  for (const auto& [edge, place, sign] : joint_.parts) {
    const std::vector<int> faces = facets_around<3>(topology.ridges, edge);
    for (int i = 0; i < count_of(faces); ++i)
      for (int mode = 0; mode < 3; ++mode)
        if (topology.facets.on_boundary(faces[i]))
          is_outside[place[6 + 3 * i + mode]] = 1;
  }
  for (int i = 0; i < joint_.size; ++i)
    (is_outside[i] ? outside_ : inside_).push_back(i);
}

void ContactStar::find_basis(const Topology<3>& topology,
                             const KnownComponents& known,
                             const std::vector<ContactFace>& contact,
                             const std::vector<int>& contact_index) {
  for (const JointEdge::Part& part : joint_.parts) {
    const std::vector<int> faces = facets_around<3>(topology.ridges, part.edge);
    for (int i = 0; i < count_of(faces); ++i) {
      const int index = contact_index[faces[i]];
      if (index < 0) continue;
      faces_.push_back(&contact[index]);
      index_.push_back(index);
      P_.push_back(tractions_of_joint(topology, contact[index], part, i,
                                      outside_, joint_.size));
    }
  }
  const MatrixXd conditions = joint_conditions(topology, joint_, known);
  basis_ = free_basis(conditions(Eigen::all, outside_), P_, faces_);
  for (MatrixXd& P : P_) P = (P * basis_).eval();
}

void ContactStar::reduce(const MatrixXd& A) {
  A_inside_ = Cholesky(A(inside_, inside_));
  coupling_ = A(inside_, outside_) * basis_;
  S_ = basis_.transpose() * A(outside_, outside_) * basis_ -
       coupling_.transpose() * A_inside_.solve_columns(coupling_);
  S_factor_ = Cholesky(S_);
  if (!A_inside_.is_positive_definite() || !S_factor_.is_positive_definite())
    basis_.resize(basis_.rows(), 0);
}

VectorXd ContactStar::solve_inside(const VectorXd& b) const {
  return inside_.empty() ? b : A_inside_.solve(b);
}

ContactStar::Tractions ContactStar::moved(const Tractions& from,
                                          const VectorXd& t) const {
  Tractions to = from;
  for (std::size_t k = 0; k < to.size(); ++k)
    to[k] += (P_[k] * t).reshaped(3, 3);
  return to;
}

bool ContactStar::in_the_cone(const Tractions& tractions,
                              double largest) const {
  for (std::size_t k = 0; k < tractions.size(); ++k)
    if (cone_violation(*faces_[k], tractions[k]) > cone_rounding * largest)
      return false;
  return true;
}

double ContactStar::term(const Tractions& tractions) const {
  return sum_over(tractions.size(), [&](int k) {
    return contact_term(*faces_[k], tractions[k]);
  });
}

/// t with the least t'S t / 2 + slope't in the inner cones.
std::optional<VectorXd> ContactStar::least_in_cones(const VectorXd& slope,
                                                    const Tractions& from,
                                                    double largest) const {
  const auto vertices = static_cast<Index>(3 * from.size());
  MatrixXd C(vertices * InnerCone::most_rows, slope.size());
  VectorXd d(C.rows());
  Index rows = 0;
  for (std::size_t k = 0; k < from.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const InnerCone inner = inner_cone(faces_[k]->cone[i], from[k].col(i),
                                         -faces_[k]->direction.col(i), largest);
      const Index count = inner.d.size();
      C.middleRows(rows, count) = inner.C * P_[k].middleRows<3>(3 * i);
      d.segment(rows, count) = inner.d - inner.C * from[k].col(i);
      rows += count;
    }
  const auto t = quadratic_minimum(S_, slope, C.topRows(rows), d.head(rows));
  return t && in_the_cone(moved(from, *t), largest) ? t : std::nullopt;
}

std::optional<VectorXd> ContactStar::least(const VectorXd& slope,
                                           const Tractions& from,
                                           const Scales& scales) const {
  const VectorXd t = -S_factor_.solve(slope);
  if (-slope.dot(t) <= scales.least_fall) return std::nullopt;
  return in_the_cone(moved(from, t), scales.traction)
             ? t
             : least_in_cones(slope, from, scales.traction);
}

ContactStar::Change ContactStar::change(
    const VectorXd& g, const Scales& scales,
    std::vector<Matrix3d>& tractions) const {
  const VectorXd g_inside = g(inside_), first = -solve_inside(g_inside),
                 elastic = basis_.transpose() * g(outside_) +
                           coupling_.transpose() * first;
  Tractions from;
  VectorXd slope = elastic;
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    from.push_back(tractions[index_[k]]);
    slope += P_[k].transpose() * contact_slope(*faces_[k], from[k]).reshaped();
  }
  const std::optional<VectorXd> t = least(slope, from, scales);
  if (!t) return {};
  const Tractions to = moved(from, *t);
  Change change;
  change.fall = -g_inside.dot(first) - t->dot(2 * elastic + S_ * *t) -
                2 * (term(to) - term(from));
  if (!(change.fall > scales.least_fall)) return {};
  for (std::size_t k = 0; k < to.size(); ++k) tractions[index_[k]] = to[k];
  change.x.resize(g.size());
  change.x(outside_) = basis_ * *t;
  change.x(inside_) = first - solve_inside(coupling_ * *t);
  return change;
}

}  // namespace ffcontact
