// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/active_set/active_set.hpp"
#include "ffcontact/contact/newton/newton_relation.hpp"
#include "ffcontact/contact/newton/step_solver.hpp"

namespace ffcontact {

/// Semismooth Newton for the law of a surface (ContactLaw) on its condensed relation,
/// full steps [Alart, Curnier 1991]. With tau = P - c v at each node, c the mean of
/// diag(S) there,
///     P_n = min(0, tau_n),   P_t = Pi(tau_t) onto |.| <= rho,   rho = b(tau_n),
/// is the law whatever c > 0. Its derivative D gives the equations of the next P and v:
///     open:   P_n = 0                      closed:  v_n = 0
///     stick:  v_t = 0
///     slip:   (I - D) P_t + c D v_t = (k - mu P_n) e,   D = rho / |tau_t| (I - e e'),
///             e = tau_t / |tau_t|,  k - mu P_n = rho,
/// where v that are known leave the system, so that sticking bodies cost nothing. Rows
/// that are held have no force and no condition.
///
/// Ends when the violation is enough, by default no more than rounding, or no longer falls
/// below the tolerance; as cycled when thirty steps have not lowered it.
/// @param held   of surface_trace [3 p]
/// @param state  first guess, a slip without direction sticks [p]
/// @return states open, stick and slip_forward, which stands for any direction
ActiveSetResult surface_newton(const CondensedContact& contact,
                               const NodalLaw& law, const Flags& held,
                               const ContactStates& state,
                               const NewtonSettings& settings = {});

/// The same with steps of another accuracy.
ActiveSetResult surface_newton(const CondensedContact& contact,
                               const NodalLaw& law, const Flags& held,
                               const ContactStates& state, StepSolver& solver,
                               const NewtonSettings& settings);

/// The same from P and v of a problem nearby.
ActiveSetResult surface_newton(const CondensedContact& contact,
                               const NodalLaw& law, const Flags& held,
                               const ContactRows& near, StepSolver& solver,
                               const NewtonSettings& settings = {});

/// Likewise on any relation.
ActiveSetResult surface_newton(NewtonRelation& relation, const NodalLaw& law,
                               const Flags& held, const ContactStates& state,
                               const NewtonSettings& settings);
ActiveSetResult surface_newton(NewtonRelation& relation, const NodalLaw& law,
                               const Flags& held, const ContactRows& near,
                               const NewtonSettings& settings);

/// CondensedContact with a solver of its steps.
class CondensedRelation : public NewtonRelation {
 public:
  /// Both stay with the caller.
  CondensedRelation(const CondensedContact& contact, StepSolver& solver)
      : contact_(contact), solver_(solver) {}

  Index row_count() const override { return contact_.position.size(); }
  NaturalMap natural_map(const Flags& held) const override {
    return {contact_, held};
  }
  LawScales scales(const VectorXd& v) const override {
    return law_scales(contact_, v);
  }
  SystemKind step(const SurfaceEquations& equations,
                  ContactRows& rows) override {
    return solver_.solve(contact_, equations, rows);
  }

 private:
  const CondensedContact& contact_;
  StepSolver& solver_;
};

/// surface_violation of an answer, relative to the relation's scales; of rows beyond the
/// nodes' P relative to the largest, or the largest load.
double surface_violation(const NewtonRelation& relation, const NodalLaw& law,
                         const Flags& held, const ContactRows& rows);

/// surface_violation of an answer, relative to law_scales.
double surface_violation(const CondensedContact& contact, const NodalLaw& law,
                         const Flags& held, const ContactRows& rows);

}  // namespace ffcontact
