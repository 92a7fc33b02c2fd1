// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/team.hpp"

#include <utility>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/require.hpp"
//
#include "parallel/part_packet.hpp"

namespace ffcontact::plugin {

namespace {

MakeProcesses& maker() {
  static MakeProcesses make = nullptr;
  return make;
}

void put(Packet& packet, const FactorOrder& order) {
  packet.put(order.rows).put(order.kept).put(order.precision);
  packet.put(order.place).put(order.scale);
}

FactorOrder order_in(Packet& packet) {
  FactorOrder order;
  order.rows = packet.take<int>();
  order.kept = packet.take<int>();
  order.precision = packet.take<Precision>();
  order.place = packet.take<std::vector<int>>();
  order.scale = packet.take<VectorXd>();
  return order;
}

}  // namespace

void Team::tell(int rank, Word word, const Packet& packet) const {
  processes_->send(rank, Packet().put(word).put_packet(packet).bytes());
}

void Team::tell_all(Word word, const Packet& packet) const {
  for (int r = 1; r < count(); ++r) tell(r, word, packet);
}

Packet Team::answer_of(int rank) const {
  Packet packet(processes_->receive(rank));
  if (packet.take<Word>() == Word::failed)
    throw Failure("process " + std::to_string(rank) + ": " +
                  packet.take<std::string>());
  return packet;
}

std::vector<Packet> Team::gathered(Packet own) const {
  std::vector<Packet> all{std::move(own)};
  for (int r = 1; r < count(); ++r) all.push_back(answer_of(r));
  return all;
}

VectorXd Team::values_of(int rank, const Packet& places) const {
  tell(rank, Word::values, places);
  return answer_of(rank).take<VectorXd>();
}

void Team::release(int rank, const Packet& results) const {
  tell(rank, Word::done, results);
}

void Team::make(long number, MatrixPart part, const FactorOrder& order) {
  factors_[number] = processes_->factorised(std::move(part), order.rows,
                                            order.kept, order.precision);
}

void Team::forget(const std::vector<long>& factors) {
  for (long factor : factors) factors_.erase(factor);
}

std::pair<long, MatrixXd> Team::factorise(
    const std::vector<FactorOrder>& orders,
    const std::function<MatrixPart(const FactorOrder&)>& own) {
  const std::vector<long> discarded = std::exchange(discarded_, {});
  const long number = ++last_;
  for (int r = 1; r < count(); ++r) {
    Packet packet;
    packet.put(number).put(discarded);
    put(packet, orders[r]);
    tell(r, Word::prepare, packet);
  }
  MatrixPart part = own(orders[0]);
  for (int r = 1; r < count(); ++r) answer_of(r);
  tell_all(Word::factorise);
  forget(discarded);
  make(number, std::move(part), orders[0]);
  return {number, factor_of(number).take_schur()};
}

SharedFactor& Team::factor_of(long number) const {
  return *entry_of(factors_, number, "factor of this number");
}

VectorXd Team::condensed(long factor, const VectorXd& load) const {
  tell_all(Word::condense, Packet().put(factor));
  return factor_of(factor).condensed(load);
}

VectorXd Team::extended(long factor, const VectorXd& kept) const {
  tell_all(Word::extend, Packet().put(factor));
  return factor_of(factor).extended(kept);
}

std::vector<double> Team::relaxed(const FacetSetting<3>& setting,
                                  const RelaxationSettings& settings,
                                  std::vector<int> owner,
                                  FaceMoments& moments) const {
  LeadingRelaxation relaxation(setting, moments, std::move(owner), *processes_);
  for (int r = 1; r < count(); ++r) {
    Packet packet;
    packet.put(settings);
    put(relaxation.part_of(r), packet);
    tell(r, Word::share, packet);
  }
  relaxation.prepare();
  for (int r = 1; r < count(); ++r) answer_of(r);
  tell_all(Word::relax);
  return relaxation.relax(settings, moments);
}

void Team::discard(long factor) noexcept { discarded_.push_back(factor); }

/// Each of the others says when it knows; what it said before that is of no use.
void Team::fail_all(const std::string& sentence) const {
  tell_all(Word::failed, Packet().put(sentence));
  for (int r = 1; r < count(); ++r) wait_for(r);
}

void Team::wait_for(int rank) const {
  while (Packet(processes_->receive(rank)).take<Word>() != Word::done) {
  }
}

void Team::answer(const Packet& packet) const { tell(0, Word::values, packet); }

Packet Team::served(const Service& service) {
  MatrixPart part;
  FactorOrder order;
  std::vector<long> discarded;
  long number = 0;
  RelaxationSettings settings;
  std::unique_ptr<PartRelaxation> relaxation;
  while (true) {
    Packet packet(processes_->receive(0));
    const auto word = packet.take<Word>();
    switch (word) {
      case Word::values: answer(Packet().put(service.values(packet))); break;
      case Word::prepare:
        number = packet.take<long>();
        discarded = packet.take<std::vector<long>>();
        order = order_in(packet);
        part = service.matrix(order);
        answer({});
        break;
      case Word::factorise:
        forget(discarded);
        make(number, std::exchange(part, {}), order);
        factor_of(number).take_schur();
        break;
      case Word::condense: factor_of(packet.take<long>()).condensed({}); break;
      case Word::extend: factor_of(packet.take<long>()).extended({}); break;
      case Word::share:
        settings = packet.take<RelaxationSettings>();
        relaxation =
            std::make_unique<PartRelaxation>(face_part_in(packet), *processes_);
        answer({});
        break;
      case Word::relax:
        follow(*std::exchange(relaxation, nullptr), *processes_, settings);
        break;
      case Word::done: return packet;
      case Word::failed:
        tell(0, Word::done);
        throw FailedElsewhere(packet.take<std::string>());
    }
  }
}

void Team::fail(const std::string& sentence) const {
  tell(0, Word::failed, Packet().put(sentence));
  while (Packet(processes_->receive(0)).take<Word>() != Word::failed) {
  }
  tell(0, Word::done);
}

std::shared_ptr<Team> team_of(void* communicator) {
  static std::map<void*, std::shared_ptr<Team>> teams;
  if (!maker())
    refuse(
        "comm= needs FreeFem++-mpi and the module ffcontact_mpi: load "
        "\"ffcontact_mpi\" after \"ffcontact\"");
  std::shared_ptr<Team>& team = teams[communicator];
  if (!team) team = std::make_shared<Team>(maker()(communicator));
  return team;
}

void use_processes(MakeProcesses make) { maker() = make; }

}  // namespace ffcontact::plugin
