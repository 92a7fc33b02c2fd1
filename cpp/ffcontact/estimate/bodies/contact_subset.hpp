// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/interface/line_or_surface.hpp"

namespace ffcontact {

/// Some nodes of a line or surface, and the facets between them.
template <int d>
struct ContactSubset {
  LineOrSurface<d> contact;
  ContactLaw<d> law;      ///< on it
  std::vector<int> node;  ///< number in the whole of each node
};

/// The law at some nodes, each as often as it stands there; ranges of edges stay as they are.
/// @param node  numbers in the whole
template <int d>
ContactLaw<d> law_of(const ContactLaw<d>& law, const std::vector<int>& node);

/// What is bonded, or what is not. A facet of which a corner is no node is of what its other
/// ones are of.
template <int d>
ContactSubset<d> bonded_subset(const LineOrSurface<d>& contact,
                               const ContactLaw<d>& law);
template <int d>
ContactSubset<d> sliding_subset(const LineOrSurface<d>& contact,
                                const ContactLaw<d>& law);

/// Is a contact facet bonded?
template <int d>
bool is_bonded(const LineOrSurface<d>& contact, const ContactLaw<d>& law,
               int facet) {
  const int node = nodes_of(contact, facet).maxCoeff();
  return node >= 0 && law.is_bonded(node);
}

/// Which dofs must not move while what slides is made clear: the prescribed ones, and those of
/// the vertices that are bonded.
template <int d>
Flags held_with_bonded(const LineOrSurface<d>& contact,
                       const ContactLaw<d>& law, Flags prescribed);

}  // namespace ffcontact
