// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "estimate/judged.hpp"
#include "estimate/oscillation.hpp"
#include "problem/contact_type.hpp"

namespace ffcontact::plugin {

/// Reads elastic law, initial strains and stresses and loads of bodies into what is judged.
template <int d>
using ReadBodies =
    std::function<Oscillation(const Bodies<d>& bodies, SolvedBody<d>& body)>;

/// What is judged, without what is read.
template <int d>
using JudgedOf = std::function<Judged<d>()>;

/// Steps of the relaxation in what scripts call a sweep.
template <int d>
constexpr int steps_of_a_sweep = d == 2 ? 1 : 4;

/// Does the call ask for kappa or the bound with Coulomb's law?
inline bool wants_bound(const NamedArguments& named) {
  return named.given("coulomb") || named.given("bound");
}

/// An estimate, and what it is of.
template <int d>
struct JudgedError {
  Estimate<d> estimate;
  SolvedBody<d> body;
};

/// contacterror(C, ...) of bodies all of which this process holds.
template <int d>
JudgedError<d> contact_error(Stack stack, const NamedArguments& named,
                             const ContactProblem<d>& problem,
                             const JudgedOf<d>& judged_of,
                             const ReadBodies<d>& read,
                             const RelaxFacets<d>& relax = relax_facets<d>);

/// The same of what contactsolve found: the contact keeps what was made of it.
/// @return eps
template <int d>
double contact_error(Stack stack, const NamedArguments& named,
                     ContactOf<d>& contact, const ReadBodies<d>& read,
                     const RelaxFacets<d>& relax = relax_facets<d>) {
  auto [estimate, body] = contact_error<d>(
      stack, named, *contact.problem,
      [&] { return judged_of(solved_contact(contact)); }, read, relax);
  const double relative = estimate.relative;
  contact.solved->estimate =
      std::make_shared<const Estimate<d>>(std::move(estimate));
  if constexpr (d == 3)  // what stresses of subtetrahedra are made of again
    contact.solved->judged =
        std::make_shared<const SolvedBody<3>>(std::move(body));
  return relative;
}

}  // namespace ffcontact::plugin
