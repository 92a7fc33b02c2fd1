// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/bounds/quantity.hpp"
#include "ffcontact/interface/weights_by_node.hpp"
#include "ffcontact/linear/norms.hpp"
//
#include "estimate/material_and_loads.hpp"

namespace ffcontact::plugin {

/// goalforce=: the work of what holds a body along a weight om,
///     l(u) = int sigma(u) : eps(om) - (loads of om),
/// sigma = C eps(u) + tau0: forces of supports, springs and contact on the body. Equilibrium
/// makes it the same for every om with these values where the body is held: here om is 0
/// inside.
template <int d>
class ForceWeight {
 public:
  explicit ForceWeight(const SolvedProblem<d>& solved)
      : mesh_(solved.topology.mesh),
        body_(solved.body),
        held_(solved.system.prescribed),
        weight_(VectorXd::Zero(solved.system.dof_count())) {
    hold_by_contact(solved.contact);
    hold_by_springs();
  }

  /// Reads om of a body at the vertices of its boundary. Facets that hold the body say what
  /// it is where others differ.
  /// @throws std::invalid_argument  naming the vertex of two such facets that differ
  void read(Stack stack, const BodyReader<d>& reader) {
    const auto list = reader.list("goalforce");
    for (int c = 0; c < d; ++c) {
      const MatrixXd values = along_boundary<d>(stack, list[c], reader.part(),
                                                MatrixOf<d>::Identity());
      for (const bool holding : {false, true}) put(reader, c, values, holding);
    }
  }

  /// Adds l.
  void add_to(Quantity<d>& goal) const {
    if (weight_.isZero(0)) return;
    goal.stress =
        goal.stress + LinearStresses<d>(stresses(mesh_, body_.hooke, weight_));
    const Quantity<d> loads{body_.body_loads, -1 * body_.initial,
                            body_.neumann};
    goal.constant -= load_of(mesh_, loads).dot(weight_);
  }

 private:
  void hold_by_contact(const LineOrSurface<d>& contact) {
    for (int i = 0; i < contact.node_count(); ++i) {
      const VectorOf<d> normal = contact.normal.col(i);
      hold(contact.vertex[i], normal);
      visit_opposite(contact, i, [&](int v, double) { hold(v, normal); });
    }
  }

  /// Without friction along the normal alone.
  void hold(int vertex, const VectorOf<d>& normal) {
    constexpr double least = 1e-9;
    for (int c = 0; c < d; ++c)
      if (has_friction() || std::abs(normal[c]) > least)
        held_[d * vertex + c] = 1;
  }

  bool has_friction() const { return body_.law.slip_bound.size() > 0; }

  void hold_by_springs() {
    for (Index f = 0; f < mesh_.boundary.cols(); ++f)
      if (body_.springs.on(f))
        for (const int v : mesh_.boundary.col(f))
          std::fill_n(held_.begin() + d * v, d, 1);
  }

  bool holds(Index facet, int c) const {
    const auto vertices = mesh_.boundary.col(facet);
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](int v) { return held_[d * v + c] != 0; });
  }

  /// Of component c on the facets that hold it, or on the others.
  /// @param values  [vertices x facets of the body]
  void put(const BodyReader<d>& reader, int c, const MatrixXd& values,
           bool holding) {
    constexpr double same = 1e-12;
    Flags known(weight_.size(), 0);
    const int first = reader.part().first_boundary;
    const double rounding = same * max_norm(values);
    for (Index f = 0; f < values.cols(); ++f) {
      if (holds(first + f, c) != holding) continue;
      for (int k = 0; k < d; ++k) {
        const int dof = d * mesh_.boundary(k, first + f) + c;
        if (holding && known[dof])
          require_same(reader, dof, values(k, f), rounding);
        known[dof] = 1;
        weight_[dof] = values(k, f);
      }
    }
  }

  void require_same(const BodyReader<d>& reader, int dof, double other,
                    double rounding) const {
    const double one = weight_[dof];
    if (std::abs(one - other) > rounding)
      refuse(reader.name("goalforce"), "= is ", one, " and ", other,
             " on two supports that meet at ", in_words(mesh_.place(dof / d)),
             ": such a force depends on the mesh; let the weight be the same "
             "on both there, as 0 at the end of one");
  }

  const SimplexMesh<d>& mesh_;
  const SolvedBody<d>& body_;
  Flags held_;       ///< by supports, springs or contact [dofs]
  VectorXd weight_;  ///< om [dofs]
};

}  // namespace ffcontact::plugin
