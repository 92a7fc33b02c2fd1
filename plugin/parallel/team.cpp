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
  packet.put(order.storage);
  packet.put(order.place).put(order.scale);
}

void put(Packet& packet, const SparseMatrix& matrix) {
  Triplets entries;
  for (Index j = 0; j < matrix.cols(); ++j)
    for (SparseMatrix::InnerIterator e(matrix, j); e; ++e)
      entries.emplace_back(e.row(), e.col(), e.value());
  packet.put(matrix.rows()).put(matrix.cols()).put(entries);
}

SparseMatrix matrix_in(Packet& packet) {
  const auto rows = packet.take<Index>(), columns = packet.take<Index>();
  return packed(rows, columns, packet.take<Triplets>());
}

FactorOrder order_in(Packet& packet) {
  FactorOrder order;
  order.rows = packet.take<int>();
  order.kept = packet.take<int>();
  order.precision = packet.take<Precision>();
  order.storage = packet.take<SchurStorage>();
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
  auto factor = processes_->factorised(std::move(part), order.rows, order.kept,
                                       order.precision, order.storage);
  if (order.storage == SchurStorage::distributed)
    blocks_[number] = factor->take_block();
  factors_[number] = std::move(factor);
}

void Team::forget(const std::vector<long>& factors) {
  for (long factor : factors) {
    factors_.erase(factor);
    blocks_.erase(factor);
    rows_.erase(factor);
  }
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
  if (orders[0].storage == SchurStorage::whole)
    return {number, factor_of(number).take_schur()};
  rows_[number] = {block_of(number).row};
  for (int r = 1; r < count(); ++r)
    rows_[number].push_back(answer_of(r).take<std::vector<int>>());
  return {number, MatrixXd()};
}

SharedFactor& Team::factor_of(long number) const {
  return *entry_of(factors_, number, "factor of this number");
}

const SchurBlock& Team::block_of(long number) const {
  return entry_of(blocks_, number, "block of this number");
}

VectorXd Team::schur_product(long factor, const VectorXd& x) const {
  tell_all(Word::multiply, Packet().put(factor).put(x));
  const auto& rows = entry_of(rows_, factor, "rows of this factor");
  VectorXd y = VectorXd::Zero(x.size());
  y(rows[0]) += product_part(block_of(factor), x);
  for (int r = 1; r < count(); ++r) y(rows[r]) += answer_of(r).take<VectorXd>();
  return y;
}

MatrixXd Team::schur_congruent(long factor, const SparseMatrix& R) const {
  Packet packet;
  packet.put(factor);
  put(packet, R);
  tell_all(Word::reduce, packet);
  MatrixXd sum = congruent_part(block_of(factor), R);
  for (int r = 1; r < count(); ++r) sum += answer_of(r).take<MatrixXd>();
  return sum;
}

SparseMatrix Team::schur_diagonal_blocks(long factor,
                                         const std::vector<int>& group) const {
  tell_all(Word::show_diagonal, Packet().put(factor).put(group));
  Triplets entries = diagonal_part(block_of(factor), group);
  for (int r = 1; r < count(); ++r) {
    const auto others = answer_of(r).take<Triplets>();
    entries.insert(entries.end(), others.begin(), others.end());
  }
  return packed(count_of(group), count_of(group), entries);
}

void Team::answer_about_schur(Word word, Packet& packet) const {
  const SchurBlock& block = block_of(packet.take<long>());
  if (word == Word::multiply)
    answer(Packet().put(product_part(block, packet.take<VectorXd>())));
  else if (word == Word::reduce)
    answer(Packet().put(congruent_part(block, matrix_in(packet))));
  else
    answer(Packet().put(diagonal_part(block, packet.take<std::vector<int>>())));
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
        if (order.storage == SchurStorage::whole)
          factor_of(number).take_schur();
        else
          answer(Packet().put(block_of(number).row));
        break;
      case Word::multiply:
      case Word::reduce:
      case Word::show_diagonal: answer_about_schur(word, packet); break;
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
