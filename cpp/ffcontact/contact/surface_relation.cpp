// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/surface_relation.hpp"

#include <optional>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/matrix_free/product_step.hpp"
#include "ffcontact/contact/newton/coarse_start.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/contact/surface_answer.hpp"

namespace ffcontact {

namespace {

/// Are there no states that are better than those of coarse_start?
bool takes_coarse_start(const ContactSettings& settings) {
  return settings.initial_state.empty() || settings.state_of_another_mesh;
}

class OfWholeSchur : public SurfaceRelation {
 public:
  OfWholeSchur(const StatedSurface& stated,
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

class OfProducts : public SurfaceRelation, private NewtonRelation {
 public:
  OfProducts(const StatedSurface& stated,
             std::shared_ptr<const CondensedStiffness> stiffness)
      : stated_(stated),
        relation_(product_relation(stated.trace, stated.system,
                                   std::move(stiffness))) {}

  FixedPointResult answer() override {
    return product_answer(*this, stated_.cones, stated_.trace.held, start(),
                          stated_.settings);
  }

  void put_loads(const VectorXd& load, const VectorXd& v_prescribed,
                 const VectorXd&) override {
    ffcontact::put_loads(load, v_prescribed, relation_);
  }

  ActiveSetResult answer_near(const ContactRows& rows,
                              const NewtonSettings& limits) override {
    return surface_newton(*this, stated_.cones, stated_.trace.held,
                          with_w_o_at_rest(rows), limits);
  }

  VectorXd displacement(const ContactRows& rows) const override {
    return relation_.stiffness->extended(relation_.load,
                                         kept_displacement(relation_, rows));
  }

  LawScales scales(const VectorXd& v) const override {
    return law_scales(relation_, v);
  }

 private:
  Index row_count() const override { return relation_.row_count(); }
  NaturalMap natural_map(const Flags& held) const override {
    return {relation_.row_stiffness, relation_.position, held};
  }
  SystemKind step(const SurfaceEquations& equations,
                  ContactRows& rows) override {
    return solve_product_step(relation_, equations, rows).kind;
  }

  /// w_o counts from the displacement that the loads belong to.
  ContactRows with_w_o_at_rest(const ContactRows& rows) const {
    const Index nodal = relation_.position.size();
    ContactRows all{VectorXd::Zero(row_count()), VectorXd::Zero(row_count())};
    all.P.head(nodal) = rows.P.head(nodal);
    all.v.head(nodal) = rows.v.head(nodal);
    return all;
  }

  /// As with dense algebra none where bodies are held by contact alone, which are those in
  /// full precision: sticking nodes hold them.
  std::optional<ContactRows> start() const {
    if (relation_.stiffness->precision() == Precision::full ||
        !takes_coarse_start(stated_.settings))
      return std::nullopt;
    const auto coarse = [this](const SparseMatrix& Q) {
      return coarse_relation(relation_, Q);
    };
    const auto rows =
        coarse_start(relation_.primary, coarse, stated_.cones, stated_.surface);
    if (!rows) return std::nullopt;
    return with_w_o_at_rest(*rows);
  }

  const StatedSurface& stated_;
  ProductRelation relation_;
};

}  // namespace

std::unique_ptr<SurfaceRelation> surface_relation(
    const StatedSurface& stated,
    const std::shared_ptr<const CondensedStiffness>& stiffness) {
  if (stiffness->storage() == SchurStorage::whole)
    return std::make_unique<OfWholeSchur>(stated, stiffness);
  return std::make_unique<OfProducts>(stated, stiffness);
}

}  // namespace ffcontact
