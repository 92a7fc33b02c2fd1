// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/relaxation/facet_descent.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/equilibrium/tractions/facet_setting.hpp"
#include "ffcontact/parallel/topology_part.hpp"

namespace ffcontact {

/// All that LoadedFacets say of some tetrahedra, and moments to start from.
struct PartSetting {
  TopologyPart part;
  HookeTensors<3> hooke;
  FaceTractions boundary;
  BodyLoadsOfCells<3> body_loads;
  LinearStresses<3> stress;
  FaceMoments moments;

  LoadedFacets<3> body() const {
    return {part.topology, hooke, boundary, body_loads, stress};
  }
};

/// @param cells  ascending
PartSetting setting_of(const FacetSetting<3>& whole, const FaceMoments& moments,
                       std::vector<int> cells);

/// What one of several processes relaxes, and whom it tells what. Lists of what two
/// processes tell each other are in the order of the whole.
struct FacePart {
  PartSetting of;
  FacetShare share;
  /// [process]: its own tetrahedra that are in another's halo, those of its halo that are
  /// another's own
  std::vector<std::vector<int>> given, taken;
  /// faces of the contact layer: those that it counts, and all that it has
  std::vector<int> contact_counted, contact_known;
  bool has_contact = false;  ///< of the whole
};

/// A solid cut by its tetrahedra.
class FaceParts {
 public:
  /// @param setting  stays where it is, as moments
  /// @param owner    the process of each tetrahedron
  /// @param contact  the faces of the contact layer, ascending
  FaceParts(const FacetSetting<3>& setting, const FaceMoments& moments,
            std::vector<int> owner, int processes, std::vector<int> contact);

  int count() const { return count_of(cells_); }
  FacePart part(int process) const;
  /// The faces that a process counts, ascending.
  std::vector<int> counted(int process) const;
  /// Places in the contact layer of FacePart::contact_counted and contact_known.
  std::vector<int> contact_counted(int process) const;
  std::vector<int> contact_known(int process) const;

 private:
  bool counts(int process, int face) const {
    return owner_[setting_.body.topology.facets.cells(0, face)] == process;
  }
  /// Is a cell beside the face one of the process's, its halo included?
  bool has_side(int process, int face) const;

  const FacetSetting<3>& setting_;
  const FaceMoments& moments_;
  std::vector<int> owner_, contact_;
  std::vector<std::vector<int>> cells_;  ///< of each process, its halo included
};

}  // namespace ffcontact
