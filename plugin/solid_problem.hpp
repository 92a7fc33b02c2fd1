// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/surface_law.hpp"
#include "ffcontact/interface/contact_surface.hpp"
//
#include "arguments.hpp"
#include "body_dofs.hpp"
#include "held_mesh.hpp"

namespace ffcontact::plugin {

/// A contact problem of one solid on a rigid foundation as a script states it: label=,
/// friction=, slipbound=, gap=, normal=[nx, ny, nz] (one contact direction a vertex in
/// place of the faces' normals) and previous= (displacement of the load step before; an
/// empty array is none). All is evaluated when it is stated.
struct SolidProblem : BodyDofs {
  SolidMesh mesh;
  HeldMesh<Fem2D::Mesh3> fem_mesh;
  Facets<3> faces;
  ContactSurface surface;
  SurfaceLaw law;

  /// @throws std::invalid_argument  if the mesh, a label or a coefficient is not usable,
  ///                                or there is more than one mesh
  SolidProblem(Stack stack, const NamedArguments& named,
               const std::vector<pmesh3>& meshes);
  SolidProblem(const SolidProblem&) = delete;
  SolidProblem& operator=(const SolidProblem&) = delete;

  std::vector<long> vertices() const;  ///< of the nodes [p]
  Matrix3Xd places() const;            ///< of the nodes [mm, 3 x p]

 private:
  SolidProblem(Stack stack, const NamedArguments& named, pmesh3 fem,
               SolidMesh solid);
  ContactSurface stated_surface(Stack stack, const NamedArguments& named) const;
  SurfaceLaw stated_law(Stack stack, const NamedArguments& named) const;
};

}  // namespace ffcontact::plugin
