// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/shared_outputs.hpp"

#include <algorithm>
#include <array>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/words.hpp"

namespace ffcontact::plugin {

namespace {

constexpr std::array over_cells = {"eps", "rate", "ratio", "sxx", "syy",
                                   "szz", "syz",  "sxz",   "sxy"};

/// A name of a parameter that each body has: eps, or eps2 of the second body.
struct BodyName {
  std::string name;
  int body = 0;

  BodyName(const std::string& given, int bodies) : name(given) {
    const std::size_t end = given.find_last_not_of("0123456789") + 1;
    if (bodies == 1 || end == given.size()) return;
    name = given.substr(0, end);
    body = whole_number(given.substr(end)).value_or(1) - 1;
  }
};

/// What of an array over the cells or vertices of a body those of a part have.
VectorXd of_part(const VectorXd& values, const std::vector<int>& number,
                 Index count) {
  const Index each = count > 0 ? values.size() / count : 0;
  VectorXd own(each * count_of(number));
  for (int k = 0; k < count_of(number); ++k)
    own.segment(each * k, each) = values.segment(each * number[k], each);
  return own;
}

}  // namespace

template <int dim>
Outputs outputs_of(const Outputs& whole, const SharedBodies<dim>& bodies,
                   int rank) {
  Outputs own = whole;
  for (auto& [given, values] : own.arrays) {
    const BodyName known(given, count_of(bodies.parts));
    const bool on_cells =
        std::count(over_cells.begin(), over_cells.end(), known.name) > 0;
    if (!on_cells && known.name != "size") continue;
    const MeshParts<dim>& parts = bodies.parts[known.body];
    const auto& numbers = on_cells ? parts.cell : parts.vertex;
    values = of_part(values, numbers[rank], count_in_whole(numbers));
  }
  return own;
}

template Outputs outputs_of(const Outputs&, const SharedBodies<2>&, int);
template Outputs outputs_of(const Outputs&, const SharedBodies<3>&, int);

void put(const Outputs& outputs, Packet& packet) {
  packet.put(outputs.arrays)
      .put(outputs.integers)
      .put(outputs.numbers)
      .put(outputs.counts)
      .put(outputs.flags);
}

Outputs outputs_in(Packet& packet) {
  Outputs outputs;
  outputs.arrays = packet.take<std::map<std::string, VectorXd>>();
  outputs.integers = packet.take<std::map<std::string, std::vector<long>>>();
  outputs.numbers = packet.take<std::map<std::string, double>>();
  outputs.counts = packet.take<std::map<std::string, long>>();
  outputs.flags = packet.take<std::map<std::string, bool>>();
  return outputs;
}

}  // namespace ffcontact::plugin
