// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/contact_star.hpp"

#include <algorithm>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/quadratic_minimum.hpp"
#include "ffcontact/equilibrium/edge_form.hpp"
#include "ffcontact/equilibrium/inner_cone.hpp"

namespace ffcontact {

namespace {

/// Conditions on the corrections of an edge that depend on others but for this part.
constexpr PivotThreshold dependent_on_others{1e-9};
/// Tractions outside the cone by this part of the largest are in it but for rounding.
constexpr double cone_rounding = 1e-14;

/// Tractions at the vertices of a contact face from its nine unknowns.
Matrix9d tractions_of_unknowns(const SolidTopology& topology,
                               const ContactFace& face) {
  const Matrix3d corners = topology.mesh.vertices(
      Eigen::all, topology.faces.vertices.col(face.face));
  Matrix9d tractions = wrench_basis(corners);
  for (int k = 0; k < 9; ++k)
    tractions.col(k) =
        traction_of(face, tractions.col(k).reshaped(3, 3)).reshaped();
  return tractions;
}

/// Half the slope of the contact part of e^2 by the tractions at the vertices.
Matrix3d contact_slope(const ContactFace& face, const Matrix3d& traction) {
  Matrix3d slope = face.work;
  for (int i = 0; i < 3; ++i)
    if (!face.cone[i].at_limit(traction(0, i)))
      slope(0, i) -= face.cone[i].friction * face.slip[i];
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

ContactStar::ContactStar(const SolidTopology& topology, int edge,
                         const KnownComponents& known, const FaceForms& forms,
                         const std::vector<ContactFace>& contact,
                         const std::vector<int>& contact_index)
    : edge_(edge) {
  const auto& [mesh, faces, edges, stars] = topology;
  outside_ = {0, 1, 2, 3, 4, 5};
  for (int i = 0; i < edges.facet_count(edge); ++i) {
    const int face = edges.facet[edges.facet_start[edge] + i];
    auto& places = faces.on_boundary(face) ? outside_ : inside_;
    for (int bar = 0; bar < 3; ++bar) places.push_back(6 + 3 * i + bar);
    if (contact_index[face] < 0) continue;
    faces_.push_back(&contact[contact_index[face]]);
    index_.push_back(contact_index[face]);
    place_.push_back(i);
  }
  find_basis(topology, known);
  if (is_free()) reduce(edge_form(topology, edge, forms));
}

void ContactStar::find_basis(const SolidTopology& topology,
                             const KnownComponents& known) {
  const int size = unknowns_around(topology.edges, edge_);
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    const Matrix9d of_face = tractions_of_unknowns(topology, *faces_[k]);
    MatrixXd of_edge(9, count_of(outside_));
    for (Index j = 0; j < of_edge.cols(); ++j)
      of_edge.col(j) = of_face * at_place(topology, edge_, place_[k],
                                          VectorXd::Unit(size, outside_[j]));
    P_.push_back(of_edge);
  }
  const MatrixXd conditions = edge_conditions(topology, edge_, known);
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
  double sum = 0;
  for (std::size_t k = 0; k < tractions.size(); ++k)
    sum += contact_term(*faces_[k], tractions[k]);
  return sum;
}

/// t with the least t'S t / 2 + slope't in the inner cones.
std::optional<VectorXd> ContactStar::least_in_cones(const VectorXd& slope,
                                                    const Tractions& from,
                                                    double largest) const {
  MatrixXd C(6 * InnerCone::most_rows, slope.size());
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
