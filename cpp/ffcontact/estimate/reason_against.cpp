// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/reason_against.hpp"

#include "ffcontact/base/words.hpp"

namespace ffcontact {

namespace {

constexpr double equilibrium_tolerance = 1e-10;
constexpr double cone_tolerance = 1e-12;
constexpr double penetration_tolerance = 1e-12;

constexpr int digits_of_parts = 2;

std::string part_in_words(double part) {
  return in_digits(part, digits_of_parts);
}

std::string penetration_in_words(double depth,
                                 const Ref<const VectorXd>& deepest) {
  return "u penetrates by " + part_in_words(depth) +
         " of the largest displacement at " +
         in_words(deepest, digits_of_parts) +
         ", where displacements are prescribed";
}

std::string cone_in_words(double cone, std::size_t unmended) {
  const std::string sentence = "contact tractions leave the friction cone by " +
                               part_in_words(cone) + " of the largest stress";
  if (unmended == 0) return sentence;
  return sentence + ": (4.1) cannot mend " + std::to_string(unmended) +
         " edges";
}

std::string imbalance_in_words(const EquilibriumDefect& defect,
                               Construction construction) {
  if (construction == Construction::polynomial)
    return "the polynomial construction is in equilibrium in the mean only: "
           "its tractions jump by " +
           part_in_words(defect.jump) + " of the largest";
  if (defect.largest() > equilibrium_tolerance)
    return "the stress is out of equilibrium by " +
           part_in_words(defect.largest()) + " of the largest traction";
  return {};
}

}  // namespace

std::string reason_against(const PairError& error,
                           const Ref<const VectorXd>& deepest,
                           Construction construction, std::size_t unmended) {
  if (error.penetration > penetration_tolerance)
    return penetration_in_words(error.penetration, deepest);
  if (error.cone > cone_tolerance) return cone_in_words(error.cone, unmended);
  return imbalance_in_words(error.equilibrium, construction);
}

}  // namespace ffcontact
