// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// A quadratic on an edge by its Bernstein coefficients, s from 0 to 1:
///     (1 - s)^2 first + 2 s (1 - s) middle + s^2 second.
struct QuadraticOnEdge {
  double first, middle, second;
  double operator()(double s) const {
    return (1 - s) * ((1 - s) * first + s * middle) +
           s * ((1 - s) * middle + s * second);
  }
};

/// w . n(s) less the gap, and w . t(s) less the load step before, along an edge: w, the
/// directions, gap and step are linear between the nodes, n(s) not of unit length
/// (moments_of_ends). Linear where the directions do not turn.
struct EdgeMotions {
  QuadraticOnEdge normal, tangential;  ///< [mm]
};

/// The motions of a displacement along the edges of a line.
class LineMotions {
 public:
  /// @param line  stays where it is
  LineMotions(const ContactLine& line, const ContactLaw<2>& law,
              const Ref<const VectorXd>& displacement);

  /// (w_n, w_t) at a node.
  Vector2d at(int node) const { return at_nodes_.col(node); }
  EdgeMotions on(int edge) const;

 private:
  const ContactLine& line_;
  Matrix2Xd at_nodes_;
  Matrix2Xd given_;  ///< gap and load step before at the nodes
};

}  // namespace ffcontact
