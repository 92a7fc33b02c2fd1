// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/shared_relaxation.hpp"

#include <utility>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

using Number = Matrix<double, 1, 1>;

void send_to_others(const Messages& messages, const Number& number) {
  for (int r = 1; r < messages.count(); ++r) send_numbers(messages, r, number);
}

/// A number that process 0 has, on all.
double told(const Messages& messages, double of_leader) {
  Number number(of_leader);
  if (messages.rank() > 0)
    receive_numbers(messages, 0, number);
  else
    send_to_others(messages, number);
  return number[0];
}

/// Passes that process 0 makes in the contact layer, from what all have there.
class LedContact : public ContactRelaxation<3> {
 public:
  LedContact(const FaceParts& parts, const FacePart& own, ContactLayer& layer,
             const Messages& messages)
      : layer_(layer), own_(own), messages_(messages) {
    for (int r = 0; r < messages.count(); ++r) {
      counted_.push_back(parts.contact_counted(r));
      known_.push_back(parts.contact_known(r));
    }
  }

  bool is_free() const override { return own_.has_contact; }
  void weigh(double first_square) override {
    layer_.pass().weigh(first_square);
  }
  double contact_part() const override {
    return told(messages_, layer_.pass().contact_part());
  }
  double pass(double least_fall, Matrix9Xd& corrections,
              Matrix9Xd& residual) override {
    Matrix9Xd of_layer = gathered(residual),
              change = Matrix9Xd::Zero(9, of_layer.cols());
    const double fall = layer_.pass().pass(least_fall, change, of_layer);
    for (int r = 1; r < messages_.count(); ++r) {
      send_numbers(messages_, r, Matrix9Xd(change(Eigen::all, known_[r])));
      send_numbers(messages_, r, Matrix9Xd(of_layer(Eigen::all, known_[r])));
    }
    corrections(Eigen::all, own_.contact_known) +=
        change(Eigen::all, known_[0]);
    residual(Eigen::all, own_.contact_known) = of_layer(Eigen::all, known_[0]);
    return told(messages_, fall);
  }

 private:
  Matrix9Xd gathered(const Matrix9Xd& residual) const {
    Matrix9Xd of_layer(9, layer_.faces().size());
    of_layer(Eigen::all, counted_[0]) =
        residual(Eigen::all, own_.contact_counted);
    for (int r = 1; r < messages_.count(); ++r) {
      Matrix9Xd of_part(9, counted_[r].size());
      receive_numbers(messages_, r, of_part);
      of_layer(Eigen::all, counted_[r]) = of_part;
    }
    return of_layer;
  }

  ContactLayer& layer_;
  const FacePart& own_;
  const Messages& messages_;
  /// of each process in the layer, as FacePart has them in the part
  std::vector<std::vector<int>> counted_, known_;
};

/// Passes that process 0 makes.
class FollowedContact : public ContactRelaxation<3> {
 public:
  FollowedContact(const FacePart& own, const Messages& messages)
      : own_(own), messages_(messages) {}

  bool is_free() const override { return own_.has_contact; }
  double contact_part() const override { return told(messages_, 0); }
  double pass(double, Matrix9Xd& corrections, Matrix9Xd& residual) override {
    const std::vector<int>& known = own_.contact_known;
    send_numbers(messages_, 0,
                 Matrix9Xd(residual(Eigen::all, own_.contact_counted)));
    Matrix9Xd change(9, known.size()), of_layer(9, known.size());
    receive_numbers(messages_, 0, change);
    receive_numbers(messages_, 0, of_layer);
    corrections(Eigen::all, known) += change;
    residual(Eigen::all, known) = of_layer;
    return told(messages_, 0);
  }

 private:
  const FacePart& own_;
  const Messages& messages_;
};

}  // namespace

double HaloExchange::sum(double of_share) const {
  Number own(of_share);
  if (messages_.rank() > 0) send_numbers(messages_, 0, own);
  for (int r = 1; r < messages_.count() && messages_.rank() == 0; ++r) {
    Number other;
    receive_numbers(messages_, r, other);
    own += other;
  }
  return told(messages_, own[0]);
}

/// Of two processes the lower one sends first, to the lower ones before the higher ones:
/// none waits for one that waits for it.
void HaloExchange::complete(FacetImages<3>& images) const {
  for (int r = 0; r < messages_.count(); ++r) {
    const std::vector<int>&given = part_.given[r], &taken = part_.taken[r];
    if (given.empty()) continue;
    const auto send = [&] {
      send_numbers(messages_, r, FacetImages<3>(images(Eigen::all, given)));
    };
    if (messages_.rank() < r) send();
    FacetImages<3> others(36, taken.size());
    receive_numbers(messages_, r, others);
    images(Eigen::all, taken) = others;
    if (messages_.rank() > r) send();
  }
}

PartRelaxation::PartRelaxation(FacePart part, const Messages& messages)
    : part_(std::move(part)),
      exchange_(part_, messages),
      descent_(part_.of.body(), part_.of.moments, part_.share, exchange_) {}

Matrix9Xd PartRelaxation::corrections() {
  std::vector<int> counted;
  for (int f = 0; f < count_of(part_.share.counted); ++f)
    if (part_.share.counted[f]) counted.push_back(f);
  return descent_.corrections()(Eigen::all, counted);
}

LeadingRelaxation::LeadingRelaxation(const FacetSetting<3>& setting,
                                     const FaceMoments& moments,
                                     std::vector<int> owner,
                                     const Messages& messages)
    : setting_(setting),
      messages_(messages),
      layer_(setting, moments),
      parts_(setting, moments, std::move(owner), messages.count(),
             layer_.faces()) {}

void LeadingRelaxation::prepare() {
  own_ = std::make_unique<PartRelaxation>(parts_.part(0), messages_);
}

std::vector<double> LeadingRelaxation::relax(const RelaxationSettings& settings,
                                             FaceMoments& moments) {
  LedContact contact(parts_, own_->part(), layer_, messages_);
  const std::vector<double> falls = own_->relax(contact, settings);
  Matrix9Xd corrections(9, moments.cols());
  corrections(Eigen::all, parts_.counted(0)) = own_->corrections();
  own_.reset();
  for (int r = 1; r < messages_.count(); ++r) {
    const std::vector<int> counted = parts_.counted(r);
    Matrix9Xd of_part(9, counted.size());
    receive_numbers(messages_, r, of_part);
    corrections(Eigen::all, counted) = of_part;
  }
  add_corrections<3>(
      setting_.body.topology,
      without_contact<3>(setting_.body.boundary.known, setting_.contact),
      corrections, moments);
  return falls;
}

void follow(PartRelaxation& relaxation, const Messages& messages,
            const RelaxationSettings& settings) {
  FollowedContact contact(relaxation.part(), messages);
  relaxation.relax(contact, settings);
  send_numbers(messages, 0, relaxation.corrections());
}

}  // namespace ffcontact
