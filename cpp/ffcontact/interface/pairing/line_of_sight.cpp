// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/line_of_sight.hpp"

#include <algorithm>

namespace ffcontact {

namespace {

/// How often a body covers a place on the line.
int cover(const std::vector<Crossing>& body, double place) {
  int times = 0;
  for (const Crossing& crossing : body)
    if (crossing.distance <= place) times += crossing.enters ? 1 : -1;
  return times;
}

/// Is all that is between two places inside a body? Gaps in it below `none` are none.
bool is_inside(const std::vector<Crossing>& body, double from, double to,
               double none) {
  const auto is_left = [&](const Crossing& crossing) {
    const double next = crossing.distance + none;
    return !crossing.enters && crossing.distance > from && next < to &&
           cover(body, next) < 1;
  };
  return cover(body, from) > 0 && cover(body, to) > 0 &&
         std::none_of(body.begin(), body.end(), is_left);
}

}  // namespace

bool LineOfSight::is_faced(double s) const {
  if (s < -touching) {
    const bool y_is = is_inside(own, s - touching, -touching, touching),
               x_is = is_inside(other, s + touching, touching, touching);
    return is_one_body ? x_is && y_is : x_is || y_is;
  }
  return std::none_of(own.begin(), own.end(), [&](const Crossing& crossing) {
    return crossing.enters && crossing.distance > touching &&
           crossing.distance < s - touching;
  });
}

}  // namespace ffcontact
