// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/equilibrium/energy/ridge_form.hpp"
#include "ffcontact/equilibrium/energy/ridge_lines.hpp"

namespace ffcontact {

/// The additive solves of all lines of ridge stars, z = sum over the lines of Z A^-1 Z' g.
///
/// The self-equilibrated corrections of the facets around a ridge are one wrench w that
/// all of them carry and the modes of each: x = (w, y_1, .., y_m), A = Z' H Z
/// [(r + (d^2 - r) m)^2] with Z of wrench_shift. At a boundary ridge only those x count
/// that leave known tractions of its two boundary facets alone; where nothing is left the
/// ridge has no part.
///
/// Most ridges are a line by themselves (short_edge_lines); where their Cholesky factor
/// fails they have no part. In a line of several each star has cells in common with the
/// one before and the next one alone: A is block tridiagonal, and so is its factor. The
/// modes of the facet between two stars are of both, so that A is singular; unknowns whose
/// pivot vanishes stay 0 (BlockElimination).
///
/// Factors (tiled_factor) are kept in single precision: they only steer. x is not, so that
/// last digits of g, as several processes leave them, turn last digits of z alone. Each
/// loop writes what is its own: the result does not depend on the number of threads.
template <int d>
class RidgeStars {
 public:
  /// @param topology  what it refers to stays where it is
  /// @param share     whose ridges the stars are; stays where it is
  RidgeStars(const FacetTopology<d>& topology, const FacetShare& share,
             const FacetTractions<d>& boundary, const FacetForms<d>& forms);

  /// What those of a whole body take, nearly [bytes].
  static double bytes(const FacetTopology<d>& topology);

  /// @param g  on the unknowns (w, y) of all facets [d^2 x facets]
  /// @param z  likewise, 0 on facets that are not of the share
  void operator()(const FacetColumns<d>& g, FacetColumns<d>& z);

 private:
  using Element = CompositeElement<d>;
  static constexpr int wrench = Element::wrench, modes = Element::modes;

  /// The corrections Z basis x of a ridge, basis the identity where it is empty and
  /// something is free.
  struct Star {
    MatrixXd basis;
    int size = 0;  ///< of A; 0: nothing is free
  };

  void place_facets();
  void place_factors();
  // of the star at a place in lines_
  int size_at(int place) const { return stars_[lines_.ridge[place]].size; }
  float* factor_at(int place) const {
    return factors_.get() + first_of_factor_[place];
  }
  int below(int line, int place) const;
  MatrixXd form_of(int ridge, const FacetTractions<d>& boundary,
                   const FacetForms<d>& forms);
  MatrixXd coupling_of(int a, int b, const FacetForms<d>& forms) const;
  void factor_alone(int place, const FacetTractions<d>& boundary,
                    const FacetForms<d>& forms);
  void factor_line(int line, const FacetTractions<d>& boundary,
                   const FacetForms<d>& forms);
  void restrict_to(int ridge, const FacetColumns<d>& g, double* x) const;
  void restrict_to_free(int ridge, const FacetColumns<d>& g, double* x) const;
  void put_parts(int ridge, const double* x);
  FacetVector<d> of_facet(int ridge, int facet, const double* x) const;
  void solve_line(int line, const FacetColumns<d>& g, double* x);

  const FacetTopology<d> topology_;
  const FacetShare& share_;
  // The facets around a ridge, all ridges in a row: Ridges::facet.
  Matrix<int, d, Dynamic>
      place_;  ///< of a facet around each of its ridges [d x facets]
  WrenchShifts<d> shifts_;
  FacetColumns<d> parts_;  ///< what the ridge has for the facet
  RidgeLines lines_;
  std::vector<Star> stars_;             ///< of each ridge
  int largest_ = 0;                     ///< unknowns of a line, in whole tiles
  std::vector<Index> first_of_factor_;  ///< line by line, star by star
  std::unique_ptr<float[]> factors_;
};

}  // namespace ffcontact
