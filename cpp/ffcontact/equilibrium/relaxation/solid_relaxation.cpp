// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/relaxation/solid_relaxation.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/cone/contact_pass.hpp"
#include "ffcontact/equilibrium/relaxation/relaxation_progress.hpp"

namespace ffcontact {

namespace {

/// A pass that lowers e^2 by less than this part is the last one: where all of the surface
/// slips there is little to be had.
constexpr double tightness_of_passes = 2e-3;
/// A star that lowers e^2 by less than this part of what it was at first may as well stay.
constexpr double least_part_of_a_star = 1e-8;

/// Steps where no number is given, and how many of them must lower e by what part for
/// there to be further ones.
constexpr int usual_steps = 16, most_steps = 32, steps_judged = 4;
constexpr double worth_further_steps = 0.03;

/// @param e  before the first and after every step
bool more_steps(const SolidRelaxationSettings& settings,
                const std::vector<double>& e) {
  const int steps = count_of(e) - 1;
  if (settings.steps) return steps < *settings.steps;
  if (steps < usual_steps || steps % steps_judged != 0) return true;
  return steps < most_steps &&
         e[steps] < (1 - worth_further_steps) * e[steps - steps_judged];
}

}  // namespace

std::vector<double> relax(FacetDescent<3>& descent, ContactRelaxation& contact,
                          const SolidRelaxationSettings& settings) {
  const double first_square = descent.begin();
  RelaxationProgress progress(first_square, contact.contact_part());
  std::vector<double> falls, e{progress.e()};
  bool goes_on = true, passes = contact.is_free();
  const auto pass = [&] {
    const double of_pass =
                     contact.pass(least_part_of_a_star * first_square,
                                  descent.corrections(), descent.residual()),
                 square = progress.e() * progress.e() - falls.back();
    passes = of_pass > tightness_of_passes * square;
    falls.back() += of_pass;
  };
  while (goes_on) {
    falls.push_back(descent.step());
    const int steps = count_of(falls);
    if (passes && steps % steps_of_a_round == 0) pass();
    goes_on = progress.goes_on(falls.back(), settings.tightness);
    e.push_back(progress.e());
    goes_on = goes_on && more_steps(settings, e);
  }
  if (passes && falls.size() % steps_of_a_round != 0) pass();
  return falls;
}

std::vector<double> relax_faces(const FaceSetting& setting,
                                const SolidRelaxationSettings& settings,
                                FaceMoments& moments) {
  if (settings.steps == 0) return {};
  const FacetShare whole = whole_share<3>(setting.topology);
  const NoExchange<3> none;
  FacetDescent<3> descent(setting.loaded(), moments, whole, none);
  ContactPass contact(setting.topology, setting.boundary, descent.forms(),
                      setting.contact, moments);
  const std::vector<double> falls = relax(descent, contact, settings);
  add_corrections<3>(setting.topology,
                     without_contact(setting.boundary.known, setting.contact),
                     descent.corrections(), moments);
  return falls;
}

}  // namespace ffcontact
