// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/face_part.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"

namespace ffcontact {

namespace {

bool has(const std::vector<int>& list, int value) {
  return std::binary_search(list.begin(), list.end(), value);
}

/// Places in `of` of the values of a list for which `chosen` holds.
template <class Chosen>
std::vector<int> places_in(const std::vector<int>& of,
                           const std::vector<int>& list, const Chosen& chosen) {
  std::vector<int> places;
  for (int value : list)
    if (chosen(value)) places.push_back(place_in(of, value));
  return places;
}

}  // namespace

PartSetting setting_of(const FacetSetting<3>& whole, const FaceMoments& moments,
                       std::vector<int> cells) {
  PartSetting of;
  of.part = part_of(whole.body.topology, std::move(cells));
  const std::vector<int>&cell = of.part.cell, &face = of.part.face;
  for (int t : cell) of.hooke.push_back(whole.body.hooke[t]);
  of.boundary.known = whole.body.boundary.known(Eigen::all, face);
  of.boundary.moments = whole.body.boundary.moments(Eigen::all, face);
  of.body_loads = whole.body.body_loads(Eigen::all, cell);
  of.stress = whole.body.stress.of_cells(cell);
  of.moments = moments(Eigen::all, face);
  return of;
}

FaceParts::FaceParts(const FacetSetting<3>& setting, const FaceMoments& moments,
                     std::vector<int> owner, int processes,
                     std::vector<int> contact)
    : setting_(setting),
      moments_(moments),
      owner_(std::move(owner)),
      contact_(std::move(contact)) {
  const FacetTopology<3>& topology = setting.body.topology;
  for (int r = 0; r < processes; ++r) {
    Flags own(topology.mesh.cell_count());
    for (int t = 0; t < count_of(own); ++t) own[t] = owner_[t] == r;
    cells_.push_back(cells_at(topology, edges_of_cells(topology, own)));
  }
}

FacePart FaceParts::part(int process) const {
  FacePart result;
  result.of = setting_of(setting_, moments_, cells_[process]);
  result.has_contact = !contact_.empty();
  const std::vector<int>&cell = result.of.part.cell,
        &face = result.of.part.face;
  Flags own, counted;
  for (int t : cell) own.push_back(owner_[t] == process);
  for (int f : face) counted.push_back(counts(process, f));
  result.share = facet_share<3>(result.of.part.topology, std::move(own),
                                std::move(counted));
  for (int r = 0; r < count(); ++r) {
    const auto is_own_in_halo = [&](int t) {
      return r != process && owner_[t] == process && has(cells_[r], t);
    };
    const auto is_others = [&](int t) {
      return r != process && owner_[t] == r;
    };
    result.given.push_back(places_in(cell, cell, is_own_in_halo));
    result.taken.push_back(places_in(cell, cell, is_others));
  }
  result.contact_counted =
      places_in(face, contact_, [&](int f) { return counts(process, f); });
  result.contact_known =
      places_in(face, contact_, [&](int f) { return has(face, f); });
  return result;
}

std::vector<int> FaceParts::counted(int process) const {
  return numbers_where(setting_.body.topology.facets.count(),
                       [&](int f) { return counts(process, f); });
}

std::vector<int> FaceParts::contact_counted(int process) const {
  return places_in(contact_, contact_,
                   [&](int f) { return counts(process, f); });
}

bool FaceParts::has_side(int process, int face) const {
  const Vector2i sides = setting_.body.topology.facets.cells.col(face);
  return std::any_of(sides.begin(), sides.end(), [&](int cell) {
    return cell >= 0 && has(cells_[process], cell);
  });
}

std::vector<int> FaceParts::contact_known(int process) const {
  return places_in(contact_, contact_,
                   [&](int f) { return has_side(process, f); });
}

}  // namespace ffcontact
