// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/shared_bodies.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/parallel/system_parts.hpp"
//
#include "freefem/body_values.hpp"

namespace ffcontact::plugin {

namespace {

template <int dim>
void put_mesh(const SimplexMesh<dim>& mesh, Packet& packet) {
  packet.put(mesh.vertices)
      .put(mesh.cells)
      .put(mesh.boundary)
      .put(mesh.boundary_label);
}

template <int dim>
SimplexMesh<dim> mesh_in(Packet& packet) {
  SimplexMesh<dim> mesh;
  packet.take_to(mesh.vertices)
      .take_to(mesh.cells)
      .take_to(mesh.boundary)
      .take_to(mesh.boundary_label);
  return mesh;
}

/// Appends a body's numbers, which begin at `first` in the whole; -1 stays.
void append_numbers(const std::vector<int>& numbers, int first,
                    std::vector<int>& joined) {
  for (int number : numbers)
    joined.push_back(number < 0 ? number : first + number);
}

}  // namespace

template <int dim>
std::vector<std::vector<int>> SharedBodies<dim>::dofs() const {
  std::vector<std::vector<int>> all;
  for (const std::vector<int>& of_process : vertex)
    all.push_back(dofs_of_part(of_process, dim));
  return all;
}

template <int dim>
void put_parts(Stack stack, const NamedArguments& named,
               const FemMeshes<dim>& meshes, Packet& packet) {
  const int bodies = count_of(meshes);
  for (int k = 0; k < bodies; ++k) {
    put_mesh(mesh_of(meshes[k]), packet);
    packet.put(named.integers(stack, name_of_body("vertexnumbers", k, bodies)));
    packet.put(named.integers(stack, name_of_body("cellnumbers", k, bodies)));
  }
}

/// Of the next body in the packets.
template <int dim>
MeshParts<dim> parts_in(std::vector<Packet>& packets) {
  std::vector<SimplexMesh<dim>> meshes;
  std::vector<PartNumbers> numbers;
  for (Packet& packet : packets) {
    meshes.push_back(mesh_in<dim>(packet));
    const auto vertex = packet.take<std::vector<int>>(),
               cell = packet.take<std::vector<int>>();
    numbers.push_back({vertex, cell});
  }
  return joined_parts(meshes, numbers);
}

/// What a process holds of a body.
template <int dim>
void add_numbers(const JoinedBodies<dim>& joined, int body, std::size_t process,
                 SharedBodies<dim>& shared) {
  const MeshParts<dim>& parts = shared.parts[body];
  append_numbers(parts.vertex[process], joined.first_vertex[body],
                 shared.vertex[process]);
  append_numbers(parts.cell[process], joined.first_cell[body],
                 shared.cell[process]);
  append_numbers(parts.boundary[process], joined.first_boundary[body],
                 shared.boundary[process]);
}

template <int dim>
JoinedBodies<dim> joined_bodies(std::vector<Packet>& packets, int bodies,
                                SharedBodies<dim>& shared) {
  std::vector<SimplexMesh<dim>> wholes;
  for (int k = 0; k < bodies; ++k) {
    shared.parts.push_back(parts_in<dim>(packets));
    wholes.push_back(std::exchange(shared.parts.back().whole, {}));
  }
  JoinedBodies<dim> joined = joined_mesh(wholes);
  const std::size_t processes = packets.size();
  shared.vertex.resize(processes);
  shared.cell.resize(processes);
  shared.boundary.resize(processes);
  for (std::size_t r = 0; r < processes; ++r)
    for (int k = 0; k < bodies; ++k) add_numbers(joined, k, r, shared);
  return joined;
}

template <int dim>
PlacesOfTeam<dim>::PlacesOfTeam(Stack stack, const NamedArguments& named,
                                const Team& team,
                                const SharedBodies<dim>& shared)
    : stack_(stack), named_(named), team_(team), shared_(shared) {
  for (const MeshParts<dim>& parts : shared.parts) {
    std::vector<Holder> holder;
    for (int r = 0; r < parts.part_count(); ++r)
      for (int e = 0; e < count_of(parts.boundary[r]); ++e) {
        const int column = parts.boundary[r][e];
        if (column < 0) continue;
        if (column >= count_of(holder)) holder.resize(column + 1, {-1, -1});
        holder[column] = {r, e};
      }
    holder_.push_back(std::move(holder));
  }
}

template <int dim>
VectorXd PlacesOfTeam<dim>::values(
    Expression expression, int body,
    const std::vector<BoundaryPlace<dim>>& places) const {
  VectorXd values(count_of(places));
  for (int r = 0; r < team_.count(); ++r) {
    std::vector<int> number;
    std::vector<BoundaryPlace<dim>> held;
    for (int i = 0; i < count_of(places); ++i) {
      const Holder& holder = holder_[body][places[i].column];
      if (holder.rank != r) continue;
      number.push_back(i);
      held.push_back({holder.column, places[i].weights});
    }
    if (!held.empty()) values(number) = values_of(r, expression, body, held);
  }
  return values;
}

template <int dim>
VectorXd PlacesOfTeam<dim>::values_of(
    int rank, Expression expression, int body,
    const std::vector<BoundaryPlace<dim>>& places) const {
  if (rank == 0)
    return at_boundary<dim>(stack_, expression, shared_.own.part(body), places);
  std::vector<int> column;
  MatrixXd weights(dim, count_of(places));
  for (const BoundaryPlace<dim>& place : places) {
    weights.col(count_of(column)) = place.weights;
    column.push_back(place.column);
  }
  return team_.values_of(rank, Packet()
                                   .put(named_.key_of(expression))
                                   .put(body)
                                   .put(column)
                                   .put(weights));
}

template <int dim>
VectorXd values_here(Stack stack, const NamedArguments& named,
                     const SharedBodies<dim>& shared, Packet& packet) {
  const Expression expression =
      named.expression_of(packet.take<NamedArguments::Key>());
  const int body = packet.take<int>();
  const auto column = packet.take<std::vector<int>>();
  const auto weights = packet.take<MatrixXd>();
  std::vector<BoundaryPlace<dim>> places;
  for (int e : column) places.push_back({e, weights.col(count_of(places))});
  return at_boundary<dim>(stack, expression, shared.own.part(body), places);
}

template struct SharedBodies<2>;
template struct SharedBodies<3>;
template void put_parts<2>(Stack, const NamedArguments&,
                           const std::vector<pmesh>&, Packet&);
template void put_parts<3>(Stack, const NamedArguments&,
                           const std::vector<pmesh3>&, Packet&);
template JoinedMesh joined_bodies(std::vector<Packet>&, int, SharedBodies<2>&);
template JoinedSolids joined_bodies(std::vector<Packet>&, int,
                                    SharedBodies<3>&);
template class PlacesOfTeam<2>;
template class PlacesOfTeam<3>;
template VectorXd values_here(Stack, const NamedArguments&,
                              const SharedBodies<2>&, Packet&);
template VectorXd values_here(Stack, const NamedArguments&,
                              const SharedBodies<3>&, Packet&);

}  // namespace ffcontact::plugin
