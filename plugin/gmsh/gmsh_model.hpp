// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "ffcontact/mesh/remeshing/moved_onto_surfaces.hpp"

namespace ffcontact::plugin {

/// Writes the surface of a solid as gmsh's discrete geometry (MSH 4.1): points, curves
/// and surfaces with their numbers + 1 in the model, and their mesh. Coordinates are
/// multiplied by `scale`.
void write_gmsh_model(const std::filesystem::path& file, const SolidMesh& mesh,
                      const Facets<3>& faces, const SurfaceModel& model,
                      double scale);

/// Writes a view whose field is the size, linear in the tetrahedra.
void write_gmsh_sizes(const std::filesystem::path& file, const SolidMesh& mesh,
                      const Ref<const VectorXd>& size, double scale);

/// Writes the geometry that gmsh is to mesh: surfaces and curves flattened out by gmsh,
/// parts of the body as volumes, and the view "sizes.pos" beside it as the only source of
/// sizes.
void write_gmsh_volumes(const std::filesystem::path& file,
                        const SurfaceModel& model);

/// Reads what gmsh made of it (MSH 2.2, text); coordinates are multiplied by `scale`.
/// @throws std::invalid_argument  if the file is spoilt or has no tetrahedra
ModelMesh read_gmsh_model(const std::filesystem::path& file, double scale);

}  // namespace ffcontact::plugin
