// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/reason_against.hpp"

#include <cmath>

#include "ffcontact/base/words.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr double equilibrium_tolerance = 1e-10;
constexpr double cone_tolerance = 1e-12;
constexpr double penetration_tolerance = 1e-12;
constexpr double integrand_tolerance = 1e-11;

constexpr int digits_of_parts = 2;

std::string part_in_words(double part) {
  return in_digits(part, digits_of_parts);
}

std::string turn_in_words(double degrees, const Ref<const VectorXd>& turned) {
  const bool is_edge = turned.size() == 2;
  return "the contact directions turn by " + in_digits(degrees, 3) +
         " degrees, 90 or more, " +
         (is_edge ? "along the edge" : "over the face") + " at " +
         in_words(turned, digits_of_parts) + ": refine the " +
         (is_edge ? "line" : "surface");
}

std::string integrand_in_words(double negative,
                               const Ref<const VectorXd>& place) {
  return "the integrand of the contact part of e^2 is below 0 by " +
         part_in_words(negative) +
         " of the largest stress times the largest displacement at " +
         in_words(place, digits_of_parts) + ": take eps for an indicator";
}

std::string penetration_in_words(double depth,
                                 const Ref<const VectorXd>& deepest) {
  return "u penetrates by " + part_in_words(depth) +
         " of the largest displacement at " +
         in_words(deepest, digits_of_parts) +
         ", where displacements are prescribed: change these or gap=, or take "
         "that vertex out of the contact";
}

std::string jump_in_words(double jump, const Ref<const VectorXd>& widest) {
  const std::string jumps =
      "u jumps between bonded bodies by " + part_in_words(jump) +
      " of the largest displacement at " + in_words(widest, digits_of_parts);
  if (widest.size() == 2)
    return jumps +
           ", where displacements are prescribed: make these the same on both "
           "sides";
  return jumps +
         ", where the faces of neither body are covered by the other's, what "
         "is bonded ends beside what slides and meshes do not match, or "
         "displacements are prescribed: take eps for an indicator";
}

std::string cone_in_words(double cone, std::size_t unmended) {
  const std::string sentence = "contact tractions leave the friction cone by " +
                               part_in_words(cone) + " of the largest stress";
  if (unmended == 0) return sentence + ": take eps for an indicator";
  return sentence + ": (4.1) cannot mend " + std::to_string(unmended) +
         " edges, tractions=\"free\" leaves none";
}

std::string imbalance_in_words(const EquilibriumDefect& defect,
                               Construction construction) {
  if (construction == Construction::polynomial)
    return "the polynomial construction is in equilibrium in the mean only: "
           "its tractions jump by " +
           part_in_words(defect.jump) +
           " of the largest; construction=\"composite\" has none of this";
  if (defect.largest() > equilibrium_tolerance)
    return "the stress is out of equilibrium by " +
           part_in_words(defect.largest()) +
           " of the largest traction: its digits are lost on badly shaped or "
           "nearly incompressible cells; mend the mesh, or take eps for an "
           "indicator";
  return {};
}

}  // namespace

bool pays_for_contact_alone(const PairError& error) {
  constexpr double nearly_all = 0.99;
  return error.contact > nearly_all * error.e * error.e;
}

void put_between_nodes(const BetweenNodes& found, double work,
                       PairError& error) {
  constexpr double degrees = 180 / M_PI;
  error.turn = degrees * found.turn;
  error.negative = relative(found.negative, work);
}

std::string reason_against(const PairError& error, const WorstPlaces& worst,
                           Construction construction, std::size_t unmended) {
  if (error.turn > 0) return turn_in_words(error.turn, worst.turned);
  if (error.penetration > penetration_tolerance)
    return worst.is_bonded
               ? jump_in_words(error.penetration, worst.deepest)
               : penetration_in_words(error.penetration, worst.deepest);
  if (error.cone > cone_tolerance) return cone_in_words(error.cone, unmended);
  if (error.negative > integrand_tolerance)
    return integrand_in_words(error.negative, worst.negative);
  return imbalance_in_words(error.equilibrium, construction);
}

}  // namespace ffcontact
