// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/tree_sweep.hpp"

#include <map>

#include "ffcontact/equilibrium/stress/cell_geometry.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/linear/dense/symmetric_eigen.hpp"
#include "ffcontact/mesh/cell_trees.hpp"

namespace ffcontact {

namespace {

/// Supports that answer a motion by less than this part of the one that they answer most do
/// not answer it.
constexpr double least_answer = 1e-12;

/// A point about which wrenches are taken, and the length that moments are divided by.
template <int d>
struct WrenchPoint {
  VectorOf<d> place;
  double size;

  MomentMatrix<d> arm(const VectorOf<d>& x) const {
    return moment_matrix<d>(VectorOf<d>((x - place) / size));
  }
  void add(const VectorOf<d>& x, const VectorOf<d>& force,
           Wrench<d>& sum) const {
    sum.template head<d>() += force;
    sum.template tail<CompositeElement<d>::turns>() += arm(x) * force;
  }
  /// a + c x (x - x_0) / L of (a, c)
  VectorOf<d> rigid(const VectorOf<d>& x, const Wrench<d>& motion) const {
    return motion.template head<d>() +
           arm(x).transpose() *
               motion.template tail<CompositeElement<d>::turns>();
  }
};

/// One column a cell.
template <int d>
using CellWrenches = Matrix<double, CompositeElement<d>::wrench, Dynamic>;

/// The same wrench about another point.
template <int d>
Wrench<d> moved(const Wrench<d>& w, const WrenchPoint<d>& from,
                const WrenchPoint<d>& to) {
  constexpr int turns = CompositeElement<d>::turns;
  const VectorOf<d> force = w.template head<d>();
  Wrench<d> result;
  result << force, from.size / to.size * w.template tail<turns>() +
                       to.arm(from.place) * force;
  return result;
}

/// A mesh with the trees of its cells.
template <int d>
struct RootedCells {
  const FacetTopology<d>& topology;
  const CellTrees& trees;

  /// Of the facet towards the root, or of a first cell.
  WrenchPoint<d> point(int cell) const {
    const int towards = trees.facet[cell];
    const int facet = towards >= 0 ? towards : topology.facets.of_cell(0, cell);
    const MatrixOf<d> corners = topology.facet_corners(facet);
    return {corners.rowwise().mean(), size_of_facet<d>(corners)};
  }
  /// Beyond the facet towards the root; -1: none.
  int above(int cell) const {
    const int facet = trees.facet[cell];
    if (facet < 0) return -1;
    const Vector2i sides = topology.facets.cells.col(facet);
    return sides[0] == cell ? sides[1] : sides[0];
  }
};

/// What one cell lacks about its point.
template <int d>
Wrench<d> lacking(const RootedCells<d>& rooted,
                  const BodyLoadsOfCells<d>& body_loads,
                  const FacetColumns<d>& moments, int cell) {
  const WrenchPoint<d> about = rooted.point(cell);
  const CellCorners<d> corners = rooted.topology.corners(cell);
  const CellBodyLoads<d> in_cell = loads_in_cell<d>(body_loads, cell);
  const FacetLoads<d> loads = loads_of(rooted.topology, moments, cell);
  Wrench<d> sum = Wrench<d>::Zero();
  for (int k = 0; k <= d; ++k) {
    about.add(corners.col(k), in_cell.col(k), sum);
    for (int j = 0; j < d; ++j)
      about.add(corners.col(vertex_of_facet<d>(k, j)), loads.col(d * k + j),
                sum);
  }
  return sum;
}

/// The directions in which supports answer, as a projector: 0 where all is given.
template <int d>
MatrixOf<d> answers_on(const FacetTractions<d>& boundary, int facet) {
  MatrixOf<d> P = MatrixOf<d>::Identity();
  for (int c = 0; c < d; ++c)
    if (boundary.known(c, facet)) P(c, c) = 0;
  return P;
}

template <int d>
std::vector<int> supported_facets(const Facets<d>& facets,
                                  const FacetTractions<d>& boundary) {
  std::vector<int> roots;
  for (int f = 0; f < facets.count(); ++f)
    if (facets.on_boundary(f) && !boundary.known.col(f).any())
      roots.push_back(f);
  return roots;
}

/// The directions in which supports and springs answer, of boundary facets.
template <int d>
class Answers {
 public:
  Answers(const FacetTractions<d>& boundary,
          const std::vector<FreeSpring<d>>& springs)
      : boundary_(boundary) {
    for (const FreeSpring<d>& spring : springs)
      of_springs_[spring.facet] = spring.answers;
  }
  MatrixOf<d> on(int facet) const {
    const MatrixOf<d> P = answers_on(boundary_, facet);
    const auto spring = of_springs_.find(facet);
    return spring == of_springs_.end() ? P : MatrixOf<d>(P + spring->second);
  }

