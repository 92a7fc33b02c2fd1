// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
#include "ffcontact/equilibrium/tractions/free_springs.hpp"
#include "ffcontact/equilibrium/tractions/rooted_cells.hpp"
#include "ffcontact/linear/dense/symmetric_eigen.hpp"

namespace ffcontact {

/// The directions in which supports and springs answer, of boundary facets, as projectors: 0
/// where all is given.
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
    MatrixOf<d> P = MatrixOf<d>::Identity();
    for (int c = 0; c < d; ++c)
      if (boundary_.known(c, facet)) P(c, c) = 0;
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
    // what is answered by less than this part of what is answered most is not
    constexpr double least_answer = 1e-12;
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

}  // namespace ffcontact
