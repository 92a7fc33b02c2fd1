// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"
#include "ffcontact/contact/newton/natural_map.hpp"

namespace ffcontact {

/// The solutions (P, v) of a surface's law with s b in place of its bound b on friction, as
/// a curve of points z = (P, v, s) [6 p + 1; rows 3 i + c] [Haslinger, Janovsky, Ligursky,
/// CMAME 205 (2012)]. Its lengths are
///     |z|^2 = (sum P^2 / c + sum c v^2) / (that of its start) + s^2,
/// c of surface_newton, over the rows that are not held. It is smooth but for kinks, where
/// a node opens, closes, sticks or slips.
///
/// At the states of tau = P - c v Newton's equations are linear in P and v, and rho = s b
/// is linear in s: they have a line of solutions along (dP/ds, dv/ds, 1). The curve runs
/// along it where the determinant of the natural map's derivative by v has the sign that
/// it has at the start, and against it elsewhere [Keller 1977]. As there is one solution
/// without friction, a curve that keeps to this never comes back to s = 0.
class FrictionCurve {
 public:
  /// A point and the curve's direction there, |t| = 1.
  struct Place {
    VectorXd z, t;
  };

  /// The first three outlive it.
  /// @param held   of surface_trace [3 p]
  /// @param start         the solution at s = 0
  /// @param most_systems  linear systems, after which no more points are found
  FrictionCurve(const CondensedContact& contact, const NodalLaw& law,
                const Flags& held, const ContactRows& start, int most_systems);

  static ContactRows rows(const VectorXd& z);
  static double share(const VectorXd& z) { return z[z.size() - 1]; }

  /// Nothing where Newton's equations are singular.
  std::optional<Place> start();

  /// The point at (z - from) . t = h, by Newton from from + h t; nothing where fifteen
  /// steps do not meet the law, or it is much farther away than h: on another piece of the
  /// curve.
  std::optional<Place> corrected(const VectorXd& from, const VectorXd& t,
                                 double h);

  /// The same along the direction that the curve has at from + h t, beyond a kink; nothing
  /// where the point found has the states of the one before.
  std::optional<Place> beyond_kink(const Place& from, double h);

  /// Linear systems so far, with two right-hand sides each; others count as spent.
  int systems() const { return systems_; }
  int systems_left() const { return most_systems_ - systems_; }
  void spend(int systems) { systems_ += systems; }

 private:
  struct Line {
    VectorXd at, along;
    int orientation;
  };
  VectorXd point(const ContactRows& rows, double s) const;
  NodalLaw law(const VectorXd& z) const;
  std::vector<NodeState> states(const VectorXd& z) const;
  ContactStates contact_states(const VectorXd& z) const;
  std::optional<Line> line_at(const VectorXd& z);
  VectorXd direction(const Line& line) const;
  double product(const VectorXd& y, const VectorXd& z) const;
  double violation(const VectorXd& z) const;

  const CondensedContact& contact_;
  const NodalLaw& law_;
  const Flags& held_;
  const NaturalMap map_;
  VectorXd weight_;  ///< of the squares in |z|^2
  VectorXd start_;
  int orientation_ = 1;  ///< at the start
  int most_systems_, systems_ = 0;
};

}  // namespace ffcontact
