// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"

#include "ffcontact/base/memory.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/cone/contact_pass.hpp"
#include "ffcontact/equilibrium/relaxation/relaxation_progress.hpp"

namespace ffcontact {

namespace {

/// The numbers that a relaxation in the plane and in space differ by.
template <int d>
struct RelaxationRule {
  /// Steps of the descent in one of the relaxation: two lower e of plane bodies as much as
  /// one of Gauss-Seidel over the stars with the best combination after each.
  static constexpr int descents = d == 2 ? 2 : 1;
  /// Steps between two passes over the contact ridges.
  static constexpr int steps_of_a_round = d == 2 ? 1 : 3;
  /// A pass that lowers e^2 by less than this part is the last one: where all of the
  /// surface slips there is little to be had. In the plane passes cost next to nothing, and
  /// go on.
  static constexpr double tightness_of_passes = d == 2 ? 0 : 2e-3;
  /// A star that lowers e^2 by less than this part of what it was at first may as well
  /// stay.
  static constexpr double least_part_of_a_star = d == 2 ? 0 : 1e-8;
  /// Steps where no number is given: `usual_steps`, further ones if the last
  /// `steps_judged` of these lowered e by the first part, and from then on while that many
  /// lower it by the second, up to `most_steps`. Stretched cells and nearly incompressible
  /// bodies need them.
  static constexpr int usual_steps = d == 2 ? 2 : 16,
                       most_steps = d == 2 ? 12 : 96,
                       steps_judged = d == 2 ? 1 : 4;
  static constexpr double worth_further_steps = d == 2 ? 0.16 : 0.03,
                          worth_going_on = 0.02;
};

/// @param e  before the first and after every step
template <int d>
bool more_steps(const RelaxationSettings& settings,
                const std::vector<double>& e) {
  using Rule = RelaxationRule<d>;
  const int steps = count_of(e) - 1;
  if (settings.steps) return steps < *settings.steps;
  if (steps < Rule::usual_steps) return true;
  if (steps >= Rule::most_steps) return false;
  if (steps % Rule::steps_judged != 0) return true;
  const double worth = steps == Rule::usual_steps ? Rule::worth_further_steps
                                                  : Rule::worth_going_on;
  return e[steps] < (1 - worth) * e[steps - Rule::steps_judged];
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
  contact.weigh(first_square);
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
void require_room_for_relaxation(const FacetTopology<d>& topology,
                                 double available) {
  constexpr double gigabyte = 1e9;
  if (const double needed = FacetDescent<d>::bytes(topology);
      needed > available)
    refuse("the estimate of ", topology.mesh.cell_count(), " ",
           MeshWords<d>::cells, " takes ", needed / gigabyte,
           " GB, more than is left of the memory (", available / gigabyte,
           " GB): estimate on a coarser mesh, or on several processes");
}

template <int d>
std::vector<double> relax_facets(const FacetSetting<d>& setting,
                                 const RelaxationSettings& settings,
                                 FacetColumns<d>& moments) {
  if (settings.steps == 0) return {};
  const FacetTopology<d>& topology = setting.body.topology;
  require_room_for_relaxation<d>(topology, available_memory());
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
template void require_room_for_relaxation(
    const FacetTopology<FFCONTACT_DIMENSION>&, double);
template std::vector<double> relax_facets(
    const FacetSetting<FFCONTACT_DIMENSION>&, const RelaxationSettings&,
    FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
