// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/interface/contact_line.hpp"
#include "ffcontact/interface/pairing/facing_polygons.hpp"

namespace ffcontact {

/// How much more the opposite trace yields to a pressure on one of its edges than the
/// line's own trace does, on both meshes as they are: the mean over the facing pieces,
/// weighted by their lengths, of
///     log (c_opposite / c_own),    c = h / k,    1/k = mean of 1 / (n' K_vv n) over the ends v of the edge,
/// as its exponential [-]. h is the length of the mesh edge and K_vv the 2 x 2 block of
/// the stiffness at a vertex, n' K_vv n / h the modulus times a number of the mesh's
/// angles; prescribed components count as rigid, and a vertex whose free ones do not
/// move it along n does not yield.
///
/// A multiplier a node of a trace that yields much less than the other one asks the other
/// trace for more than it can do between its own nodes: contact opens and closes from
/// node to node. The trace that yields more follows the other without that.
double compliance_ratio(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const ElasticSystem& system);

/// Likewise of surfaces: h is the root of a face's area, n the mean contact direction of
/// the contact face, and polygons weigh by their areas.
double compliance_ratio(const SolidMesh& mesh, const Facets<3>& faces,
                        const ContactSurface& surface,
                        const std::vector<FacingPolygon>& polygons,
                        const ElasticSystem& system);

/// From this ratio on the opposite body is to carry the multipliers.
constexpr double much_softer = 3;

}  // namespace ffcontact
