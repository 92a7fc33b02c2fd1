// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/directed_slip.hpp"

#include <utility>

#include "ffcontact/contact/condensed/surface_trace.hpp"
#include "ffcontact/contact/uniqueness/slip_forms.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

DirectedConstant directed_constant(const CondensedContact& contact,
                                   const DirectedSlip& slip) {
  const std::optional<SlipForms> forms =
      SlipForms::of(contact, slip.weight, slip.left_out);
  if (!forms) return {infinity, infinity};
  return {forms->largest_ratio(), forms->dual_norm(slip.missed)};
}

CondensedContact surface_contact(const ContactSurface& surface,
                                 const ContactLaw<3>& law,
                                 const ElasticSystem& system,
                                 const CondensedStiffness& stiffness) {
  SurfaceTrace trace = surface_trace(surface, law, system);
  CondensedContact contact = condensed_contact(
      std::move(trace.trace), trace.primary, system.load, stiffness);
  contact.held = std::move(trace.held);
  return contact;
}

}  // namespace ffcontact