 private:
  const FacetTractions<d>& boundary_;
  std::map<int, MatrixOf<d>> of_springs_;
};

/// A part of a mesh that hangs together without a root.
template <int d>
class UnrootedPart {
 public:
  UnrootedPart(const RootedCells<d>& rooted, const int* first, const int* end)
      : rooted_(rooted),
        topology_(rooted.topology),
        cells_(first, end),
        about_(middle()) {}

  const std::vector<int>& cells() const { return cells_; }

  /// Supports and springs take of the resultant what they can.
  void let_answer(const Answers<d>& answers, const CellWrenches<d>& lacking,
                  FacetColumns<d>& moments) const {
    WrenchMatrix<d> form = WrenchMatrix<d>::Zero();
    for_boundary([&](int facet) {
      for (int v : topology_.facets.vertices.col(facet))
        add_form(measure(facet) / d, v, answers.on(facet), form);
    });
    const Wrench<d> motion = motion_with(form, resultant(lacking));
    for_boundary([&](int facet) {
      const MatrixOf<d> P = measure(facet) / d * answers.on(facet);
      for (int k = 0; k < d && !P.isZero(0); ++k)
        moments.col(facet).template segment<d>(d * k) -=
            P *
            about_.rigid(place(topology_.facets.vertices(k, facet)), motion);
    });
  }

  /// Takes from the cells a body force that has their resultant.
  void keep(CellWrenches<d>& lacking) const {
    WrenchMatrix<d> form = WrenchMatrix<d>::Zero();
    for_corners([&](int, int v, double volume) {
      add_form(volume, v, MatrixOf<d>::Identity(), form);
    });
    const Wrench<d> motion = motion_with(form, resultant(lacking));
    for_corners([&](int cell, int v, double volume) {
      Wrench<d> sum = Wrench<d>::Zero();
      rooted_.point(cell).add(place(v), volume * about_.rigid(place(v), motion),
                              sum);
      lacking.col(cell) -= sum;
    });
  }

 private:
  VectorOf<d> place(int vertex) const {
    return topology_.mesh.vertices.col(vertex);
  }
  double measure(int facet) const {
    return facet_measure(topology_.mesh, topology_.facets, facet);
  }

  template <class OfFacet>
  void for_boundary(const OfFacet& of_facet) const {
    for (int t : cells_)
      for (int facet : topology_.facets.of_cell.col(t))
        if (topology_.facets.on_boundary(facet)) of_facet(facet);
  }
  /// Calls of_corner(cell, vertex, volume that belongs to both).
  template <class OfCorner>
  void for_corners(const OfCorner& of_corner) const {
    for (int t : cells_)
      for (int v : topology_.mesh.cells.col(t))
        of_corner(t, v, signed_volume(topology_.mesh, t) / (d + 1));
  }

  WrenchPoint<d> middle() const {
    VectorOf<d> low = place(topology_.mesh.cells(0, cells_[0])), high = low;
    for_corners([&](int, int v, double) {
      low = low.cwiseMin(place(v));
      high = high.cwiseMax(place(v));
    });
    return {(low + high) / 2, (high - low).norm() / 2};
  }

