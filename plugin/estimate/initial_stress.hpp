// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "estimate/sampled_stress.hpp"
#include "freefem/arguments.hpp"
#include "freefem/solid_part.hpp"

namespace ffcontact::plugin {

/// Components of an expression in Voigt's order, null where it is not given.
template <int d>
using VoigtExpression = std::array<Expression, voigt_size<d>>;

/// @param strain  eps0 with engineering shear
/// @param stress  sigma0 [MPa]
InitialStress<2> initial_stress_of(Stack stack,
                                   const VoigtExpression<2>& strain,
                                   const VoigtExpression<2>& stress,
                                   const Hooke& hooke,
                                   const Fem2D::Mesh& fem_mesh);
InitialStress<3> initial_stress_of(Stack stack,
                                   const VoigtExpression<3>& strain,
                                   const VoigtExpression<3>& stress,
                                   const HookeTensors<3>& hooke,
                                   const SolidPart& solid);

/// Initial stresses of the bodies, joined; empty where none has any.
template <int d>
class InitialStresses {
 public:
  /// @param first  cell of each body, and the number of all
  explicit InitialStresses(const std::vector<int>& first) : first_(first) {}

  /// Reads those of body k. @return their oscillation
  /// @param fem_mesh  as for initial_stress_of
  template <class FemMesh>
  double read(Stack stack, const NamedArguments& named, int k,
              const HookeTensors<d>& hooke, const FemMesh& fem_mesh) {
    const VoigtExpression<d> strain = components(named, "initialstrain", k),
                             stress = components(named, "initialstress", k);
    if (!strain[0] && !stress[0]) return 0;
    if (values_.cols() == 0)
      values_.setZero(LinearStresses<d>::Values::RowsAtCompileTime,
                      first_.back());
    const InitialStress<d> own =
        initial_stress_of(stack, strain, stress, hooke, fem_mesh);
    values_.middleCols(first_[k], first_[k + 1] - first_[k]) = own.at_vertices;
    return own.oscillation;
  }

  LinearStresses<d> joined() const {
    return values_.cols() > 0 ? LinearStresses<d>::of_values(values_)
                              : LinearStresses<d>();
  }

 private:
  VoigtExpression<d> components(const NamedArguments& named, const char* name,
                                int k) const {
    const auto bodies = static_cast<int>(first_.size()) - 1;
    const std::string own = name_of_body(name, k, bodies);
    VoigtExpression<d> result;
    for (int c = 0; c < voigt_size<d>; ++c)
      result[c] = named.component(own, c, voigt_size<d>);
    return result;
  }

  const std::vector<int>& first_;
  typename LinearStresses<d>::Values values_;  ///< at the vertices of all cells
};

}  // namespace ffcontact::plugin
