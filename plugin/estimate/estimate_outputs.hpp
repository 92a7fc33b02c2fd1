// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/estimate/estimate.hpp"
#include "problem/contact_problem.hpp"

/// What an estimate leaves, as outputs of the script.
namespace ffcontact::plugin {

/// One stress component as a P1dc array on splitmesh3(Th), whose triangle 3 t + k is
/// triangle t with vertex k moved to the centroid. FreeFEM keeps P1dc values at the
/// vertices shrunk by 1 % towards the triangle's centroid.
VectorXd stress_component(const std::vector<SubcellStress<2>>& stress,
                          int component);

/// Abscissae of the ends of the edges on which r_hat is linear, two an edge, on the line
/// that coefficients are stated on.
VectorXd abscissae(const ContactProblem<2>& problem,
                   const Estimate<2>& estimate);

/// e, its parts, what is said beside it, and its history.
void put_error(Stack stack, const NamedArguments& named,
               const PairError& error);
/// How far the pair is from what is asked of it.
void put_defects(Stack stack, const NamedArguments& named,
                 const PairError& error);

/// What is to be added to e where contact tractions are not linear on the facets.
void report_oscillation(const PairError& error);
/// e by its parts, and the defects, in a line.
void report_parts(const PairError& error);

/// Says of a pair that is not admissible why: at verbosity 0, too, unless the script asks
/// with admissible=.
void report_reason(Stack stack, const NamedArguments& named,
                   const PairError& error);

}  // namespace ffcontact::plugin
