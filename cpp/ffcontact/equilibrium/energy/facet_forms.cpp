// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/facet_forms.hpp"

#include <Eigen/LU>
#include <array>
#include <map>

namespace ffcontact {

namespace {

/// How T' H T is stored: in space in tiles, unknowns beside them 0; in the plane, where
/// the tiles would be half empty, the lower triangle column by column and a 0.
template <int d>
struct Layout;

template <>
struct Layout<3> {
  static constexpr int n = FacetForms<3>::free_unknowns, size = tiled(n),
                       tiles = size / tile_size;
  static_assert(n < size);
  using Form = Matrix<float, n, n>;
  using Free = Matrix<double, n, 1>;

  /// Where an entry of the lower triangle is.
  static constexpr int place(int row, int column) {
    const int I = row / tile_size, J = column / tile_size;
    return numbers_in_tile * (tiles * J - J * (J - 1) / 2 + I - J) +
           tile_size * (column % tile_size) + row % tile_size;
  }
  static constexpr int zero() { return place(size - 1, 0); }

  static void put(const Form& H, float* next) {
    Matrix<float, size, size> form = Matrix<float, size, size>::Zero();
    form.topLeftCorner<n, n>() = H;
    form.triangularView<Eigen::StrictlyUpper>() = form.transpose();
    for (int J = 0; J < tiles; ++J)
      for (int I = J; I < tiles; ++I, next += numbers_in_tile)
        Map<Matrix<float, 4, 4>>{next} = form.block<4, 4>(4 * I, 4 * J);
  }

  static Free times(const float* next, const Free& x) {
    Matrix<double, size, 1> z = Matrix<double, size, 1>::Zero(), y = z;
    z.head<n>() = x;
    for (int J = 0; J < tiles; ++J) {
      const Vector4d z_J = z.segment<4>(4 * J);
      // of the transposed form, column by column; the tile on the diagonal counts once
      Matrix4d below = Matrix4d::Zero();
      y.segment<4>(4 * J) += tile_at(next) * z_J;
      next += numbers_in_tile;
      for (int I = J + 1; I < tiles; ++I, next += numbers_in_tile) {
        const Matrix4d tile = tile_at(next);
        const Vector4d z_I = z.segment<4>(4 * I);
        y.segment<4>(4 * I) += tile * z_J;
        below.array() += tile.array().colwise() * z_I.array();
      }
      y.segment<4>(4 * J) += below.colwise().sum().transpose();
    }
    return y.head<n>();
  }
};

template <>
struct Layout<2> {
  static constexpr int n = FacetForms<2>::free_unknowns;
  using Form = Matrix<double, n, n>;
  using Free = Matrix<double, n, 1>;

  static constexpr int place(int row, int column) {
    return n * column - column * (column - 1) / 2 + row - column;
  }
  static constexpr int zero() { return n * (n + 1) / 2; }

  static void put(const Form& H, double* next) {
    for (int c = 0; c < n; ++c)
      for (int r = c; r < n; ++r) *next++ = H(r, c);
    *next = 0;
  }

  static Free times(const double* next, const Free& z) {
    Free y = Free::Zero();
    for (int c = 0; c < n; ++c) {
      y[c] += *next++ * z[c];
      for (int r = c + 1; r < n; ++r, ++next) {
        y[r] += *next * z[c];
        y[c] += *next * z[r];
      }
    }
    return y;
  }
};

constexpr int not_free = -1;

/// Where the unknowns of a cell and the entries of its form are.
template <int d>
struct Places {
  static constexpr int size = CompositeElement<d>::moments,
                       wrench = CompositeElement<d>::wrench,
                       loads = CompositeElement<d>::loads,
                       free_unknowns = FacetForms<d>::free_unknowns;

  /// Of z in x and of x in z, for each dependent facet.
  std::array<std::array<int, free_unknowns>, d + 1> in_x{};
  std::array<std::array<int, loads>, d + 1> in_z{};
  /// Of the form's entries, of x with x, for each dependent facet, those of its wrench
  /// where the layout has a 0.
  std::array<std::array<std::array<short, loads>, loads>, d + 1> in_form{};

  constexpr Places() {
    for (int f = 0; f <= d; ++f) {
      put_unknowns(f);
      put_entries(f);
    }
  }

 private:
  constexpr void put_unknowns(int f) {
    for (int i = 0; i < loads; ++i) {
      in_z[f][i] = place_in_z(i / size, i % size, f);
      if (in_z[f][i] != not_free) in_x[f][in_z[f][i]] = i;
    }
  }
  constexpr void put_entries(int f) {
    for (int i = 0; i < loads; ++i)
      for (int j = 0; j < loads; ++j)
        in_form[f][i][j] = place_of_entry(in_z[f][i], in_z[f][j]);
  }

