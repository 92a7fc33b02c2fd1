// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/reason_against.hpp"

#include <iomanip>
#include <sstream>

namespace ffcontact {

namespace {

constexpr double equilibrium_tolerance = 1e-10;
constexpr double cone_tolerance = 1e-12;
constexpr double penetration_tolerance = 1e-12;

std::string in_digits(double value) {
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

std::string penetration_in_words(double depth,
                                 const Ref<const VectorXd>& deepest) {
  std::string place = in_digits(deepest[0]);
  for (Index c = 1; c < deepest.size(); ++c)
    place += ", " + in_digits(deepest[c]);
  return "u penetrates by " + in_digits(depth) +
         " of the largest displacement at (" + place +
         "), where displacements are prescribed";
}

std::string cone_in_words(double cone) {
  return "contact tractions leave the friction cone by " + in_digits(cone) +
         " of the largest stress";
}

std::string cone_in_words(const Estimate& estimate) {
  const std::string sentence = cone_in_words(estimate.cone);
  if (estimate.unmended.empty()) return sentence;
  return sentence + ": (4.1) cannot mend " +
         std::to_string(estimate.unmended.size()) + " edges";
}

std::string imbalance_in_words(const EquilibriumDefect& defect,
                               Construction construction) {
  if (construction == Construction::polynomial)
    return "the polynomial construction is in equilibrium in the mean only: "
           "its tractions jump by " +
           in_digits(defect.jump) + " of the largest";
  if (defect.largest() > equilibrium_tolerance)
    return "the stress is out of equilibrium by " +
           in_digits(defect.largest()) + " of the largest traction";
  return {};
}

}  // namespace

std::string reason_against(const Estimate& estimate, Construction construction,
                           const Vector2d& deepest) {
  if (estimate.penetration > penetration_tolerance)
    return penetration_in_words(estimate.penetration, deepest);
  if (estimate.cone > cone_tolerance) return cone_in_words(estimate);
  return imbalance_in_words(estimate.equilibrium, construction);
}

std::string reason_against(const SolidEstimate& estimate,
                           const Vector3d& deepest) {
  if (estimate.penetration > penetration_tolerance)
    return penetration_in_words(estimate.penetration, deepest);
  if (estimate.cone > cone_tolerance) return cone_in_words(estimate.cone);
  return imbalance_in_words(estimate.equilibrium, Construction::composite);
}

}  // namespace ffcontact
