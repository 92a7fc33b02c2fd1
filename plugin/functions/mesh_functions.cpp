// SPDX-License-Identifier: GPL-3.0-or-later
// contactmesh for solids, and how good the cells of a mesh are.
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/cell_quality.hpp"
#include "ffcontact/sizing/cell_shape.hpp"
//
#include "freefem/arguments.hpp"
#include "freefem/guard.hpp"
#include "freefem/read_mesh.hpp"
#include "freefem/vertex_sizes.hpp"
#include "freefem/views.hpp"
#include "registration.hpp"
#include "solids.hpp"

namespace ffcontact::plugin {

namespace {

void require_set(pmesh Th) {
  if (!Th) refuse("the mesh is not set");
}
void require_set(pmesh3 Th) {
  if (!Th) refuse("the mesh3 is not set");
}

/// contactmeshcheck(Th, size): refuses what contactmesh cannot make a mesh of
template <class MeshPointer>
long contactmeshcheck(Stack, MeshPointer const& Th, KN<double>* const& size) {
  return GetAny<long>(guarded("contactmesh", [&] {
    require_set(Th);
    require_vertex_sizes(vector_of(size), Th->nv);
    return SetAny<long>(long{Th->nv});
  }));
}

/// Tn = contactmeshsolid(Th, size, corner): what contactmesh of ffcontact.idp is for a
/// mesh3
pmesh3 contactmeshsolid(Stack stack, pmesh3 const& Th, KN<double>* const& size,
                        const double& corner) {
  return GetAny<pmesh3>(guarded("contactmesh", [&] {
    return SetAny<pmesh3>(
        solids().remeshed(stack, Th, vector_of(size), corner * M_PI / 180));
  }));
}

/// worst = meshquality(Th, mean=, quality=, edge=)
template <class MeshPointer>
class MeshQuality : public E_F0mps {
 public:
  using Result = double;

  explicit MeshQuality(const basicAC_F0& arguments)
      : named_(arguments, {{"mean", &typeid(double*)},
                           {"quality", &typeid(KN<double>*)},
                           {"edge", &typeid(KN<double>*)}}),
        mesh_(to<MeshPointer>(arguments[0])) {}

  static ArrayOfaType typeargs() { return ArrayOfaType(atype<MeshPointer>()); }
  static E_F0* f(const basicAC_F0& arguments) {
    return new MeshQuality(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("meshquality", [&] {
      const auto Th = value_of<MeshPointer>(stack, mesh_);
      const VectorXd quality = quality_of(Th);
      named_.put(stack, "mean", quality.mean());
      named_.put(stack, "quality", quality);
      if (named_.given("edge")) named_.put(stack, "edge", edges_of(Th));
      return SetAny<double>(quality.minCoeff());
    });
  }

 private:
  static VectorXd quality_of(pmesh Th) { return cell_quality(mesh_of(Th)); }
  static VectorXd quality_of(pmesh3 Th) { return solids().quality(Th); }
  static VectorXd edges_of(pmesh Th) { return mean_edges(mesh_of(Th)); }
  static VectorXd edges_of(pmesh3 Th) { return solids().mean_edges(Th); }

  NamedArguments named_;
  Expression mesh_;
};

}  // namespace

void register_mesh_functions() {
  Global.Add(
      "contactmeshcheck", "(",
      new OneOperator2s_<long, pmesh, KN<double>*>(contactmeshcheck<pmesh>),
      new OneOperator2s_<long, pmesh3, KN<double>*>(contactmeshcheck<pmesh3>));
  Global.Add("contactmeshsolid", "(",
             new OneOperator3s_<pmesh3, pmesh3, KN<double>*, double>(
                 contactmeshsolid));
  Global.Add("meshquality", "(", new OneOperatorCode<MeshQuality<pmesh>>(),
             new OneOperatorCode<MeshQuality<pmesh3>>());
}

}  // namespace ffcontact::plugin
