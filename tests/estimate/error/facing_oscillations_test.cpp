// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/facing_oscillations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "ffcontact/estimate/error/traction_oscillation.hpp"
#include "support/facing_contact.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Of tetrahedra that have one face there each.
double oscillation_of(const FacingContact& facing) {
  double square = 0;
  for (const FacingOscillation<3>& beyond : facing_oscillations(
           facing.topology.mesh, facing.topology.facets, facing.surface(),
           facing.hooke, facing.contact, facing.nodal))
    square += beyond.value(facing.tractions);
  return std::sqrt(square);
}

RC_GTEST_PROP(FacingOscillations, sum_up_to_that_of_the_tractions,
              (Random random)) {
  FacingContact facing({0, 0, -1}, 0.5, random);
  const SurfaceTractions on_faces = facing.on_faces();
  const double all = traction_oscillation(
      facing.topology.mesh, facing.topology.facets, facing.surface(),
      facing.hooke, {facing.nodal, on_faces});
  RC_ASSERT(std::abs(oscillation_of(facing) - all) < 1e-9 * all);
}

/// Where some are not relaxed theirs stay.
RC_GTEST_PROP(FacingOscillations, add_what_other_faces_do, (Random random)) {
  FacingContact facing({0, 0, -1}, 0.5, random);
  const SurfaceTractions at_first =
      tractions_by_face(facing.surface(), facing.nodal);
  for (std::size_t m = 0; m < facing.contact.size(); ++m)
    facing.tractions[m] = of_face(at_first, facing.contact[m].index);
  const double all = oscillation_of(facing);
  std::set<int> faced;
  for (const ContactFacet<3>& face : facing.contact)
    for (const FacingPart<3>& part : face.facing) faced.insert(part.facet);
  const std::size_t of_all = faced.size();
  facing.contact.pop_back();
  facing.tractions.pop_back();
  faced.clear();
  for (const ContactFacet<3>& face : facing.contact)
    for (const FacingPart<3>& part : face.facing) faced.insert(part.facet);
  const double fewer = oscillation_of(facing);
  RC_ASSERT(fewer <= all * (1 + 1e-9));
  // what the last one alone faces has no part any more
  if (faced.size() == of_all) RC_ASSERT(fewer > all * (1 - 1e-9));
}

}  // namespace
}  // namespace ffcontact
