// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/multigrid/shared_vertex.hpp"
#include "ffcontact/elastic/multigrid/vertex_frames.hpp"

namespace ffcontact {

/// The unknowns of solids in contact, as many as they have free dofs: what u consists of
/// beside prescribed values, of which the rows 3 i + c of the nodes have
///     v = y_k + v_prescribed + gamma P_k,   P_k = (K u - b)_k in the components of y,
/// so that contact vertices follow what they face, and what their states hold is a mask. A
/// compliant layer gives way by gamma P_k between y and v, gamma = c / A of the node.
/// Vertices that have more rows than y are shared.
struct SurfaceUnknowns {
  VertexFrames<3> frames;
  /// k of each row, or -1 where it is held or of a shared vertex [3 p]
  VectorXi of_row;
  VectorXd compliance;  ///< gamma, nodal_compliance [3 p]
  std::vector<SharedVertex> shared;

  /// Calls visit(row, k) for the rows with a y_k of their own.
  template <class Visit>
  void for_rows(const Visit& visit) const {
    for (int row = 0; row < of_row.size(); ++row)
      if (const int k = of_row[row]; k >= 0) visit(row, k);
  }
};

/// Does a contact vertex face another one, whose y would be in its rows?
bool faces_itself(const ContactSurface& surface, const SurfaceTrace& trace);

/// @param trace  of a surface that does not face itself
SurfaceUnknowns surface_unknowns(const ContactSurface& surface,
                                 const SurfaceTrace& trace,
                                 const CompliantLayer& layer,
                                 const ElasticSystem& system);

}  // namespace ffcontact
