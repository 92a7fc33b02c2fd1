// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/ridge_form.hpp"

#include <algorithm>

namespace ffcontact {

namespace {

template <int d>
WrenchShift<d> shift_at(const FacetTopology<d>& topology, int ridge,
                        int place) {
  return wrench_shift<d>(topology, topology.ridges.facets_of(ridge)[place],
                         ridge);
}

/// Z_i' H Z_j, Z = diag(s Shift, I) of a facet, Shift = (I, 0; -arm x, ratio I).
template <int d>
FacetMatrix<d> shifted(const WrenchShift<d>& rows, FacetMatrix<d> H,
                       const WrenchShift<d>& columns) {
  constexpr int turns = CompositeElement<d>::turns;
  H.template topRows<d>() -=
      moment_matrix<d>(rows.arm).transpose() * H.template middleRows<turns>(d);
  H.template topRows<d>() *= rows.sign;
  H.template middleRows<turns>(d) *= rows.sign * rows.ratio;
  H.template leftCols<d>() -=
      H.template middleCols<turns>(d) * moment_matrix<d>(columns.arm);
  H.template leftCols<d>() *= columns.sign;
  H.template middleCols<turns>(d) *= columns.sign * columns.ratio;
  return H;
}

/// The lower triangle of A, filled facet by facet and wedge by wedge.
template <int d>
class RidgeForm {
 public:
  using Element = CompositeElement<d>;
  static constexpr int wrench = Element::wrench, modes = Element::modes;

  explicit RidgeForm(int size) : A_(MatrixXd::Zero(size, size)) {}

  /// The block of a facet with itself.
  void add_own(int place, const FacetMatrix<d>& H) {
    const int first = wrench + modes * place;
    A_.topLeftCorner<wrench, wrench>() +=
        H.template topLeftCorner<wrench, wrench>();
    A_.block<modes, wrench>(first, 0) +=
        H.template bottomLeftCorner<modes, wrench>();
    A_.block<modes, modes>(first, first) +=
        H.template bottomRightCorner<modes, modes>();
  }
  /// The block of a facet b with one before it, a.
  void add_cross(int b, int a, const FacetMatrix<d>& H) {
    const int of_a = wrench + modes * a, of_b = wrench + modes * b;
    const auto of_wrench = H.template topLeftCorner<wrench, wrench>();
    A_.topLeftCorner<wrench, wrench>() += of_wrench + of_wrench.transpose();
    A_.block<modes, wrench>(of_a, 0) +=
        H.template topRightCorner<wrench, modes>().transpose();
    A_.block<modes, wrench>(of_b, 0) +=
        H.template bottomLeftCorner<modes, wrench>();
    A_.block<modes, modes>(of_b, of_a) +=
        H.template bottomRightCorner<modes, modes>();
  }

  MatrixXd full() && {
    A_.triangularView<Eigen::StrictlyUpper>() = A_.transpose();
    return std::move(A_);
  }

