// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/solid_loads.hpp"

#include <array>
#include <cmath>
#include <string>

#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/stress/stress_conditions.hpp"
//
#include "estimate/initial_stress.hpp"
#include "estimate/springs.hpp"
#include "freefem/solid_point.hpp"

namespace ffcontact::plugin {

namespace {

/// An expression at the barycentre of each tetrahedron (x, y, z, region).
VectorXd at_tetrahedra(Stack stack, Expression expression,
                       const SolidPart& solid) {
  VectorXd values(solid.fem_mesh->nt);
  SolidPoint point(stack, solid);
  for (int t = 0; t < solid.fem_mesh->nt; ++t) {
    point.go_to_tetrahedron(t);
    values[t] = point.value(expression);
  }
  return values;
}

HookeTensors<3> isotropic_of(Stack stack, Expression lambda, Expression G,
                             const SolidPart& solid) {
  const VectorXd lambdas = at_tetrahedra(stack, lambda, solid),
                 Gs = at_tetrahedra(stack, G, solid);
  HookeTensors<3> hooke(Gs.size());
  for (Index t = 0; t < Gs.size(); ++t)
    hooke[t] = isotropic<3>(lambdas[t], Gs[t]);
  return hooke;
}

/// From the 21 values C11, C12, ..., C16, C22, ..., C66.
HookeTensors<3> general_of(Stack stack, const NamedArguments& named,
                           const std::string& name, const SolidPart& solid) {
  HookeTensors<3> hooke(solid.fem_mesh->nt);
  int place = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column) {
      const VectorXd values =
          at_tetrahedra(stack, named.component(name, place++, 21), solid);
      for (Index t = 0; t < values.size(); ++t)
        hooke[t](row, column) = hooke[t](column, row) = values[t];
    }
  return hooke;
}

/// The names of parameters of one of several bodies.
class NamesOfBody {
 public:
  NamesOfBody(int body, int bodies) : body_(body), bodies_(bodies) {}
  std::string operator()(const char* name) const {
    return name_of_body(name, body_, bodies_);
  }

 private:
  int body_, bodies_;
};

HookeTensors<3> hooke_of(Stack stack, const NamedArguments& named,
                         const NamesOfBody& own, const SolidPart& solid) {
  const Expression lambda = named.expression(own("lambda")),
                   G = named.expression(own("G"));
  const bool lame = lambda && G;
  if (lame == named.given(own("hooke")))
    refuse("give either ", own("lambda"), "= and ", own("G"),
           "= (Lame's constants) or ", own("hooke"),
           "=[C11, C12, ..., C16, C22, ..., C66]");
  return lame ? isotropic_of(stack, lambda, G, solid)
              : general_of(stack, named, own("hooke"), solid);
}

/// The components of a load at points of a solid, 0 where it is not given.
class SolidLoad {
 public:
  SolidLoad(const NamedArguments& named, const std::string& name) {
    for (int c = 0; c < 3; ++c) component_[c] = named.component(name, c, 3);
  }
  bool given() const { return component_[0]; }
  Vector3d at(const SolidPoint& point) const {
    Vector3d value;
    for (int c = 0; c < 3; ++c) value[c] = point.value(component_[c]);
    return value;
  }

