// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "ffcontact/base/require.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
//
#include "estimate/initial_stress.hpp"
#include "estimate/linear_tractions.hpp"
#include "estimate/oscillation.hpp"
#include "estimate/springs.hpp"
#include "problem/bodies.hpp"

namespace ffcontact::plugin {

/// Reads what a script says of each body, by the names of its parameters.
template <int d>
class BodyReader {
 public:
  /// @param body  of all
  BodyReader(Stack stack, const NamedArguments& named, const Bodies<d>& bodies,
             int body)
      : stack_(stack),
        named_(named),
        part_(bodies.part(body)),
        bodies_(bodies.body_count()) {}

  std::string name(const char* parameter) const {
    return name_of_body(parameter, part_.body, bodies_);
  }
  /// The components of a list, null where it is not given.
  template <int size = d>
  std::array<Expression, size> list(const char* parameter) const {
    std::array<Expression, size> components;
    for (int c = 0; c < size; ++c)
      components[c] = named_.component(name(parameter), c, size);
    return components;
  }
  const BodyPart<d>& part() const { return part_; }

  /// lambda= and G=, or hooke=.
  HookeTensors<d> hooke() const {
    const Expression lambda = named_.expression(name("lambda")),
                     G = named_.expression(name("G"));
    const bool lame = lambda && G;
    if (lame == named_.given(name("hooke")))
      refuse("give either ", name("lambda"), "= and ", name("G"),
             "= (Lame's constants) or ", name("hooke"),
             d == 2 ? "=[C11, C12, C13, C22, C23, C33]"
                    : "=[C11, C12, ..., C16, C22, ..., C66]");
    return lame ? isotropic_by(lambda, G) : general();
  }

  FacetColumns<d> tractions(const char* parameter) const {
    return traction_moments<d>(stack_, list(parameter), part_);
  }
  /// What they have beyond linear functions, over the largest [boundary].
  VectorXd bends(const char* parameter) const {
    VectorXd off = VectorXd::Zero(part_.boundary_count());
    double largest = 0;
    for (Expression w : list(parameter)) {
      if (!w) continue;
      const Bends bends = bends_of<d>(stack_, w, part_);
      off = off.cwiseMax(bends.off);
      largest = std::max(largest, bends.largest);
    }
    return largest > 0 ? VectorXd(off / largest) : off;
  }
  BodyForce<d> force(const char* parameter) const {
    return body_force_loads<d>(stack_, list(parameter), part_);
  }

 private:
  /// C = lambda 1 x 1 + 2 G I on each cell.
  HookeTensors<d> isotropic_by(Expression lambda, Expression G) const {
    const VectorXd lambdas = at_cells<d>(stack_, lambda, part_),
                   Gs = at_cells<d>(stack_, G, part_);
    HookeTensors<d> hooke(Gs.size());
    for (Index t = 0; t < Gs.size(); ++t)
      hooke[t] = isotropic<d>(lambdas[t], Gs[t]);
    return hooke;
  }

  /// From the values of the upper triangle, row by row.
  HookeTensors<d> general() const {
    constexpr int rows = voigt_size<d>, count = rows * (rows + 1) / 2;
    const std::array<Expression, count> C = list<count>("hooke");
    HookeTensors<d> hooke(part_.cell_count());
    int place = 0;
    for (int row = 0; row < rows; ++row)
      for (int column = row; column < rows; ++column) {
        const VectorXd values = at_cells<d>(stack_, C[place++], part_);
        for (Index t = 0; t < values.size(); ++t)
          hooke[t](row, column) = hooke[t](column, row) = values[t];
      }
    return hooke;
  }

  Stack stack_;
  const NamedArguments& named_;
  BodyPart<d> part_;
  int bodies_;
};

/// Reads elastic law (lambda= and G=, or hooke=), initial strains and stresses
/// (initialstrain=, initialstress=), loads (traction=, bodyforce=) and springs (spring=,
/// rest=) of all bodies into what is judged, which may have loads of HeldSliding already.
/// @throws std::invalid_argument  if a body has not one elastic law, or springs at rest
///                                and none
template <int d>
Oscillation read_material_and_loads(Stack stack, const NamedArguments& named,
                                    const Bodies<d>& bodies,
                                    SolvedBody<d>& body) {
  const auto& joined = bodies.joined;
  body.neumann.resize(d * d, joined.first_boundary.back());
  if (body.body_loads.cols() == 0)
    body.body_loads.setZero(d * (d + 1), joined.first_cell.back());
  Oscillation all;
  all.bend.setZero(joined.first_boundary.back());
  InitialStresses<d> initial(joined.first_cell.back());
  Springs<d> springs(joined.first_boundary.back());
  for (int k = 0; k < bodies.body_count(); ++k) {
    const BodyReader<d> reader(stack, named, bodies, k);
    const HookeTensors<d> hooke = reader.hooke();
    body.hooke.insert(body.hooke.end(), hooke.begin(), hooke.end());
    const FacetColumns<d> tractions = reader.tractions("traction");
    body.neumann.middleCols(joined.first_boundary[k], tractions.cols()) =
        tractions;
    all.bend.segment(joined.first_boundary[k], tractions.cols()) =
        reader.bends("traction");
    const BodyForce<d> force = reader.force("bodyforce");
    body.body_loads.middleCols(joined.first_cell[k], force.loads.cols()) +=
        force.loads;
    springs.read(stack, named, bodies.body_count(), reader.part());
    const double strain =
        initial.add(stack, reader.template list<voigt_size<d>>("initialstrain"),
                    reader.template list<voigt_size<d>>("initialstress"), hooke,
                    reader.part());
    all.add({force.oscillation, strain});
  }
  body.initial = initial.joined();
  body.springs = std::move(springs.joined);
  return all;
}

/// The same of a call that stays, for whoever has the bodies.
template <int d>
auto reader_of(Stack stack, const NamedArguments& named) {
  return [stack, &named](const Bodies<d>& bodies, SolvedBody<d>& body) {
    return read_material_and_loads<d>(stack, named, bodies, body);
  };
}

}  // namespace ffcontact::plugin
