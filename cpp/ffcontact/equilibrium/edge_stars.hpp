// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/equilibrium/face_forms.hpp"
#include "ffcontact/equilibrium/face_share.hpp"
#include "ffcontact/equilibrium/face_tractions.hpp"

namespace ffcontact {

/// The additive solves of all edge stars, z = sum over the edges of Z A^-1 Z' g.
///
/// The self-equilibrated corrections of the faces around an edge are one wrench w that
/// all of them carry and three bars on each: x = (w, y_1, .., y_m), A = Z' H Z [(6 + 3 m)^2]
/// with Z of wrench_shift. At a boundary edge only those x count that leave known
/// tractions of its two boundary faces alone; where nothing is left the edge has no part.
///
/// Factors (tiled_factor) are kept in single precision: they only steer. x is not, so that
/// last digits of g, as several processes leave them, turn last digits of z alone. Each
/// loop writes what is its own: the result does not depend on the number of threads.
class EdgeStars {
 public:
  /// @param share  whose edges the stars are; stays where it is
  EdgeStars(const SolidTopology& topology, const FaceShare& share,
            const FaceTractions& boundary, const FaceForms& forms);

  /// @param g  on the unknowns (w, y) of all faces [9 x faces]
  /// @param z  likewise, 0 on faces that are not of the share
  void operator()(const Matrix9Xd& g, Matrix9Xd& z);

 private:
  /// What an edge adds: basis x with x = A^-1 basis' (Z' g), basis the identity if empty.
  struct Star {
    MatrixXd basis;
    int size;  ///< of A; 0: nothing is free
  };

  Star star(int edge, const FaceTractions& boundary, const FaceForms& forms,
            float* factor) const;
  void place_faces();
  void restrict_to(int edge, const Matrix9Xd& g, double* x) const;
  void solve(int edge, double* x) const;
  Vector9d of_face(int edge, int face, const double* x) const;

  const SolidTopology& topology_;
  const FaceShare& share_;
  // The faces around an edge, all edges in a row: Hinges::facet.
  Matrix3Xi place_;  ///< of a face around each of its edges [3 x faces]
  std::vector<WrenchShift> shifts_;
  Matrix9Xd parts_;  ///< what the edge has for the face
  std::vector<Star> stars_;
  int largest_ = 0;                     ///< unknowns of a star, in whole tiles
  std::vector<Index> first_of_factor_;  ///< all edges in a row
  std::unique_ptr<float[]> factors_;
};

}  // namespace ffcontact
