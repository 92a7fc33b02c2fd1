// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "ffcontact/parallel/mesh_parts.hpp"
//
#include "freefem/arguments.hpp"
#include "parallel/team.hpp"
#include "problem/bodies.hpp"

namespace ffcontact::plugin {

/// Bodies that processes hold parts of: those of this process and, on process 0, where
/// all parts are in the whole.
template <int dim>
struct SharedBodies {
  Bodies<dim> own;
  /// of each body, without its whole mesh; process 0 only, as all that follows
  std::vector<MeshParts<dim>> parts;
  /// of each process: its joined vertices, cells and boundary columns in the joined whole
  std::vector<std::vector<int>> vertex, cell, boundary;

  /// The dofs of each process in the whole.
  std::vector<std::vector<int>> dofs() const;
};

/// The whole bodies on process 0, which the others' parts and numbers make up.
/// @param packets  of part_packet, of each process
/// @throws std::invalid_argument  as joined_parts of meshes
template <int dim>
JoinedBodies<dim> joined_bodies(std::vector<Packet>& packets, int bodies,
                                SharedBodies<dim>& shared);

/// The meshes of a process and vertexnumbers=, cellnumbers= of them.
template <int dim>
void put_parts(Stack stack, const NamedArguments& named,
               const FemMeshes<dim>& meshes, Packet& packet);

/// Expressions of a statement on process 0, at places of parts that others hold.
template <int dim>
class PlacesOfTeam : public PlacesElsewhere<dim> {
 public:
  PlacesOfTeam(Stack stack, const NamedArguments& named, const Team& team,
               const SharedBodies<dim>& shared);
  VectorXd values(Expression expression, int body,
                  const std::vector<BoundaryPlace<dim>>& places) const override;

 private:
  /// Who holds a column of a body's boundary, and which of theirs it is.
  struct Holder {
    int rank, column;
  };
  VectorXd values_of(int rank, Expression expression, int body,
                     const std::vector<BoundaryPlace<dim>>& places) const;

  Stack stack_;
  const NamedArguments& named_;
  const Team& team_;
  const SharedBodies<dim>& shared_;
  std::vector<std::vector<Holder>> holder_;  ///< [body][column]
};

/// What another process answers PlacesOfTeam.
template <int dim>
VectorXd values_here(Stack stack, const NamedArguments& named,
                     const SharedBodies<dim>& shared, Packet& places);

}  // namespace ffcontact::plugin
