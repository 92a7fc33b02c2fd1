// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid_relation.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/multigrid/step_conditions.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/elastic/multigrid/row_product.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Newton is given this many linear systems.
constexpr int most_multigrid_systems = 60;
/// And so many from rows that may be near, before it starts from states.
constexpr int most_near_systems = 10;
/// Residuals of the systems' solutions: of the first one, of those far from the answer, and
/// the least that single precision has.
constexpr double first_residual = 1e-2, most_residual = 0.1,
                 least_residual = 1e-4;

/// Rows: v and P of the nodes, behind them y and the forces K u - b on y that no condition of
/// a node asks for, which are to be 0.
class OfMultigrid : public ContactRelation, private NewtonRelation {
 public:
  OfMultigrid(const Matrix3Xd& vertices, const StatedSurface& stated)
      : stated_(stated),
        unknowns_(surface_unknowns(stated.contact, stated.trace,
                                   stated.law.layer, stated.system)),
        step_(told(stated), vertices, unknowns_) {
    put_loads(stated.system.load, stated.trace.trace.v_prescribed, {});
  }

  RelationAnswer answer() override {
    const ContactSettings& settings = stated_.settings;
    const NewtonSettings limits{
        std::min(most_multigrid_systems, settings.max_iterations),
        settings.tolerance, settings.report, settings.tolerance};
    if (!settings.near)
      return whole(answer_from(
          settings.first_states(stated_.cones.node_count()), limits));
    ActiveSetResult best = answer_from(
        *settings.near, limits.with_at_most(std::min(most_near_systems,
                                                     limits.max_iterations)));
    const int left = limits.max_iterations - best.iterations;
    if (best.status != ContactStatus::converged && left > 0)
      best.add(answer_from(settings.first_states(stated_.cones.node_count()),
                           limits.with_at_most(left)));
    return whole(std::move(best));
  }

  RelationAnswer corrected(const LastAnswer& last,
                           const NewtonSettings& limits) override {
    put_loads(last.load, last.v, last.law.P);
    return whole(answer_from(ContactRows{last.law.P, last.law.v}, limits));
  }

  int products() const override { return step_.products(); }
  /// As law_scales.
  LawScales scales(const VectorXd& v) const override {
    return {std::max(max_norm(v), least_.v), least_.P};
  }
  double largest_load() const override { return largest_load_; }

 private:
  void put_loads(const VectorXd& load, const VectorXd& v_prescribed,
                 const VectorXd& P) {
    load_ = unknowns_.frames.components(load);
    conditions_.put(v_prescribed, P);
    shared_.put(conditions_.v_prescribed());
    const VectorXd given = given_forces();
    largest_load_ = max_norm(given);
    least_ = least_scales(given);
  }

  RelationAnswer whole(ActiveSetResult law) const {
    const VectorXd u = unknowns_.frames.displacement(law.v.tail(load_.size()));
    return {{std::move(law), {}}, u};
  }

  ActiveSetResult answer_from(const ContactRows& rows,
                              const NewtonSettings& limits) {
    last_missed_ = 0;
    const VectorXd y = y_of(rows.v, rows.P);
    ContactRows near = conditions_.rows_of(y, forces(y));
    near.P.head(nodal()) = rows.P.head(nodal());
    near.v.head(nodal()) = rows.v.head(nodal());
    return surface_newton(*this, stated_.cones, stated_.trace.held, near,
                          limits);
  }

  ActiveSetResult answer_from(const ContactStates& states,
                              const NewtonSettings& limits) {
    last_missed_ = 0;
    return surface_newton(*this, stated_.cones, stated_.trace.held, states,
                          limits);
  }

  /// Before multigrid is set up.
  static const ElasticSystem& told(const StatedSurface& stated) {
    tell(stated.settings.report,
         {"multigrid", 0, "dofs",
          static_cast<double>(stated.system.dof_count())});
    return stated.system;
  }

  Index nodal() const { return unknowns_.of_row.size(); }
  Index row_count() const override { return nodal() + load_.size(); }

  NaturalMap natural_map(const Flags& held) const override {
    const VectorXd K = stated_.system.stiffness.diagonal();
    std::vector<double> diagonal;
    VectorXi position = VectorXi::Constant(nodal(), -1);
    unknowns_.for_rows([&](int row, int) {
      position[row] = count_of(diagonal);
      // half of it, as what is beyond gives way
      diagonal.push_back(0.5 / (1 / step_.stiffness(row) +
                                compliance_followed(K, row) +
                                unknowns_.compliance[row]));
    });
    for (const SharedVertex& shared : unknowns_.shared)
      number_rows(shared, position, diagonal);
    return {packed(diagonal), position, held};
  }
  static void number_rows(const SharedVertex& shared, VectorXi& position,
                          std::vector<double>& diagonal) {
    for (int k = 0; k < shared.row_count(); ++k) {
      position[shared.rows[k]] = count_of(diagonal);
      diagonal.push_back(0.5 / (1 / shared.stiffness[k] + shared.layer[k]));
    }
  }

