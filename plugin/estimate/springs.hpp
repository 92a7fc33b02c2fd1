// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"
//
#include "freefem/arguments.hpp"
#include "freefem/body_values.hpp"

namespace ffcontact::plugin {

/// Springs of the bodies (spring=, rest=), joined; empty where none has any.
template <int d>
class Springs {
 public:
  /// @param columns  of the joined boundary
  explicit Springs(Index columns) : columns_(columns) {}

  /// Of one body.
  /// @throws std::invalid_argument  for springs at rest and none, and other lists
  void read(Stack stack, const NamedArguments& named, int bodies,
            const BodyPart<d>& part) {
    const auto at_points = [&](Expression expression) {
      return along_boundary<d>(stack, expression, part,
                               facet_quadrature_hats<d>());
    };
    const std::string spring = name_of_body("spring", part.body, bodies),
                      rest = name_of_body("rest", part.body, bodies);
    if (!named.given(spring)) {
      if (named.given(rest)) refuse(rest, "= is for ", spring, "=");
      return;
    }
    if (joined.empty()) joined = BoundarySprings<d>(columns_);
    const std::array<Expression, components> K = stiffness_of(named, spring);
    for (int c = 0; c < components; ++c)
      put_rows(at_points(K[c]), c, components, part.first_boundary,
               joined.stiffness);
    for (int c = 0; c < d; ++c)
      put_rows(at_points(named.component(rest, c, d)), c, d,
               part.first_boundary, joined.rest);
  }

  BoundarySprings<d> joined;

 private:
  static constexpr int components = BoundarySprings<d>::components;

  /// [kx, ky] or [kxx, kxy, kyy]; in space [kx, ky, kz] or [kxx, kxy, kxz, kyy, kyz, kzz].
  static std::array<Expression, components> stiffness_of(
      const NamedArguments& named, const std::string& name) {
    const int size = named.component_count(name);
    if (size != d && size != components)
      refuse(name, " must be a list ",
             d == 2 ? "[kx, ky] or [kxx, kxy, kyy]"
                    : "[kx, ky, kz] or [kxx, kxy, kxz, kyy, kyz, kzz]");
    std::array<Expression, components> K{};
    if (size == components)
      for (int c = 0; c < components; ++c)
        K[c] = named.component(name, c, size);
    else
      for (int i = 0, diagonal = 0; i < d; diagonal += d - i++)
        K[diagonal] = named.component(name, i, size);
    return K;
  }

  /// Component c of so many at each point.
  template <class Rows>
  static void put_rows(const MatrixXd& values, int c, int count,
                       Index first_column, Rows& rows) {
    for (Index q = 0; q < values.rows(); ++q)
      rows.row(c + count * q).segment(first_column, values.cols()) =
          values.row(q);
  }

  Index columns_;
};

}  // namespace ffcontact::plugin
