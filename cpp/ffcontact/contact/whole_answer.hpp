// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/active_set/active_set.hpp"
#include "ffcontact/contact/contact_settings.hpp"
#include "ffcontact/contact/refinement.hpp"

namespace ffcontact {

/// An answer of the condensed relation, and what the whole body makes of it.
struct WholeAnswer {
  ActiveSetResult condensed;
  BodyAnswer body;
  ResidualDefect residual;
  double off;  ///< complementarity_defect
};

/// The displacement of all dofs, refined until rounding is all that is left of the residual.
/// Where it misses the law though the condensed answer does not, as rounding of a stiff
/// part may be more than a soft one moves, the law is solved anew: with the last u and its
/// residual,
///     K (u' - u) = b - K u + B'P',   (P', v(u')) in the law.
/// @param condensed  refined if it has converged
WholeAnswer whole_answer(const ContactLine& line, const ContactLaw& law,
                         const ElasticSystem& system,
                         const ContactSettings& settings,
                         const CondensedStiffness& stiffness,
                         const CondensedContact& contact,
                         ActiveSetResult condensed);

}  // namespace ffcontact