  /// Of what a row follows, whose springs are in series with its own.
  double compliance_followed(const VectorXd& K, int row) const {
    double sum = 0;
    for (const auto& link :
         unknowns_.frames.followed_by(unknowns_.of_row[row] / 3))
      for (int c = 0; c < 3; ++c)
        if (const double B = link.B(row % 3, c); B != 0)
          sum += B * B / K[3 * link.vertex + c];
    return sum;
  }

  SystemKind step(const SurfaceEquations& equations,
                  ContactRows& rows) override {
    shared_.put(equations, rows.P);
    const VectorXd z = shared_.z_of(rows.P);
    const VectorXd y = with_conditions(equations, z, rows.v.tail(load_.size()));
    const Balance last = balance(equations, y, z);
    const std::optional<VectorXd> change = step_.change(
        equations, shared_, last.missed, residual_for(last.missed.norm()));
    if (!change) return SystemKind::inconsistent;
    put_rows(equations, y + change->head(y.size()), z + change->tail(z.size()),
             rows);
    return SystemKind::regular;
  }

  /// Forces on y that are no P of shared rows, these P, and what y and z lack.
  struct Balance {
    VectorXd F, P, missed;
  };
  Balance balance(const SurfaceEquations& equations, const VectorXd& y,
                  const VectorXd& z) const {
    Balance result{forces(y), VectorXd::Zero(nodal()),
                   VectorXd(y.size() + z.size())};
    result.missed.tail(z.size()) = shared_.put_forces(y, z, result.F, result.P);
    shared_.take(result.P, result.F);
    result.missed.head(y.size()) = conditions_.missed(equations, y, result.F);
    return result;
  }

  void put_rows(const SurfaceEquations& equations, const VectorXd& y,
                const VectorXd& z, ContactRows& rows) const {
    const Balance next = balance(equations, y, z);
    rows = conditions_.rows_of(y, next.F);
    conditions_.settle(equations, next.missed, rows);
    rows.P.head(nodal()) += next.P;
    shared_.put_motion(y, next.P, rows.v);
  }

  VectorXd y_of(const VectorXd& v, const VectorXd& P) const {
    VectorXd y = conditions_.y_of(v, P);
    shared_.put_own(v, P, y);
    return y;
  }

  /// y that meets the conditions, what others' y do apart.
  VectorXd with_conditions(const SurfaceEquations& equations, const VectorXd& z,
                           VectorXd y) const {
    conditions_.fix(equations, y);
    shared_.fix(y);
    if (!stated_.law.layer.given() && shared_.count() == 0) return y;
    const VectorXd F = forces(y);
    conditions_.relax(equations, F, y);
    for (int i = 0; i < shared_.count(); ++i)
      shared_.relax(i, step_.shared_diagonal(i), F, z, y);
    return y;
  }

  /// Newton's steps are worth no more than what they gain.
  double residual_for(double size) {
    const double last = std::exchange(last_missed_, size);
    if (last == 0) return first_residual;
    const double gain = size / last;
    return std::clamp(0.9 * gain * gain, least_residual, most_residual);
  }

  /// K u - b on y
  VectorXd forces(const VectorXd& y) const {
    return unknowns_.frames.components(row_product(
               stated_.system.stiffness, unknowns_.frames.displacement(y))) -
           load_;
  }

  /// Where the nodes' v and all other y are 0; a layer takes its part of v_prescribed.
  VectorXd given_forces() const {
    const VectorXd none = VectorXd::Zero(nodal());
    VectorXd y = y_of(none, none);
    unknowns_.for_rows(
        [&](int row, int k) { y[k] /= 1 + conditions_.yielding(row); });
    return forces(y);
  }

  LawScales least_scales(const VectorXd& given) const {
    constexpr double share_of_loads = 1e-4;
    const VectorXf& K = step_.diagonal_of_all();
    double motion = 0;
    for (Index k = 0; k < given.size(); ++k)
      if (K[k] > 0) motion = std::max(motion, std::abs(given[k]) / K[k]);
    return {motion, share_of_loads * largest_load_};
  }

  const StatedSurface& stated_;
  SurfaceUnknowns unknowns_;
  StepMultigrid step_;
  VectorXd load_;  ///< b on y
  StepConditions conditions_{unknowns_, step_};
  SharedRows shared_{unknowns_.shared};
  LawScales least_;  ///< of v and P
  double largest_load_ = 0;
  double last_missed_ = 0;
};

}  // namespace

std::unique_ptr<ContactRelation> multigrid_relation(
    const Matrix3Xd& vertices, const StatedSurface& stated) {
  return std::make_unique<OfMultigrid>(vertices, stated);
}

}  // namespace ffcontact