  Wrench<d> resultant(const CellWrenches<d>& lacking) const {
    Wrench<d> sum = Wrench<d>::Zero();
    for (int t : cells_)
      sum += moved<d>(lacking.col(t), rooted_.point(t), about_);
    return sum;
  }

  /// Adds weight N P N', N the wrench of a force at the vertex.
  void add_form(double weight, int vertex, const MatrixOf<d>& P,
                WrenchMatrix<d>& form) const {
    Matrix<double, CompositeElement<d>::wrench, d> N;
    N << MatrixOf<d>::Identity(), about_.arm(place(vertex));
    form += weight * N * P * N.transpose();
  }

  /// form^+ w
  static Wrench<d> motion_with(const WrenchMatrix<d>& form,
                               const Wrench<d>& w) {
    const SymmetricEigen axes = symmetric_eigen(form);
    const double least = least_answer * axes.values.maxCoeff();
    Wrench<d> motion = Wrench<d>::Zero();
    for (int k = 0; k < motion.size(); ++k)
      if (axes.values[k] > least)
        motion +=
            axes.vectors.col(k).dot(w) / axes.values[k] * axes.vectors.col(k);
    return motion;
  }

  const RootedCells<d>& rooted_;
  const FacetTopology<d>& topology_;
  std::vector<int> cells_;
  WrenchPoint<d> about_;
};

/// Every wrench and those from below it, each about its cell's point.
template <int d>
void add_up(const RootedCells<d>& rooted, CellWrenches<d>& wrenches) {
  const std::vector<int>& cells = rooted.trees.cell;
  for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell) {
    const int above = rooted.above(*cell);
    if (above >= 0)
      wrenches.col(above) += moved<d>(wrenches.col(*cell), rooted.point(*cell),
                                      rooted.point(above));
  }
}

}  // namespace

template <int d>
void sweep_to_roots(const FacetTopology<d>& topology,
                    const BodyLoadsOfCells<d>& body_loads,
                    const FacetTractions<d>& boundary,
                    const std::vector<FreeSpring<d>>& springs,
                    FacetColumns<d>& moments) {
  const CellTrees trees =
      cell_trees(topology.facets, supported_facets(topology.facets, boundary));
  const RootedCells<d> rooted{topology, trees};
  const int cells = topology.mesh.cell_count();
  CellWrenches<d> wrenches(CompositeElement<d>::wrench, cells);
#pragma omp parallel for
  for (int t = 0; t < cells; ++t)
    wrenches.col(t) = lacking(rooted, body_loads, moments, t);

  const Answers<d> answers(boundary, springs);
  for (std::size_t k = 1; k < trees.without_root.size(); ++k) {
    const UnrootedPart<d> part(rooted, &trees.cell[trees.without_root[k - 1]],
                               &trees.cell[0] + trees.without_root[k]);
    part.let_answer(answers, wrenches, moments);
    for (int t : part.cells())
      wrenches.col(t) = lacking(rooted, body_loads, moments, t);
    part.keep(wrenches);
  }

  add_up(rooted, wrenches);
#pragma omp parallel for
  for (int t = 0; t < cells; ++t) {
    const int facet = trees.facet[t];
    if (facet < 0) continue;
    const double eta = topology.facets.cells(0, facet) == t ? 1 : -1;
    moments.col(facet) -= eta *
                          wrench_moments<d>(topology.facet_corners(facet)) *
                          wrenches.col(t);
  }
}

template void sweep_to_roots(
    const FacetTopology<FFCONTACT_DIMENSION>&,
    const BodyLoadsOfCells<FFCONTACT_DIMENSION>&,
    const FacetTractions<FFCONTACT_DIMENSION>&,
    const std::vector<FreeSpring<FFCONTACT_DIMENSION>>&,
    FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
