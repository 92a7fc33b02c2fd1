// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/cone/contact_pass.hpp"
#include "ffcontact/equilibrium/relaxation/relaxation_progress.hpp"

namespace ffcontact {

namespace {

/// @param e  before the first and after every step
template <int d>
bool more_steps(const RelaxationSettings& settings,
                const std::vector<double>& e) {
  using Rule = RelaxationRule<d>;
  const int steps = count_of(e) - 1;
  if (settings.steps) return steps < *settings.steps;
  if (steps < Rule::usual_steps) return true;
  if (steps >= Rule::most_steps) return false;
  return steps % Rule::steps_judged != 0 ||
         e[steps] <
             (1 - Rule::worth_further_steps) * e[steps - Rule::steps_judged];
}

template <int d>
double descended(FacetDescent<d>& descent) {
  double fall = 0;
  for (int k = 0; k < RelaxationRule<d>::descents; ++k) fall += descent.step();
  return fall;
}

}  // namespace

template <int d>
std::vector<double> relax(FacetDescent<d>& descent,
                          ContactRelaxation<d>& contact,
                          const RelaxationSettings& settings,
                          const ProgressReport& report) {
  using Rule = RelaxationRule<d>;
  const double first_square = descent.begin();
  RelaxationProgress progress(first_square, contact.contact_part());
  std::vector<double> falls, e{progress.e()};
  bool goes_on = true, passes = contact.is_free();
  const auto pass = [&] {
    const double of_pass =
                     contact.pass(Rule::least_part_of_a_star * first_square,
                                  descent.corrections(), descent.residual()),
                 square = progress.e() * progress.e() - falls.back();
    passes = Rule::tightness_of_passes == 0 ||
             of_pass > Rule::tightness_of_passes * square;
    falls.back() += of_pass;
  };
  while (goes_on) {
    falls.push_back(descended<d>(descent));
    const int steps = count_of(falls);
    if (passes && steps % Rule::steps_of_a_round == 0) pass();
    goes_on = progress.goes_on(falls.back(), settings.tightness);
    e.push_back(progress.e());
    tell(report, {"relaxation", steps, "e", e.back()});
    goes_on = goes_on && more_steps<d>(settings, e);
  }
  if (passes && falls.size() % Rule::steps_of_a_round != 0) pass();
  return falls;
}

template <int d>
std::vector<double> relax_facets(const FacetSetting<d>& setting,
                                 const RelaxationSettings& settings,
                                 FacetColumns<d>& moments) {
  if (settings.steps == 0) return {};
  const FacetTopology<d>& topology = setting.body.topology;
  const FacetShare whole = whole_share<d>(topology);
  const NoExchange<d> none;
  FacetDescent<d> descent(setting.body, moments, whole, none);
  ContactPass<d> contact(setting, descent.forms(), moments);
  const std::vector<double> falls =
      relax<d>(descent, contact, settings, setting.report);
  add_corrections<d>(
      topology,
      without_contact<d>(setting.body.boundary.known, setting.contact),
      descent.corrections(), moments);
  return falls;
}

template std::vector<double> relax(FacetDescent<FFCONTACT_DIMENSION>&,
                                   ContactRelaxation<FFCONTACT_DIMENSION>&,
                                   const RelaxationSettings&,
                                   const ProgressReport&);
template std::vector<double> relax_facets(
    const FacetSetting<FFCONTACT_DIMENSION>&, const RelaxationSettings&,
    FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
