// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"
#include "ffcontact/equilibrium/tractions/equilibrated_moments.hpp"
#include "support/cells.hpp"
#include "support/loaded_solid.hpp"

/// Solids whose face moments are relaxed.
namespace ffcontact::test {

/// Moments in equilibrium with the loads of a body.
struct RelaxedSolid {
  LoadedSolid body;
  FaceTractions boundary;
  LinearStresses<3> stress;
  FacetSetting<3> setting;
  FaceMoments moments;

  explicit RelaxedSolid(LoadedSolid loaded)
      : body(std::move(loaded)),
        boundary(body.boundary()),
        stress(body.computed_stress()),
        setting{{body.topology, body.hooke, boundary, body.body_loads, stress}},
        moments(equilibrated_moments(body.topology, stress.mean,
                                     body.body_loads, boundary)) {}
  RelaxedSolid(const RelaxedSolid&) = delete;

  std::vector<double> relax(int steps, double tightness = 0) {
    return relax_facets<3>(setting, {steps, tightness}, moments);
  }
  double square() const {
    double sum = 0;
    for (int t = 0; t < body.mesh().cell_count(); ++t)
      sum += energy(corners_of(body.mesh(), t), body.hooke[t].inverse(),
                    difference_stress<3>(setting.body, moments, t));
    return sum;
  }
  /// Force or moment over size left on a tetrahedron, relative to the largest load.
  double imbalance() const {
    double left = 0, largest = 0;
    for (int t = 0; t < body.mesh().cell_count(); ++t) {
      const FacetLoads<3> loads =
          loads_of(body.mesh(), body.topology.facets, moments, t);
      const auto out = out_of_balance<3>(corners_of(body.mesh(), t), loads,
                                         body.body_loads.col(t).reshaped(3, 4));
      left = std::max(left, out.cwiseAbs().maxCoeff());
      largest = std::max(largest, loads.cwiseAbs().maxCoeff());
    }
    return left / largest;
  }
};

inline LoadedSolid any_solid(Random& random) {
  return random_loaded_solid(irregular_solid(random), random);
}

}  // namespace ffcontact::test
