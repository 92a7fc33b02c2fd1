// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dice.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact::fuzz {

/// Labels of a grid's sides; a side may be split in two, bites leave edges of their own
/// label.
enum Side : int {
  bottom = 1,
  right = 2,
  top = 3,
  left = 4,
  bottom_rest = 5,
  top_rest = 6,
  below_crack = 7,
  above_crack = 8,
  bitten = 9
};

/// Grid of cells between given columns and rows, each cut by a random diagonal.
Mesh grid(const std::vector<double>& columns, const std::vector<double>& rows,
          Dice& dice);

/// Places from 0 to `length` with random distances; the largest is at most about
/// `grading` times the smallest.
std::vector<double> places(int cells, double length, double grading,
                           Dice& dice);

/// Moves inner vertices by up to `fraction` of the shortest edge beside them.
void move_inner_vertices(Mesh& mesh, double fraction, Dice& dice);

/// Flips inner edges whose two triangles make a convex quadrilateral.
void flip_edges(Mesh& mesh, int tries, Dice& dice);

/// Cuts a grid of so many columns of cells along a row, from vertex `first` to `last` of it.
/// The faces of the crack share the ends that are inside.
void crack(Mesh& mesh, int columns, int row, int first, int last);

/// Takes triangles out, one by one, as long as the rest hangs together by edges, no
/// vertex is left between two fans, and every label in `kept` keeps an edge and every one
/// in `whole` all of them. Sides that come free are labelled `bitten`.
void bite(Mesh& mesh, int tries, const std::vector<int>& kept,
          const std::vector<int>& whole, Dice& dice);

/// Puts a vertex into random triangles.
void split_triangles(Mesh& mesh, int tries, Dice& dice);

/// Vertices and triangles in another order.
void renumber(Mesh& mesh, Dice& dice);

/// Longest side squared over twice the area, of the worst triangle; infinite where one is
/// not positive.
double worst_aspect(const Mesh& mesh);

/// Without triangles marked for removal and the vertices that are then used no more.
/// @return false, and the mesh as it was, if the rest does not hang together
bool remove_triangles(Mesh& mesh, const std::vector<char>& removed,
                      std::vector<int>* kept_triangles = nullptr);

}  // namespace ffcontact::fuzz
