// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <functional>
#include <stdexcept>

#include "ground.hpp"
#include "random_mesh.hpp"

namespace ffcontact::fuzz {

namespace {

void append(const Finds& more, Finds& finds) {
  finds.insert(finds.end(), more.begin(), more.end());
}

bool is_sentence(const std::string& message) {
  return message.find(' ') != std::string::npos && message.size() > 12;
}

Feasible always() { return Feasible::yes; }

/// Reactions along the line itself are not judged.
bool is_held_along_the_line(const Case& problem) {
  for (const Contact& contact : problem.contacts)
    for (const Support& s : problem.bodies[contact.body].supports)
      if (std::find(contact.labels.begin(), contact.labels.end(), s.label) !=
          contact.labels.end())
        return true;
  return false;
}

/// Runs a step; notes what it threw. @return whether it ended
/// @param possible  asked for where it threw
bool ended(const char* step, const Case& problem,
           const std::function<Feasible()>& possible,
           const std::function<void()>& run, Outcome& outcome) {
  std::string message;
  try {
    run();
    return true;
  } catch (const std::invalid_argument& sentence) {
    message = sentence.what();
  } catch (const std::runtime_error& sentence) {
    message = sentence.what();
  } catch (const std::exception& other) {
    outcome.finds.push_back(finding("exception", step, ": ", other.what()));
  }
  if (!message.empty() && !is_sentence(message))
    outcome.finds.push_back(finding("exception", step, ": ", message));
  outcome.answer =
      std::string("refused by ") + step + ": " + without_numbers(message);
  if (problem.promise == Promise::solution && possible() == Feasible::yes)
    outcome.finds.push_back(finding("refused", step, ": ", message));
  return false;
}

void judge_estimate(const Case& problem, const Assembled& parts,
                    const ElasticSystem& system,
                    const ContactSolution<2>& solution, Outcome& outcome) {
  EstimateSettings<2> settings;
  settings.relaxation.steps = problem.sweeps;
  Estimate<2> estimate;
  // What is solved has an estimate, whatever the problem promised, where there is an
  // admissible pair.
  Case promised = problem;
  promised.promise = Promise::solution;
  if (!ended(
          "estimate", promised,
          [&] {
            return is_held_along_the_line(problem) ||
                           no_density_holds(parts, solution)
                       ? Feasible::no
                       : Feasible::yes;
          },
          [&] {
            estimate = estimate_error(topology_of(parts.mesh()), parts.line,
                                      system, parts.solved(solution), settings);
          },
          outcome))
    return;
  constexpr double rounding = 1e-12;  // above it is a reaction, however small
  const bool is_balanced =
      estimate.admissible && estimate.equilibrium.largest() <= rounding;
  if (!is_balanced && is_held_along_the_line(problem)) {
    outcome.answer = "not admissible: held along the line";
    return;
  }
  append(estimate_finds(problem, parts, estimate), outcome.finds);
  if (problem.with_reference && problem.promise == Promise::solution &&
      outcome.finds.empty())
    ended(
        "reference", problem, always,
        [&] {
          append(bound_finds(problem, parts, estimate, 2), outcome.finds);
        },
        outcome);
  outcome.answer = "judged";
}

}  // namespace

std::string without_numbers(const std::string& message) {
  std::string result;
  for (std::size_t k = 0; k < message.size(); ++k) {
    const bool starts =
        std::isdigit(static_cast<unsigned char>(message[k])) &&
        (k == 0 || !std::isalpha(static_cast<unsigned char>(message[k - 1])));
    if (!starts) {
      if (message[k] != '-' || k + 1 == message.size() ||
          !std::isdigit(static_cast<unsigned char>(message[k + 1])))
        result += message[k];
      continue;
    }
    while (k + 1 < message.size() &&
           (std::isalnum(static_cast<unsigned char>(message[k + 1])) ||
            message[k + 1] == '.' ||
            ((message[k + 1] == '-' || message[k + 1] == '+') &&
             message[k] == 'e')))
      ++k;
    result += '#';
  }
  return result;
}

Outcome outcome_of(const Case& problem) {
  Outcome outcome;
  Assembled parts;
  ElasticSystem system;
  ContactSolution<2> solution;
  if (!ended(
          "mesh and line", problem, always, [&] { parts = assembled(problem); },
          outcome))
    return outcome;
  append(line_finds(problem, parts), outcome.finds);
  const Feasible possible =
      problem.tool ? Feasible::unknown : feasible(problem, parts);
  if (!ended(
          "matrix", problem, always,
          [&] { system = elastic_system(parts.A, parts.b); }, outcome))
    return outcome;
  if (!ended(
          "contact", problem, [&] { return possible; },
          [&] { solution = solved_contact(parts, system); }, outcome))
    return outcome;
  if (!solution.accepted({})) {
    outcome.answer = std::string("not solved: ") + in_words(solution.status);
    if (problem.promise == Promise::solution && possible == Feasible::yes)
      outcome.finds.push_back(unsolved(solution));
    return outcome;
  }
  if (possible == Feasible::no) {
    outcome.answer = "solved though prescribed values penetrate";
    outcome.finds.push_back(finding(
        "infeasible",
        "prescribed values penetrate and the problem is called solved"));
    return outcome;
  }
  append(solution_finds(problem, parts, solution), outcome.finds);
  judge_estimate(problem, parts, system, solution, outcome);
  return outcome;
}

namespace {

bool still(const Case& candidate, const Find& what) {
  const Outcome outcome = outcome_of(candidate);
  for (const Find& found : outcome.finds)
    if (found.check == what.check &&
        without_numbers(found.detail) == without_numbers(what.detail))
      return true;
  return false;
}

/// Every way to make a case simpler by one step.
std::vector<std::function<void(Case&)>> simplifications(const Case& problem) {
  std::vector<std::function<void(Case&)>> steps;
  steps.push_back([](Case& c) { c.has_gap = false; });
  steps.push_back([](Case& c) { c.has_previous = false; });
  steps.push_back([](Case& c) { c.tgv = 1e30; });
  for (Field Case::*field :
       {&Case::gap, &Case::previous, &Case::friction, &Case::slip_bound})
    steps.push_back([field](Case& c) {
      c.*field = {(c.*field).mean, {0, 0}, 0, {0, 0}};
    });
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    const auto of_body = [&](auto change) {
      steps.push_back([=](Case& c) { change(c.bodies[k]); });
    };
    of_body([](Body& b) { b.force.setZero(); });
    of_body([](Body& b) { b.region.assign(b.region.size(), 0); });
    of_body([](Body& b) {
      for (Material& m : b.materials) m.nu = 0.3;
    });
    of_body([](Body& b) {
      for (Support& s : b.supports) s.value = {s.value.mean, {0, 0}, 0, {0, 0}};
    });
    of_body([](Body& b) {
      for (Support& s : b.supports) s.value = {};
    });
    for (std::size_t i = problem.bodies[k].tractions.size(); i-- > 0;)
      of_body([i](Body& b) {
        if (i < b.tractions.size())
          b.tractions.erase(b.tractions.begin() +
                            static_cast<std::ptrdiff_t>(i));
      });
    for (int t = problem.bodies[k].mesh.cell_count() - 1; t >= 0; --t)
      of_body([t](Body& b) {
        std::vector<char> removed(b.mesh.cells.cols(), 0);
        std::vector<int> kept, region;
        if (t >= b.mesh.cell_count()) return;
        removed[t] = 1;
        if (!remove_triangles(b.mesh, removed, &kept)) return;
        for (int old : kept) region.push_back(b.region[old]);
        b.region = region;
      });
  }
  return steps;
}

}  // namespace

Case shrunk(const Case& problem, const Find& what) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::seconds(20);
  Case smallest = problem;
  for (bool progress = true; progress;) {
    progress = false;
    for (const auto& simplify : simplifications(smallest)) {
      Case candidate = smallest;
      simplify(candidate);
      if (text_of(candidate) == text_of(smallest)) continue;
      if (Clock::now() > end) return smallest;
      if (!still(candidate, what)) continue;
      smallest = candidate;
      progress = true;
    }
  }
  return smallest;
}

}  // namespace ffcontact::fuzz
