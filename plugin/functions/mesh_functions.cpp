// SPDX-License-Identifier: GPL-3.0-or-later
// contactmesh for solids, and how good the cells of a mesh are.
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/cell_quality.hpp"
//
#include "freefem/arguments.hpp"
#include "freefem/guard.hpp"
#include "freefem/views.hpp"
#include "registration.hpp"
#include "solids.hpp"

namespace ffcontact::plugin {

namespace {

/// Tn = contactmeshsolid(Th, size, corner): what contactmesh of ffcontact.idp is for a
/// mesh3
pmesh3 contactmeshsolid(Stack stack, pmesh3 const& Th, KN<double>* const& size,
                        const double& corner) {
  return GetAny<pmesh3>(guarded("contactmesh", [&] {
    return SetAny<pmesh3>(
        solids().remeshed(stack, Th, vector_of(size), corner * M_PI / 180));
  }));
}

/// worst = meshquality(Th, mean=, quality=)
template <class MeshPointer>
class MeshQuality : public E_F0mps {
 public:
  using Result = double;

  explicit MeshQuality(const basicAC_F0& arguments)
      : named_(arguments,
               {{"mean", &typeid(double*)}, {"quality", &typeid(KN<double>*)}}),
        mesh_(to<MeshPointer>(arguments[0])) {}

  static ArrayOfaType typeargs() { return ArrayOfaType(atype<MeshPointer>()); }
  static E_F0* f(const basicAC_F0& arguments) {
    return new MeshQuality(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("meshquality", [&] {
      const VectorXd quality = quality_of(value_of<MeshPointer>(stack, mesh_));
      named_.put(stack, "mean", quality.mean());
      named_.put(stack, "quality", quality);
      return SetAny<double>(quality.minCoeff());
    });
  }

 private:
  static VectorXd quality_of(pmesh Th) { return cell_quality(mesh_of(Th)); }
  static VectorXd quality_of(pmesh3 Th) { return solids().quality(Th); }

  NamedArguments named_;
  Expression mesh_;
};

}  // namespace

void register_mesh_functions() {
  Global.Add("contactmeshsolid", "(",
             new OneOperator3s_<pmesh3, pmesh3, KN<double>*, double>(
                 contactmeshsolid));
  Global.Add("meshquality", "(", new OneOperatorCode<MeshQuality<pmesh>>(),
             new OneOperatorCode<MeshQuality<pmesh3>>());
}

}  // namespace ffcontact::plugin
