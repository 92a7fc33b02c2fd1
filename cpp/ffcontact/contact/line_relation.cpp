// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/line_relation.hpp"

#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/active_set/active_set_system.hpp"
#include "ffcontact/contact/condensed_answer.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Is nothing loaded or moved, with a gap somewhere?
bool is_at_rest(const ContactLaw<2>& law, const ElasticSystem& system) {
  const bool has_open_gap =
      law.gap.size() > 0 && law.gap.minCoeff() >= 0 && max_norm(law.gap) > 0;
  return has_open_gap && system.load.isZero(0) &&
         system.prescribed_value.isZero(0) && law.previous.isZero(0);
}

/// Multipliers in tension by rounding are cut to none by the law: the forces that these
/// nodes miss then are small, but not beside those of a soft body. They are open, unless
/// no node has multipliers at all. Bonded nodes never are.
ContactStates open_where_cut(const NodalLaw& law, ContactStates state,
                             const VectorXd& P) {
  if (P.isZero(0)) return state;
  for (Index i = 0; i < count_of(state); ++i)
    if (P.segment<2>(2 * i).isZero(0) && !law.cone[i].bonded)
      state[i] = ContactState::open;
  return state;
}

/// v of the rows that hold it, and 0 on the others.
VectorXd forbidden(const ContactStates& state, VectorXd v) {
  for (Index row = 0; row < v.size(); ++row)
    if (!holds(state[row / 2], static_cast<int>(row % 2))) v[row] = 0;
  return v;
}

/// The law of a correction: bounds are those of the answer.
NodalLaw without_bounds(NodalLaw law) {
  for (FrictionCone& cone : law.cone) cone.cohesion = cone.limit = 0;
  return law;
}

class OfLine : public ContactRelation {
 public:
  OfLine(const StatedContact<2>& stated, const CondensedContact& contact,
         const CondensedStiffness& stiffness)
      : stated_(stated), contact_(contact), stiffness_(stiffness) {}

  RelationAnswer answer() override {
    if (is_at_rest(stated_.law, stated_.system)) return whole(resting());
    return whole(condensed_answer(contact_, stated_.cones, stated_.settings));
  }

  RelationAnswer corrected(const LastAnswer& last,
                           const NewtonSettings& limits) override {
    ContactSettings near = stated_.settings;
    near.max_iterations = limits.max_iterations;
    near.initial_state = last.law.state;
    near.report = {};  // rounding is no news
    CondensedContact carried = contact_;
    put_carried(last.law.P, carried);
    contact_ = with_loads(std::move(carried), stiffness_, last.load, last.v);
    return whole(condensed_answer(contact_, stated_.cones, near));
  }

  /// The residual and the displacements that the states forbid are the loads of a
  /// correction that solve_active_set finds without bounds of its own.
  std::optional<RelationAnswer> refined(const LastAnswer& last) override {
    ActiveSetResult law = last.law;
    law.state = open_where_cut(stated_.cones, law.state, law.P);
    const CondensedContact correction = with_loads(
        contact_, stiffness_,
        on_free_dofs(stated_.system, last.load + stated_.load_of(law.P)),
        forbidden(law.state, last.v));
    ContactRows rows;
    if (solve_active_set(correction, without_bounds(stated_.cones), law.state,
                         rows) == SystemKind::inconsistent)
      return std::nullopt;
    law.P += rows.P;
    put_into_law(stated_.cones, law.state, law.P);
    law.iterations = 0;  // no system of the law
    return RelationAnswer{
        {std::move(law), {}},
        displacement_of(correction, stiffness_, rows.v, rows.P)};
  }

  LawScales scales(const VectorXd& v) const override {
    return law_scales(contact_, v);
  }

 private:
  RelationAnswer whole(FixedPointResult law) const {
    const VectorXd u =
        displacement_of(contact_, stiffness_, law.answer.v, law.answer.P);
    return {std::move(law), u};
  }

  /// A body at rest stays: nothing moves and no node touches. Newton would look for it
  /// among motions that are free, by their rounding.
  FixedPointResult resting() const {
    FixedPointResult rest;
    rest.answer.P = VectorXd::Zero(2 * stated_.contact.node_count());
    rest.answer.v = contact_.v_prescribed;
    rest.answer.state.assign(stated_.contact.node_count(), ContactState::open);
    rest.answer.status = ContactStatus::converged;
    return rest;
  }

  const StatedContact<2>& stated_;
  CondensedContact contact_;
  const CondensedStiffness& stiffness_;
};

}  // namespace

std::unique_ptr<ContactRelation> line_relation(
    const StatedContact<2>& stated, const CondensedContact& contact,
    const CondensedStiffness& stiffness) {
  return std::make_unique<OfLine>(stated, contact, stiffness);
}

}  // namespace ffcontact
