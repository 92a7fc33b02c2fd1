// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "ffcontact/elastic/elastic_system.hpp"
//
#include "freefem/arguments.hpp"
#include "problem/bodies.hpp"
#include "problem/carrier.hpp"
#include "problem/contact_statement.hpp"
#include "problem/stated_pairs.hpp"

namespace ffcontact::plugin {

/// Who can carry the multipliers of a pair of bodies, or of a body and a rigid foundation.
template <int d>
struct PairSides {
  bool rigid;
  int wanted;      ///< side that the script wants, or 0
  Carrier<d> own;  ///< of the body that comes first
  std::optional<Carrier<d>> other{};
  /// how much more the other one yields
  std::function<double(const ElasticSystem&)> compliance_ratio{};
};

/// What a script states, and of which bodies.
template <int d>
struct Statement {
  Stack stack;
  const NamedArguments& named;
  const Bodies<d>& bodies;
  const PlacesElsewhere<d>* elsewhere;  ///< null where the meshes are here
  double corner;                        ///< of curves [degrees]

  const SimplexMesh<d>& mesh = bodies.joined.mesh;
  const Facets<d>& facets = bodies.facets;

  BodyPart<d> part(int body) const { return bodies.part(body, elsewhere); }
};

/// The bodies stay as long as what is returned.
/// @throws std::invalid_argument  if the wanted side cannot carry the multipliers, a label is
///                                on both sides of a crack, or a coefficient is not usable
std::vector<PairSides<2>> read_sides(const Statement<2>& said,
                                     const std::vector<StatedPair>& pairs);
std::vector<PairSides<3>> read_sides(const Statement<3>& said,
                                     const std::vector<StatedPair>& pairs);

}  // namespace ffcontact::plugin
