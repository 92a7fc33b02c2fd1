// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/shared_statement.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/parallel/system_parts.hpp"
//
#include "parallel/shown_nodes.hpp"
#include "problem/contact_statement.hpp"

namespace ffcontact::plugin {

namespace {

/// previous= of the whole, empty where no process has one.
template <int dim>
VectorXd joined_previous(std::vector<Packet>& packets,
                         const SharedBodies<dim>& bodies, int vertices) {
  const auto dofs = bodies.dofs();
  VectorXd whole = VectorXd::Zero(dim * vertices);
  bool any = false;
  for (std::size_t r = 0; r < packets.size(); ++r) {
    const auto own = packets[r].template take<VectorXd>();
    if (own.size() == 0) continue;
    whole(dofs[r]) = own;
    any = true;
  }
  return any ? whole : VectorXd();
}

template <int dim>
Packet part_packet(Stack stack, const NamedArguments& named,
                   const FemMeshes<dim>& meshes,
                   const SharedBodies<dim>& bodies) {
  Packet packet;
  packet.put(count_of(meshes));
  put_parts<dim>(stack, named, meshes, packet);
  packet.put(stated_previous(stack, named, bodies.own));
  return packet;
}

/// What process 0 states, from the parts of all.
template <int dim>
std::shared_ptr<ContactProblem<dim>> problem_of(Stack stack,
                                                const NamedArguments& named,
                                                const Team& team,
                                                std::vector<Packet> packets,
                                                SharedBodies<dim>& bodies) {
  int count = 0;
  for (Packet& packet : packets) count = packet.take<int>();
  JoinedBodies<dim> whole = joined_bodies<dim>(packets, count, bodies);
  VectorXd previous =
      joined_previous<dim>(packets, bodies, whole.first_vertex.back());
  const PlacesOfTeam<dim> places(stack, named, team, bodies);
  return std::make_shared<ContactProblem<dim>>(stack, named, std::move(whole),
                                               places, std::move(previous));
}

}  // namespace

std::shared_ptr<Team> stated_team(Stack stack, const NamedArguments& named) {
  const Expression communicator = named.expression("comm");
  if (!communicator) return nullptr;
  auto team = team_of(value_of<pcommworld>(stack, communicator));
  return team->count() > 1 ? team : nullptr;
}

template <int dim>
SharedStatement<dim> state_shared(Stack stack, const NamedArguments& named,
                                  const FemMeshes<dim>& meshes,
                                  const std::shared_ptr<Team>& team) {
  SharedStatement<dim> statement;
  statement.contact = std::make_shared<SharedContact>();
  SharedContact& contact = *statement.contact;
  contact.team = team;
  std::optional<SharedBodies<dim>> bodies;
  const auto own = [&] {
    bodies.emplace(SharedBodies<dim>{Bodies<dim>(meshes), {}, {}, {}, {}});
    return part_packet<dim>(stack, named, meshes, *bodies);
  };
  together(
      *team,
      [&] {
        std::vector<Packet> packets = team->gathered(own());
        statement.problem =
            problem_of<dim>(stack, named, *team, std::move(packets), *bodies);
        for (int r = 1; r < team->count(); ++r) {
          Packet packet;
          put(shown_nodes(*statement.problem, *bodies, r), packet);
          team->release(r, packet);
        }
        contact.shown = shown_nodes(*statement.problem, *bodies, 0);
      },
      [&] {
        team->answer(own());
        Packet packet =
            team->served({[&](Packet& places) {
                            return values_here(stack, named, *bodies, places);
                          },
                          nullptr});
        contact.shown = nodes_in(packet);
      });
  if constexpr (dim == 2)
    contact.plane = std::move(bodies);
  else
    contact.solid = std::move(bodies);
  return statement;
}

template SharedStatement<2> state_shared(Stack, const NamedArguments&,
                                         const std::vector<pmesh>&,
                                         const std::shared_ptr<Team>&);
template SharedStatement<3> state_shared(Stack, const NamedArguments&,
                                         const std::vector<pmesh3>&,
                                         const std::shared_ptr<Team>&);

}  // namespace ffcontact::plugin
