// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed/layer_springs.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/condensed/condensed_rows.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/contact/residual_defect.hpp"
#include "ffcontact/contact/stated_contact.hpp"
#include "support/condensed.hpp"
#include "support/condensed_problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

Problem one_or_two_bodies(Random& random) {
  return random() % 2 ? cornered_body(random, Multiplier::force)
                      : facing_bodies(random, Multiplier::force);
}

CompliantLayer random_layer(Random& random) {
  CompliantLayer layer{std::pow(10.0, *real(-6, 2)),
                       std::pow(10.0, *real(-6, 2))};
  if (random() % 4 == 0) layer.normal = 0;
  if (random() % 4 == 0) layer.tangential = 0;
  return layer;
}

/// The relations without and with a layer, and multipliers.
struct OnLayer {
  Problem problem;
  Condensed rigid, layered;
  VectorXd compliance, P;
  ContactRows rows;  ///< without the layer

  OnLayer(const Problem& stated, const CompliantLayer& layer, Random& random)
      : problem(stated), rigid(stated), layered([&] {
          problem.law.layer = layer;
          return problem;
        }()) {
    const CondensedContact& contact = rigid.contact;
    compliance =
        nodal_compliance(layer, nodal_lengths(problem.line), 2, contact.held);
    rows = rows_of(
        contact,
        random_vector(static_cast<Index>(contact.primary.size()), random),
        random_vector(static_cast<Index>(contact.dependent.size()), random));
  }

  VectorXd v() const { return rows.v + compliance.cwiseProduct(rows.P); }
};

double off(const VectorXd& a, const VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / (1 + b.cwiseAbs().maxCoeff());
}

RC_GTEST_PROP(LayerSprings, are_in_series_with_the_bodies, (Random random)) {
  const OnLayer s(one_or_two_bodies(random), random_layer(random), random);
  const CondensedContact& contact = s.layered.contact;
  const VectorXd v = s.v();
  const ContactRows found =
      rows_of(contact, v(contact.primary), s.rows.P(contact.dependent));
  RC_ASSERT(off(found.P, s.rows.P) < 1e-8);
  RC_ASSERT(off(found.v, v) < 1e-8);
  const VectorXd u = displacement_of(contact, s.layered.stiffness, v, s.rows.P),
                 without = displacement_of(s.rigid.contact, s.rigid.stiffness,
                                           s.rows.v, s.rows.P);
  RC_ASSERT(off(u, without) < 1e-8);
}

/// A solution leaves nothing to correct, whatever its layer carries.
RC_GTEST_PROP(LayerSprings, that_carry_multipliers_are_in_equilibrium,
              (Random random)) {
  const OnLayer s(one_or_two_bodies(random), random_layer(random), random);
  CondensedContact contact = s.layered.contact;
  const ElasticSystem& system = s.layered.system;
  const ContactSettings settings;
  const StatedContact<2> stated =
      stated_on_line(s.problem.line, s.problem.law, system, settings);
  const VectorXd u =
      displacement_of(contact, s.layered.stiffness, s.v(), s.rows.P) +
      system.prescribed_value;
  put_carried(s.rows.P, contact);
  contact =
      with_loads(std::move(contact), s.layered.stiffness,
                 force_residual(system, u, VectorXd::Zero(system.dof_count())),
                 stated.v_of(u, s.rows.P));
  const VectorXd v = s.v();
  const ContactRows found =
      rows_of(contact, v(contact.primary), s.rows.P(contact.dependent));
  RC_ASSERT(off(found.P, s.rows.P) < 1e-7);
  RC_ASSERT(off(found.v, v) < 1e-7);
  const VectorXd change =
      displacement_of(contact, s.layered.stiffness, v, s.rows.P);
  RC_ASSERT(off(u + change, u) < 1e-7);
}

}  // namespace
}  // namespace ffcontact
