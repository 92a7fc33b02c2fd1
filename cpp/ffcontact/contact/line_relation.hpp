// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/contact/contact_relation.hpp"
#include "ffcontact/contact/stated_contact.hpp"

namespace ffcontact {

/// The relation of plane bodies by condensed_contact, and condensed_answer on it.
/// @param stated, contact, stiffness  outlive it
std::unique_ptr<ContactRelation> line_relation(
    const StatedContact<2>& stated, const CondensedContact& contact,
    const CondensedStiffness& stiffness);

}  // namespace ffcontact