  /// Where an unknown of a facet is in z.
  static constexpr int place_in_z(int facet, int unknown, int dependent) {
    const int after = (facet - dependent + d) % (d + 1);
    if (facet != dependent) return size * after + unknown;
    return unknown < wrench ? not_free : size * d + unknown - wrench;
  }
  static constexpr short place_of_entry(int row, int column) {
    if (row == not_free || column == not_free) return Layout<d>::zero();
    return static_cast<short>(row >= column ? Layout<d>::place(row, column)
                                            : Layout<d>::place(column, row));
  }
};

template <int d>
constexpr Places<d> places;

template <int d>
int largest_facet(const CellCorners<d>& corners) {
  int largest = 0;
  facet_vectors(corners).colwise().squaredNorm().maxCoeff(&largest);
  return largest;
}

/// The forms of terms in the unknowns of their facets.
template <int d>
class TermsOfFacets {
 public:
  TermsOfFacets(const FacetTopology<d>& topology,
                const std::vector<FacetTerm<d>>& terms)
      : facets_(topology.facets) {
    for (const FacetTerm<d>& term : terms)
      of_facet_[term.facet] = form_of<d>(topology, term);
  }

  template <class Scalar>
  void add_to(CellForm<d, Scalar>& H, int cell) const {
    constexpr int size = CompositeElement<d>::moments;
    if (of_facet_.empty()) return;
    for (int k = 0; k <= d; ++k) {
      const auto found = of_facet_.find(facets_.of_cell(k, cell));
      if (found != of_facet_.end())
        H.template block<size, size>(size * k, size * k) +=
            found->second.template cast<Scalar>();
    }
  }

 private:
  const Facets<d>& facets_;
  std::map<int, FacetMatrix<d>> of_facet_;
};

/// T' H T in place of H; what is left for the dependent wrench means nothing.
template <int d, class Scalar>
void balance(const FacetTopology<d>& topology, int cell, int dependent,
             CellForm<d, Scalar>& H) {
  constexpr int size = CompositeElement<d>::moments,
                wrench = CompositeElement<d>::wrench;
  for (int k = 0; k <= d; ++k) {
    if (k == dependent) continue;
    const Matrix<Scalar, wrench, wrench> shift =
        balancing_shift<d>(topology, cell, k, dependent)
            .matrix()
            .template cast<Scalar>();
    H.template middleCols<wrench>(size * k) +=
        H.template middleCols<wrench>(size * dependent).lazyProduct(shift);
    H.template middleRows<wrench>(size * k) += shift.transpose().lazyProduct(
        H.template middleRows<wrench>(size * dependent));
  }
}

}  // namespace

template <int d>
FacetForms<d>::FacetForms(const FacetTopology<d>& topology,
                          const HookeTensors<d>& hooke,
                          const std::vector<FacetTerm<d>>& terms)
    : dependent_(topology.mesh.cell_count()) {
  const TermsOfFacets<d> added(topology, terms);
  forms_.reset(new Stored[stored * topology.mesh.cell_count()]);
#pragma omp parallel for
  for (int t = 0; t < topology.mesh.cell_count(); ++t) {
    const CellCorners<d> corners = topology.corners(t);
    const int dependent = largest_facet<d>(corners);
    dependent_[t] = static_cast<char>(dependent);
    CellForm<d, Stored> H = facet_energy<d, Stored>(
        corners, hooke[t].inverse(), wrench_bases<d>(topology, t));
    added.add_to(H, t);
    balance<d, Stored>(topology, t, dependent, H);
    put_form(H, t);
  }
}

template <int d>
void FacetForms<d>::put_form(const CellForm<d, Stored>& H, int cell) {
  const auto& in_x = places<d>.in_x[dependent_[cell]];
  Layout<d>::put(H(in_x, in_x), forms_.get() + stored * cell);
}

template <int d>
CellVector<d> FacetForms<d>::times(int cell, const CellVector<d>& x) const {
  const auto& in_x = places<d>.in_x[dependent_[cell]];
  CellVector<d> y = CellVector<d>::Zero();
  y(in_x) = Layout<d>::times(form(cell), x(in_x));
  return y;
}

template <int d>
typename FacetForms<d>::Block FacetForms<d>::block(int cell, int k,
                                                   int l) const {
  constexpr int size = Element::moments;
  const Stored* H = form(cell);
  const auto& in_form = places<d>.in_form[dependent_[cell]];
  Block block;
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i)
      block(i, j) = H[in_form[size * k + i][size * l + j]];
  return block;
}

template class FacetForms<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
