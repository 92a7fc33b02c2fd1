// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/surface_relation.hpp"

#include <optional>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/newton/coarse_start.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/contact/surface_answer.hpp"

namespace ffcontact {

namespace {

/// Are there no states that are better than those of coarse_start?
bool takes_coarse_start(const ContactSettings& settings) {
  return settings.initial_state.empty() || settings.state_of_another_mesh;
}

class OfSchur : public ContactRelation {
 public:
  OfSchur(const StatedSurface& stated,
          std::shared_ptr<const CondensedStiffness> stiffness)
      : stated_(stated),
        stiffness_(std::move(stiffness)),
        contact_(condensed_contact(stated.trace.trace, stated.trace.primary,
                                   stated.system.load, *stiffness_)) {}

  RelationAnswer answer() override {
    const auto& held = stated_.trace.held;
    if (stiffness_->is_exact())
      return whole(surface_answer(contact_, *stiffness_, stated_.cones, held,
                                  stated_.settings));
    solver_ = StepSolver(contact_, held);
    return whole({rough_answer(contact_, stated_.cones, held, start(),
                               stated_.settings, solver_),
                  {}});
  }

  RelationAnswer corrected(const LastAnswer& last,
                           const NewtonSettings& limits) override {
    put_carried(last.law.P, contact_);
    contact_ = with_loads(std::move(contact_), *stiffness_, last.load, last.v);
    return whole(
        {surface_newton(contact_, stated_.cones, stated_.trace.held,
                        ContactRows{last.law.P, last.law.v}, solver_, limits),
         {}});
  }

  LawScales scales(const VectorXd& v) const override {
    return law_scales(contact_, v);
  }

 private:
  RelationAnswer whole(FixedPointResult law) const {
    const VectorXd u =
        displacement_of(contact_, *stiffness_, law.answer.v, law.answer.P);
    return {std::move(law), u};
  }

  std::optional<ContactRows> start() const {
    if (!takes_coarse_start(stated_.settings)) return std::nullopt;
    return coarse_start(contact_, stated_.cones, stated_.contact);
  }

  const StatedSurface& stated_;
  std::shared_ptr<const CondensedStiffness> stiffness_;
  CondensedContact contact_;
  StepSolver solver_;
};

}  // namespace

std::unique_ptr<ContactRelation> surface_relation(
    const StatedSurface& stated,
    const std::shared_ptr<const CondensedStiffness>& stiffness) {
  return std::make_unique<OfSchur>(stated, stiffness);
}

}  // namespace ffcontact
