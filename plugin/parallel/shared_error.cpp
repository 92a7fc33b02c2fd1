// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/shared_error.hpp"

#include <cmath>
#include <utility>

#include "ffcontact/base/packed.hpp"
//
#include "parallel/shared_outputs.hpp"

namespace ffcontact::plugin {

namespace {

/// What is read of bodies, as columns over their cells and their boundaries.
struct ReadColumns {
  std::vector<MatrixXd> cells, boundary;
  std::vector<double> oscillation;
};

void put(const std::vector<MatrixXd>& kinds, Packet& packet) {
  packet.put(kinds.size());
  for (const MatrixXd& of_kind : kinds) packet.put(of_kind);
}

void put(const ReadColumns& read, Packet& packet) {
  put(read.cells, packet);
  put(read.boundary, packet);
  packet.put(read.oscillation);
}

std::vector<MatrixXd> columns_in(Packet& packet) {
  std::vector<MatrixXd> columns(packet.take<std::size_t>());
  for (MatrixXd& of_kind : columns) of_kind = packet.take<MatrixXd>();
  return columns;
}

ReadColumns read_in(Packet& packet) {
  ReadColumns read;
  read.cells = columns_in(packet);
  read.boundary = columns_in(packet);
  read.oscillation = packet.take<std::vector<double>>();
  return read;
}

/// Kind k of the columns of all processes as that of the whole.
MatrixXd joined(const std::vector<ReadColumns>& all,
                std::vector<MatrixXd> ReadColumns::*columns, std::size_t k,
                const std::vector<std::vector<int>>& number) {
  std::vector<MatrixXd> of_kind;
  for (const ReadColumns& read : all) of_kind.push_back((read.*columns)[k]);
  if (of_kind[0].cols() == 0 && count_of(number[0]) > 0)
    return MatrixXd(of_kind[0].rows(), 0);  // there is none
  return of_whole(of_kind, number);
}

template <int dim>
ReadColumns joined(const std::vector<ReadColumns>& all,
                   const SharedBodies<dim>& bodies) {
  ReadColumns whole;
  for (std::size_t k = 0; k < all[0].cells.size(); ++k)
    whole.cells.push_back(joined(all, &ReadColumns::cells, k, bodies.cell));
  for (std::size_t k = 0; k < all[0].boundary.size(); ++k)
    whole.boundary.push_back(
        joined(all, &ReadColumns::boundary, k, bodies.boundary));
  for (std::size_t k = 0; k < all[0].oscillation.size(); ++k) {
    double norm = 0;
    for (const ReadColumns& read : all)
      norm = std::hypot(norm, read.oscillation[k]);
    whole.oscillation.push_back(norm);
  }
  return whole;
}

/// One column a cell.
template <class Tensors>
MatrixXd columns_of(const Tensors& hooke) {
  const Index size = hooke.empty() ? 0 : hooke[0].size();
  MatrixXd columns(size, count_of(hooke));
  for (Index t = 0; t < columns.cols(); ++t)
    columns.col(t) = hooke[t].reshaped();
  return columns;
}

template <class Tensors>
Tensors tensors_of(const MatrixXd& columns) {
  Tensors hooke(columns.cols());
  for (Index t = 0; t < columns.cols(); ++t)
    hooke[t].reshaped() = columns.col(t);
  return hooke;
}

template <class Body>
ReadColumns columns_of(const Body& body, const Oscillation& oscillation) {
  return {{columns_of(body.hooke), body.body_loads, body.initial.values()},
          {body.neumann, body.springs.stiffness, body.springs.rest},
          {oscillation.force, oscillation.strain}};
}

template <class Body>
Oscillation take(const ReadColumns& whole, Body& body) {
  body.hooke = tensors_of<decltype(body.hooke)>(whole.cells[0]);
  if (body.body_loads.cols() > 0)  // of HeldSliding
    body.body_loads += whole.cells[1];
  else
    body.body_loads = whole.cells[1];
  if (whole.cells[2].cols() > 0)
    body.initial = decltype(body.initial)::of_values(whole.cells[2]);
  body.neumann = whole.boundary[0];
  body.springs.stiffness = whole.boundary[1];
  body.springs.rest = whole.boundary[2];
  return {whole.oscillation[0], whole.oscillation[1]};
}

/// A call whose value and outputs process 0 finds, from a packet of each process.
template <int dim>
double called(Stack stack, const NamedArguments& named, Team& team,
              const SharedBodies<dim>& bodies,
              const std::function<Packet()>& own,
              const std::function<double(std::vector<Packet>)>& whole) {
  double value = 0;
  Outputs outputs;
  together(
      team,
      [&] {
        std::vector<Packet> packets = team.gathered(own());
        NamedArguments::Diverted all(named);
        value = whole(std::move(packets));
        for (int r = 1; r < team.count(); ++r) {
          Packet packet;
          packet.put(value);
          plugin::put(outputs_of<dim>(all, bodies, r), packet);
          team.release(r, packet);
        }
        outputs = outputs_of<dim>(all, bodies, 0);
      },
      [&] {
        team.answer(own());
        Packet packet = team.served({nullptr, nullptr});
        value = packet.take<double>();
        outputs = outputs_in(packet);
      });
  named.put(stack, outputs);
  return value;
}

template <int d>
double error(Stack stack, const NamedArguments& named, SharedContact& contact,
             const ReadBodies<d>& read,
             const std::function<double(const ReadBodies<d>&)>& judge) {
  const SharedBodies<d>& bodies = bodies_of<d>(contact);
  return called<d>(
      stack, named, *contact.team, bodies,
      [&] {
        SolvedBody<d> body;
        const auto oscillation = read(bodies.own, body);
        Packet packet;
        put(columns_of(body, oscillation), packet);
        return packet;
      },
      [&](std::vector<Packet> packets) {
        std::vector<ReadColumns> all;
        for (Packet& packet : packets) all.push_back(read_in(packet));
        return judge([&](const auto&, SolvedBody<d>& body) {
          return take(joined(all, bodies), body);
        });
      });
}

template <int dim>
double sizes(Stack stack, const NamedArguments& named, SharedContact& contact,
             const std::vector<VectorXd>& arrays,
             const std::function<double(const std::vector<VectorXd>&)>& make) {
  const SharedBodies<dim>& bodies = bodies_of<dim>(contact);
  return called<dim>(
      stack, named, *contact.team, bodies,
      [&] {
        Packet packet;
        for (const VectorXd& array : arrays) packet.put(array);
        return packet;
      },
      [&](std::vector<Packet> packets) {
        std::vector<VectorXd> whole;
        for (std::size_t k = 0; k < arrays.size(); ++k) {
          std::vector<MatrixXd> rows;
          for (Packet& packet : packets)
            rows.emplace_back(packet.take<VectorXd>().transpose());
          whole.push_back(
              rows[0].cols() == 0
                  ? VectorXd()
                  : VectorXd(of_whole(rows, bodies.cell).transpose()));
        }
        return make(whole);
      });
}

}  // namespace

template <int d>
double error_shared(Stack stack, const NamedArguments& named,
                    SharedContact& contact, const ReadBodies<d>& read,
                    const std::function<double(const ReadBodies<d>&)>& judge) {
  return error<d>(stack, named, contact, read, judge);
}

template double error_shared(
    Stack, const NamedArguments&, SharedContact&, const ReadBodies<2>&,
    const std::function<double(const ReadBodies<2>&)>&);
template double error_shared(
    Stack, const NamedArguments&, SharedContact&, const ReadBodies<3>&,
    const std::function<double(const ReadBodies<3>&)>&);

RelaxFacets<3> relax_shared(const SharedContact& contact) {
  return [&contact](const FacetSetting<3>& setting,
                    const RelaxationSettings& settings,
                    FaceMoments& moments) -> std::vector<double> {
    if (settings.steps == 0) return {};
    if (!setting.body.terms.empty())  // springs: by this process alone
      return relax_facets<3>(setting, settings, moments);
    std::vector<int> owner(setting.body.topology.mesh.cell_count());
    const auto& cells = contact.solid->cell;
    for (int r = 0; r < count_of(cells); ++r)
      for (int t : cells[r]) owner[t] = r;
    return contact.team->relaxed(setting, settings, std::move(owner), moments);
  };
}

double sizes_shared(
    Stack stack, const NamedArguments& named, SharedContact& contact,
    const std::vector<VectorXd>& arrays,
    const std::function<double(const std::vector<VectorXd>&)>& make) {
  return contact.plane ? sizes<2>(stack, named, contact, arrays, make)
                       : sizes<3>(stack, named, contact, arrays, make);
}

}  // namespace ffcontact::plugin
