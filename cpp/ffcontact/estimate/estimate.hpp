// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ffcontact/equilibrium/equilibrium_defect.hpp"
#include "ffcontact/equilibrium/star_relaxation.hpp"
#include "ffcontact/estimate/contact_error.hpp"

namespace ffcontact {

/// A computed contact solution and everything it was computed from.
struct SolvedBody {
  Hooke hooke;                      ///< per triangle [MPa]
  std::vector<char> prescribed;     ///< 1 where the dof is prescribed [2 * vertices]
  Eigen::VectorXd displacement;     ///< u_h on all dofs [mm]
  Eigen::Matrix2Xd pressure;        ///< (lambda_n, lambda_t) at the contact nodes [MPa]
  ContactLaw law;
  Eigen::Matrix4Xd neumann;         ///< moments of the given tractions, as for boundary_tractions [4 x Mesh::boundary]
  Eigen::Matrix2Xd body_force;      ///< per triangle [N/mm^3]
};

struct EstimateSettings {
  int sweeps = 2;  ///< of star relaxation
};

/// The error in the constitutive relation of an admissible pair ((u_hat, w_hat), (sigma_hat, r_hat)) [CHH01, 2.2].
///     e^2 = |sigma_hat - C eps(u_hat)|^2 + 2 int (mu |r_n||w_t| + r_t w_t + r_n w_n)                              (2.11)
///     eps = e / |sigma_hat + C eps(u_hat)|,   eps^2 = sum of eps_E^2                                        (2.12), (2.13)
struct Estimate {
  double e = 0;                 ///< [(N/mm times mm)^(1/2)]
  double relative = 0;          ///< eps [-]
  double elastic = 0;           ///< |sigma_hat - C eps(u_hat)|, same unit as e
  double contact = 0;           ///< the contact part of e^2; negative values are possible only outside the cone
  Eigen::VectorXd local;        ///< eps_E per triangle [-]; 0 where a negative contact part exceeds the elastic one
  std::vector<double> history;  ///< e before the first and after every sweep

  Eigen::VectorXd displacement;          ///< u_hat on all dofs [mm]
  std::vector<CompositeStress> stress;   ///< sigma_hat [MPa]
  ConeCorrection tractions;              ///< r_hat, after correction (4.1)
  EquilibriumDefect equilibrium;
  double cone = 0;                       ///< cone_defect of r_hat
  bool admissible = false;               ///< in equilibrium to 1e-10 and inside the cone to 1e-12
  std::string reason;                    ///< why not, one sentence without a full stop
};

/// Builds the admissible pair and evaluates it: u_hat; r_hat = lambda_h corrected by (4.1) edge by edge; edge tractions of the
/// stars, built with lambda_h; star relaxation with r_hat fixed; composite stress; (2.11)-(2.13).
/// Edges that (4.1) cannot mend are left outside the cone, counted, and make the result not admissible.
/// @throws std::invalid_argument  for input that does not fit or is not in equilibrium with its loads
Estimate estimate_error(const Mesh& mesh, const Edges& edges, const ContactLine& line, const SolvedBody& body,
                        const EstimateSettings& settings = {});

}  // namespace ffcontact
