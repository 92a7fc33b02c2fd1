// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/shared_solve.hpp"

#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/parallel/system_parts.hpp"
//
#include "parallel/shared_contact.hpp"
#include "parallel/shared_outputs.hpp"
#include "parallel/shared_stiffness.hpp"
#include "parallel/shown_nodes.hpp"
#include "solve/contact_solve.hpp"

namespace ffcontact::plugin {

namespace {

void put(const ElasticSystem& system, Packet& packet) {
  const RowMatrix& K = system.stiffness;  // compressed
  const auto list = [](const auto* first, Index count) {
    return std::vector(first, first + count);
  };
  packet.put(list(K.outerIndexPtr(), K.rows() + 1))
      .put(list(K.innerIndexPtr(), K.nonZeros()))
      .put(list(K.valuePtr(), K.nonZeros()));
  packet.put(system.load).put(system.prescribed).put(system.prescribed_value);
}

ElasticSystem system_in(Packet& packet, int dimension) {
  const auto first = packet.take<std::vector<int>>(),
             column = packet.take<std::vector<int>>();
  const auto value = packet.take<std::vector<double>>();
  ElasticSystem system;
  system.load = packet.take<VectorXd>();
  system.prescribed = packet.take<Flags>();
  system.prescribed_value = packet.take<VectorXd>();
  system.dimension = dimension;
  const Index n = system.load.size();
  system.stiffness = Map<const RowMatrix>(n, n, count_of(value), first.data(),
                                          column.data(), value.data());
  return system;
}

/// What of a solution a process gets.
struct Share {
  long iterations = 0;
  VectorXd displacement;  ///< on its dofs; empty: none was found
  ShownNodes nodes;
  Outputs outputs;
};

Packet packet_of(const Share& share) {
  Packet packet;
  packet.put(share.iterations).put(share.displacement);
  put(share.nodes, packet);
  put(share.outputs, packet);
  return packet;
}

Share share_in(Packet& packet) {
  Share share;
  share.iterations = packet.take<long>();
  share.displacement = packet.take<VectorXd>();
  share.nodes = nodes_in(packet);
  share.outputs = outputs_in(packet);
  return share;
}

/// Outputs at the nodes are those of ShownNodes.
void drop_nodal(Outputs& outputs) {
  for (const char* name : all_nodal_names()) outputs.arrays.erase(name);
  outputs.arrays.erase("abscissa");
  outputs.integers.clear();
}

/// The whole system, and who factorises it.
template <int dim>
SharedSystem joined_system(const SharedContact& contact,
                           const SharedBodies<dim>& bodies,
                           const ElasticSystem& own,
                           std::vector<Packet> packets) {
  std::vector<ElasticSystem> systems{own};
  for (std::size_t r = 1; r < packets.size(); ++r)
    systems.push_back(system_in(packets[r], dim));
  const auto factorise = [&contact, &bodies, &own](const ElasticSystem& system,
                                                   const std::vector<int>& kept,
                                                   Precision precision) {
    return std::make_shared<const SharedStiffness>(
        contact.team, bodies.dofs(), own, system, kept, precision);
  };
  return {joined_parts(systems, bodies.vertex), factorise};
}

template <int dim>
std::vector<Share> lead(const SolveCall& call, Contact& contact,
                        const SharedBodies<dim>& bodies,
                        const ElasticSystem& own) {
  const Team& team = *contact.shared->team;
  SharedSystem system =
      joined_system(*contact.shared, bodies, own, team.gathered({}));
  SolveCall whole = call;
  whole.shared = &system;
  NamedArguments::Diverted outputs(call.named);
  ContactOf<dim>& joined = contact_in<dim>(contact);
  const long iterations = solve_here(whole, joined);
  drop_nodal(outputs);
  std::vector<Share> shares;
  const auto dofs = bodies.dofs();
  for (int r = 0; r < team.count(); ++r) {
    const bool found = system.displacement.size() > 0;
    shares.push_back(
        {iterations,
         found ? VectorXd(system.displacement(dofs[r])) : VectorXd(),
         shown_nodes(*joined.problem, bodies, r,
                     joined.solved ? &joined.solved->nodes : nullptr),
         outputs_of(outputs, bodies, r)});
  }
  return shares;
}

template <int dim>
long solve(const SolveCall& call, Contact& contact) {
  SharedContact& shared = *contact.shared;
  Team& team = *shared.team;
  const SharedBodies<dim>& bodies = bodies_of<dim>(shared);
  if (call.named.given("initial"))
    refuse("initial= is for a contact of one process so far");
  ElasticSystem own;
  Share share;
  together(
      team,
      [&] {
        own = system_of(call, bodies.own, bodies.own.joined.mesh);
        std::vector<Share> shares = lead(call, contact, bodies, own);
        for (int r = 1; r < team.count(); ++r)
          team.release(r, packet_of(shares[r]));
        share = std::move(shares[0]);
      },
      [&] {
        own = system_of(call, bodies.own, bodies.own.joined.mesh);
        Packet packet;
        put(own, packet);
        team.answer(packet);
        packet = team.served({nullptr, [&](const FactorOrder& order) {
                                return matrix_part(own, order);
                              }});
        share = share_in(packet);
      });
  shared.shown = std::move(share.nodes);
  call.named.put(call.stack, share.outputs);
  if (share.displacement.size() == 0) return share.iterations;
  write_displacement(call, bodies.own, share.displacement);
  put(call, shared.shown.own_vertex, shared.shown.abscissa,
      *shared.shown.solved);
  return share.iterations;
}

}  // namespace

long solve_shared(const SolveCall& call, Contact& contact) {
  return contact.shared->plane ? solve<2>(call, contact)
                               : solve<3>(call, contact);
}

}  // namespace ffcontact::plugin
