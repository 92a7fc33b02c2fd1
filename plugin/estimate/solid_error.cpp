// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/estimate/solid_coulomb.hpp"
#include "ffcontact/sizing/edge_rates.hpp"
//
#include "estimate/contact_error_of.hpp"
#include "estimate/solid_stress.hpp"

namespace ffcontact::plugin {

namespace {

void put_rates(Stack stack, const NamedArguments& named,
               const ContactProblem<3>& problem, const Topology<3>& topology,
               const Judged<3>& judged) {
  if (!named.given_of_bodies("rate")) return;
  const SolvedBody<3>& body = judged.body;
  KnownComponents known =
      given_tractions(topology.mesh, topology.facets, judged.system->prescribed,
                      body.neumann)
          .known;
  Flags is_contact(topology.facets.count(), 0);
  for (int face : problem.contact.face) {
    known.col(face).setConstant(true);
    is_contact[face] = 1;
  }
  const CellStresses<3> stress =
      total_stresses(topology.mesh, body, body.displacement).mean;
  put_by_bodies(
      stack, named, problem.joined.first_cell, "rate",
      local_rates(topology, singular_lines(topology, body.hooke, stress, known,
                                           is_contact)));
}

void put_tractions(Stack stack, const NamedArguments& named,
                   const Estimate<3>& estimate) {
  constexpr std::array parameter = {"rn", "rt1", "rt2"};
  const auto tractions =
      estimate.face_tractions.reshaped(3, 3 * estimate.face_tractions.cols());
  for (int c = 0; c < 3; ++c)
    named.put(stack, parameter[c], tractions.row(c).transpose());
}

/// The nodes that slip nowhere, as stick= says.
Flags held_nodes(const ContactStates& states, StuckNodes stuck) {
  Flags held(states.size(), 0);
  if (stuck == StuckNodes::stick)
    for (std::size_t i = 0; i < held.size(); ++i)
      held[i] = states[i] == ContactState::stick;
  return held;
}

}  // namespace

template <>
EstimateSettings<3> ErrorOf<3>::settings(Stack, const NamedArguments& named,
                                         const ContactLaw<3>&) {
  for (const char* parameter : {"multiplier", "tractions", "construction", "rt",
                                "rabscissa", "corrected", "unmended"})
    if (named.given(parameter))
      refuse("the contact is that of a mesh3: ", parameter,
             "= is for plane bodies so far");
  return {};
}

template <>
void ErrorOf<3>::put(Stack stack, const NamedArguments& named,
                     const ContactProblem<3>& problem,
                     const Topology<3>& topology, const Judged<3>& judged,
                     const Estimate<3>& estimate) {
  put_tractions(stack, named, estimate);
  put_solid_stress(stack, named, problem, topology, estimate, judged.body);
  put_rates(stack, named, problem, topology, judged);
}

template <>
CoulombBound ErrorOf<3>::bound(const ContactProblem<3>& problem,
                               const Topology<3>& topology,
                               const Judged<3>& judged,
                               const Estimate<3>& estimate, StuckNodes stuck) {
  const SolidCoulomb found =
      solid_coulomb(topology, problem.contact, *judged.system, judged.body,
                    estimate, held_nodes(judged.state, stuck));
  return {{found.kappa, found.friction}, found.missed, found.bound};
}

template <>
void ErrorOf<3>::report(const Estimate<3>& estimate, double seconds) {
  cout << "contacterror: " << estimate.local.size() << " tetrahedra, eps "
       << 100 * estimate.relative << " %, e " << estimate.e << ", "
       << estimate.history.size() - 1 << " steps, " << seconds << " s" << endl;
}

template JudgedError<3> contact_error(Stack, const NamedArguments&,
                                      const ContactProblem<3>&,
                                      const JudgedOf<3>&, const ReadBodies<3>&,
                                      const RelaxFacets<3>&);

}  // namespace ffcontact::plugin