 private:
  MatrixXd A_;
};

/// Adds Z_i' H Z_j of a facet around one ridge with one around another.
template <int d>
void add_coupling(int i, int j, const FacetMatrix<d>& H, MatrixXd& A) {
  constexpr int wrench = CompositeElement<d>::wrench,
                modes = CompositeElement<d>::modes;
  const int of_i = wrench + modes * i, of_j = wrench + modes * j;
  A.topLeftCorner<wrench, wrench>() +=
      H.template topLeftCorner<wrench, wrench>();
  A.block<wrench, modes>(0, of_j) += H.template topRightCorner<wrench, modes>();
  A.block<modes, wrench>(of_i, 0) +=
      H.template bottomLeftCorner<modes, wrench>();
  A.block<modes, modes>(of_i, of_j) +=
      H.template bottomRightCorner<modes, modes>();
}

}  // namespace

template <int d>
std::vector<Wedge> wedges_of(const FacetTopology<d>& topology, int ridge) {
  const Facets<d>& facets = topology.facets;
  const auto around = topology.ridges.facets_of(ridge);
  const int count = topology.ridges.facet_count(ridge);
  std::vector<Wedge> wedges, half;  // those whose second facet is still to come
  wedges.reserve(count);
  half.reserve(count);
  for (int b = 0; b < count; ++b)
    for (int t : facets.cells.col(around[b])) {
      if (t < 0) continue;
      const int local = facets.side_of_cell(around[b], t);
      const auto of_cell =
          std::find_if(half.begin(), half.end(),
                       [&](const Wedge& wedge) { return wedge.cell == t; });
      if (of_cell == half.end()) {
        half.push_back({t, {b, -1}, {local, -1}});
      } else {
        wedges.push_back(
            {t, {of_cell->place[0], b}, {of_cell->local[0], local}});
        half.erase(of_cell);
      }
    }
  return wedges;
}

template <int d>
WrenchShifts<d> shifts_around(const FacetTopology<d>& topology, int ridge) {
  WrenchShifts<d> shifts;
  for (int facet : topology.ridges.facets_of(ridge))
    shifts.push_back(wrench_shift<d>(topology, facet, ridge));
  return shifts;
}

template <int d>
MatrixXd ridge_form(const FacetTopology<d>& topology, int ridge,
                    const WrenchShift<d>* shifts, const FacetForms<d>& forms) {
  const int count = topology.ridges.facet_count(ridge);
  RidgeForm<d> form(unknowns_around<d>(topology.ridges, ridge));
  std::vector<FacetMatrix<d>> own(count, FacetMatrix<d>::Zero());
  for (const auto& [cell, place, local] : wedges_of<d>(topology, ridge)) {
    for (int side = 0; side < 2; ++side)
      own[place[side]] +=
          forms.block(cell, local[side], local[side]).template cast<double>();
    form.add_cross(
        place[1], place[0],
        shifted<d>(
            shifts[place[1]],
            forms.block(cell, local[1], local[0]).template cast<double>(),
            shifts[place[0]]));
  }
  for (int i = 0; i < count; ++i)
    form.add_own(i, shifted<d>(shifts[i], own[i], shifts[i]));
  return std::move(form).full();
}

template <int d>
MatrixXd coupling_form(const FacetTopology<d>& topology, int a,
                       const WrenchShift<d>* shifts_a, int b,
                       const WrenchShift<d>* shifts_b,
                       const FacetForms<d>& forms) {
  MatrixXd A = MatrixXd::Zero(unknowns_around<d>(topology.ridges, a),
                              unknowns_around<d>(topology.ridges, b));
  const std::vector<Wedge> around_b = wedges_of<d>(topology, b);
  for (const Wedge& of_a : wedges_of<d>(topology, a))
    for (const Wedge& of_b : around_b) {
      if (of_a.cell != of_b.cell) continue;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          add_coupling<d>(
              of_a.place[i], of_b.place[j],
              shifted<d>(shifts_a[of_a.place[i]],
                         forms.block(of_a.cell, of_a.local[i], of_b.local[j])
                             .template cast<double>(),
                         shifts_b[of_b.place[j]]),
              A);
    }
  return A;
}

template <int d>
MatrixXd ridge_conditions(const FacetTopology<d>& topology, int ridge,
                          const WrenchShift<d>* shifts,
                          const KnownTractions<d>& known,
                          const KnownDirections<d>& directions) {
  constexpr int wrench = CompositeElement<d>::wrench,
                modes = CompositeElement<d>::modes,
                moments = CompositeElement<d>::moments;
  const Ridges<d>& ridges = topology.ridges;
  MatrixXd rows =
      MatrixXd::Zero(2 * moments, unknowns_around<d>(ridges, ridge));
  int next = 0;
  for (int i = 0; i < ridges.facet_count(ridge); ++i) {
    const int facet = ridges.facets_of(ridge)[i];
    if (!topology.facets.on_boundary(facet)) continue;
    const FacetMatrix<d> V = wrench_basis<d>(topology.facet_corners(facet));
    const WrenchMatrix<d> shift = shifts[i].matrix();
    const auto add = [&](const Matrix<double, 1, moments>& of_moments) {
      rows.block<1, wrench>(next, 0) =
          of_moments.template head<wrench>() * shift;
      rows.block<1, modes>(next++, wrench + modes * i) =
          of_moments.template tail<modes>();
    };
    for (int row = 0; row < moments; ++row)
      if (known(row % d, facet)) add(V.row(row));
    const auto own = directions.find(facet);
    if (own == directions.end()) continue;
    for (const auto direction : own->second.colwise())
      for (int j = 0; j < d; ++j)
        add(direction.transpose() * V.template middleRows<d>(d * j));
  }
  return rows.topRows(next);
}

template <int d>
VectorXd restricted(const FacetTopology<d>& topology, int ridge,
                    const FacetColumns<d>& g) {
  constexpr int wrench = CompositeElement<d>::wrench,
                modes = CompositeElement<d>::modes;
  const Ridges<d>& ridges = topology.ridges;
  VectorXd x = VectorXd::Zero(unknowns_around<d>(ridges, ridge));
  for (int i = 0; i < ridges.facet_count(ridge); ++i) {
    const FacetVector<d> of_facet = g.col(ridges.facets_of(ridge)[i]);
    x.head<wrench>() += shift_at<d>(topology, ridge, i)
                            .transposed_times(of_facet.template head<wrench>());
    x.segment<modes>(wrench + modes * i) = of_facet.template tail<modes>();
  }
  return x;
}

template <int d>
FacetVector<d> at_place(const FacetTopology<d>& topology, int ridge, int place,
                        const VectorXd& x) {
  constexpr int wrench = CompositeElement<d>::wrench,
                modes = CompositeElement<d>::modes;
  FacetVector<d> of_facet;
  of_facet << shift_at<d>(topology, ridge, place).times(x.head<wrench>()),
      x.segment<modes>(wrench + modes * place);
  return of_facet;
}

namespace {

/// H x of the cell of a wedge.
template <int d>
CellVector<d> image_of(const FacetForms<d>& forms, const Wedge& wedge,
                       const FacetVector<d>& on_a, const FacetVector<d>& on_b) {
  constexpr int size = CompositeElement<d>::moments;
  CellVector<d> x = CellVector<d>::Zero();
  x.template segment<size>(size * wedge.local[0]) = on_a;
  x.template segment<size>(size * wedge.local[1]) = on_b;
  return forms.times(wedge.cell, x);
}

}  // namespace

template <int d>
void add_around(const FacetTopology<d>& topology, const FacetForms<d>& forms,
                int ridge, const VectorXd& x, FacetColumns<d>& corrections,
                FacetColumns<d>& residual) {
  constexpr int size = CompositeElement<d>::moments;
  const auto around = topology.ridges.facets_of(ridge);
  const auto of_facet = [&](int place) {
    return at_place<d>(topology, ridge, place, x);
  };
  for (int i = 0; i < around.size(); ++i)
    corrections.col(around[i]) += of_facet(i);
  for (const Wedge& wedge : wedges_of<d>(topology, ridge)) {
    const CellVector<d> image = image_of<d>(
        forms, wedge, of_facet(wedge.place[0]), of_facet(wedge.place[1]));
    for (int k = 0; k <= d; ++k)
      residual.col(topology.facets.of_cell(k, wedge.cell)) -=
          image.template segment<size>(size * k);
  }
}

template std::vector<Wedge> wedges_of(const FacetTopology<FFCONTACT_DIMENSION>&,
                                      int);
template WrenchShifts<FFCONTACT_DIMENSION> shifts_around(
    const FacetTopology<FFCONTACT_DIMENSION>&, int);
template MatrixXd ridge_form(const FacetTopology<FFCONTACT_DIMENSION>&, int,
                             const WrenchShift<FFCONTACT_DIMENSION>*,
                             const FacetForms<FFCONTACT_DIMENSION>&);
template MatrixXd coupling_form(const FacetTopology<FFCONTACT_DIMENSION>&, int,
                                const WrenchShift<FFCONTACT_DIMENSION>*, int,
                                const WrenchShift<FFCONTACT_DIMENSION>*,
                                const FacetForms<FFCONTACT_DIMENSION>&);
template MatrixXd ridge_conditions(const FacetTopology<FFCONTACT_DIMENSION>&,
                                   int, const WrenchShift<FFCONTACT_DIMENSION>*,
                                   const KnownTractions<FFCONTACT_DIMENSION>&,
                                   const KnownDirections<FFCONTACT_DIMENSION>&);
template VectorXd restricted<FFCONTACT_DIMENSION>(
    const FacetTopology<FFCONTACT_DIMENSION>&, int,
    const FacetColumns<FFCONTACT_DIMENSION>&);
template FacetVector<FFCONTACT_DIMENSION> at_place(
    const FacetTopology<FFCONTACT_DIMENSION>&, int, int, const VectorXd&);
template void add_around(const FacetTopology<FFCONTACT_DIMENSION>&,
                         const FacetForms<FFCONTACT_DIMENSION>&, int,
                         const VectorXd&, FacetColumns<FFCONTACT_DIMENSION>&,
                         FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