 private:
  std::array<Expression, 3> component_;
};

/// Adds moments int F phi at the three vertices of every boundary element of a solid.
/// @param moments  of all solids [9 x boundary]
void put_tractions(Stack stack, const SolidLoad& traction,
                   const SolidPart& solid, FaceMoments& moments) {
  if (!traction.given()) return;
  const SolidMesh& mesh = solid.mesh;
  const Facets<3>& faces = solid.faces;
  const auto& quadrature = Fem2D::QuadratureFormular_T_5;
  SolidPoint point(stack, solid);
  for (int f = 0; f < faces.count(); ++f) {
    if (!faces.on_boundary(f) || !solid.has_boundary(faces.boundary_index[f]))
      continue;
    const int column = faces.boundary_index[f] - solid.first_boundary;
    const double area = facet_measure(mesh, faces, f);
    Map<Matrix3d> of_face(moments.col(faces.boundary_index[f]).data());
    for (int q = 0; q < quadrature.n; ++q) {
      const double x = quadrature[q].x, y = quadrature[q].y;
      const Vector3d phi(1 - x - y, x, y);
      point.go_to({column, phi});
      of_face += area * quadrature[q].a * traction.at(point) * phi.transpose();
    }
  }
}

/// An expression at the points of FacetQuadrature on every boundary element of a solid, 0
/// where it is null [7 x boundary].
MatrixXd at_face_points(Stack stack, Expression expression,
                        const SolidPart& solid) {
  MatrixXd values =
      MatrixXd::Zero(FacetQuadrature<3>::points, solid.fem_mesh->nbe);
  if (!expression) return values;
  SolidPoint point(stack, solid);
  for (int b = 0; b < values.cols(); ++b)
    for (int q = 0; q < values.rows(); ++q) {
      point.go_to({b, FacetQuadrature<3>::hats(q)});
      values(q, b) = point.value(expression);
    }
  return values;
}

/// A body force at the points of one tetrahedron.
struct ForceSamples {
  Matrix3Xd f;
  Matrix4Xd phi;
  VectorXd weight;
};

/// @param t  in the solid's own mesh
ForceSamples samples_of(const SolidLoad& force, double volume, int t,
                        SolidPoint& point) {
  const auto& quadrature = Fem2D::QuadratureFormular_Tet_5;
  ForceSamples samples{Matrix3Xd(3, quadrature.n), Matrix4Xd(4, quadrature.n),
                       VectorXd(quadrature.n)};
  for (int q = 0; q < quadrature.n; ++q) {
    const R3 hat(quadrature[q].x, quadrature[q].y, quadrature[q].z);
    point.go_to_tetrahedron(t, hat);
    samples.f.col(q) = force.at(point);
    samples.phi.col(q) << 1 - hat.x - hat.y - hat.z, hat.x, hat.y, hat.z;
    samples.weight[q] = volume * quadrature[q].a;
  }
  return samples;
}

/// (h / pi)^2 |f - f~|^2, h the cube root of six volumes; f~ is constant on the
/// subtetrahedra, and subtetrahedron k holds the points where phi_k is the smallest.
double oscillation_square(const ForceSamples& samples,
                          const CellBodyLoads<3>& loads, double volume) {
  const Matrix<double, 3, 4> constant = body_force_of<3>(loads, volume);
  double square = 0;
  for (Index q = 0; q < samples.weight.size(); ++q) {
    Index k;
    samples.phi.col(q).minCoeff(&k);
    square +=
        samples.weight[q] * (samples.f.col(q) - constant.col(k)).squaredNorm();
  }
  return std::pow(std::cbrt(6 * volume) / M_PI, 2) * square;
}

/// @param body_loads  of all solids [12 x tetrahedra]
/// @return their oscillation
double put_body_loads(Stack stack, const SolidLoad& force,
                      const SolidPart& solid, BodyLoadsOfCells<3>& body_loads) {
  if (!force.given()) return 0;
  SolidPoint point(stack, solid);
  double square = 0;
  for (int t = 0; t < solid.fem_mesh->nt; ++t) {
    const int cell = solid.first_cell + t;
    const double volume = signed_volume(solid.mesh, cell);
    const ForceSamples samples = samples_of(force, volume, t, point);
    const CellBodyLoads<3> loads =
        samples.f * samples.weight.asDiagonal() * samples.phi.transpose();
    body_loads.col(cell) = loads.reshaped();
    square += oscillation_square(samples, loads, volume);
  }
  return std::sqrt(square);
}

}  // namespace

Oscillation read_material_and_loads(Stack stack, const NamedArguments& named,
                                    const SolidBodies& bodies,
                                    SolvedBody<3>& body) {
  const SolidMesh& mesh = bodies.joined.mesh;
  body.neumann = FaceMoments::Zero(9, mesh.boundary.cols());
  body.body_loads = BodyLoadsOfCells<3>::Zero(12, mesh.cell_count());
  Oscillation all;
  InitialStresses<3> initial(bodies.joined.first_cell);
  Springs<3> springs(mesh.boundary.cols());
  for (int k = 0; k < bodies.body_count(); ++k) {
    const NamesOfBody own(k, bodies.body_count());
    const SolidPart solid = bodies.part(k);
    const HookeTensors<3> hooke = hooke_of(stack, named, own, solid);
    body.hooke.insert(body.hooke.end(), hooke.begin(), hooke.end());
    put_tractions(stack, {named, own("traction")}, solid, body.neumann);
    all.add({put_body_loads(stack, {named, own("bodyforce")}, solid,
                            body.body_loads),
             initial.read(stack, named, k, hooke, solid)});
    springs.read(named, k, bodies.body_count(), solid.first_boundary,
                 [&](Expression expression) {
                   return at_face_points(stack, expression, solid);
                 });
  }
  body.initial = initial.joined();
  body.springs = std::move(springs.joined);
  return all;
}

}  // namespace ffcontact::plugin
