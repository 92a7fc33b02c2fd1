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

class OfSchur : public SurfaceRelation {
 public:
  OfSchur(const StatedSurface& stated,
          std::shared_ptr<const CondensedStiffness> stiffness)
      : stated_(stated),
        stiffness_(std::move(stiffness)),
        contact_(condensed_contact(stated.trace.trace, stated.trace.primary,
                                   stated.system.load, *stiffness_)) {}

  FixedPointResult answer() override {
    const auto& held = stated_.trace.held;
    if (stiffness_->is_exact())
      return surface_answer(contact_, *stiffness_, stated_.cones, held,
                            stated_.settings);
    solver_ = StepSolver(contact_, held);
    return {rough_answer(contact_, stated_.cones, held, start(),
                         stated_.settings, solver_),
            {}};
  }

  void put_loads(const VectorXd& load, const VectorXd& v_prescribed,
                 const VectorXd& P) override {
    put_carried(P, contact_);
    contact_ = with_loads(std::move(contact_), *stiffness_, load, v_prescribed);
  }

  ActiveSetResult answer_near(const ContactRows& rows,
                              const NewtonSettings& limits) override {
    return surface_newton(contact_, stated_.cones, stated_.trace.held, rows,
                          solver_, limits);
  }

  VectorXd displacement(const ContactRows& rows) const override {
    return displacement_of(contact_, *stiffness_, rows.v, rows.P);
  }

  LawScales scales(const VectorXd& v) const override {
    return law_scales(contact_, v);
  }

 private:
  std::optional<ContactRows> start() const {
    if (!takes_coarse_start(stated_.settings)) return std::nullopt;
    return coarse_start(contact_, stated_.cones, stated_.surface);
  }

  const StatedSurface& stated_;
  std::shared_ptr<const CondensedStiffness> stiffness_;
  CondensedContact contact_;
  StepSolver solver_;
};

}  // namespace

std::unique_ptr<SurfaceRelation> surface_relation(
    const StatedSurface& stated,
    const std::shared_ptr<const CondensedStiffness>& stiffness) {
  return std::make_unique<OfSchur>(stated, stiffness);
}

}  // namespace ffcontact
