// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/contact/contact_relation.hpp"
#include "ffcontact/contact/stated_surface.hpp"

namespace ffcontact {

/// The relation of solids by condensed_contact, and surface_answer on it; of an inexact
/// stiffness by surface_newton alone, to what a correction needs.
/// @param stated  outlives it
std::unique_ptr<ContactRelation> surface_relation(
    const StatedSurface& stated,
    const std::shared_ptr<const CondensedStiffness>& stiffness);

}  // namespace ffcontact
