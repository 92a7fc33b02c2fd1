// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"

namespace ffcontact {

/// The error in the constitutive relation of an admissible pair, in the plane and in space
/// [CHH01, 2.2], and how well the pair is what is asked of it. The unit of e is (N mm)^(1/2),
/// in the plane per unit of thickness.
struct PairError {
  double e = 0;
  double relative = 0;  ///< eps [-]
  double elastic = 0;   ///< |sigma_hat - C eps(u_hat)|, same unit as e
  /// the contact part of e^2; negative values are possible only for pairs that are not
  /// admissible, and then e is no less than the elastic part
  double contact = 0;
  double springs = 0;  ///< the springs' part of e^2
  /// what r_hat has beyond the linear tractions that sigma_hat balances, same unit as e:
  /// where it is not 0, e + this is what is said of e (facet_oscillation.hpp)
  double oscillation = 0;
  /// eps_E per cell [-]; 0 where a negative contact part exceeds the elastic one
  VectorXd local;
  /// e before the first and after every sweep or step, with composite stresses
  std::vector<double> history;

  EquilibriumDefect equilibrium;
  double cone = 0;  ///< of r_hat outside of it, relative to the largest stress
  /// of u_hat, or the jump of u_hat where bodies are bonded, relative to the largest
  /// displacement
  double penetration = 0;
  /// largest angle between the contact directions of two nodes of a facet that carries
  /// tractions or is penetrated, if that is too large to be judged, 90 or more [degrees]
  double turn = 0;
  /// how far the integrand of the contact part is below 0 anywhere (BetweenNodes),
  /// relative to the largest stress times the largest displacement
  double negative = 0;
  /// no such angle, an integrand that is not negative to 1e-11,
  /// in equilibrium to 1e-10, inside the cone and clear of the foundation to 1e-12
  bool admissible = false;
  std::string reason;  ///< why not, one sentence without a full stop
};

}  // namespace ffcontact
