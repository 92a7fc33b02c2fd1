// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/line_ends.hpp"

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Does its contact edge end with a piece, at a node of its own?
bool ends_with(const ContactLine& line, int end, const FacingPiece& piece) {
  const int e = piece.contact_edge;
  const double place = end == 0 ? piece.begin : piece.end;
  return place == line.place(end, e) && ends_at_its_node(line, end, e);
}

}  // namespace

bool is_constant_on(const ContactLine& line, int e) {
  return line.edge_node(0, e) == line.edge_node(1, e);
}

bool ends_at_its_node(const ContactLine& line, int end, int e) {
  if (!is_constant_on(line, e)) return true;
  const int node = line.edge_node(0, e);
  const bool goes_on = e > 0 && line.edge_node(1, e - 1) == node;
  return end == (goes_on ? 0 : 1);
}

VectorXd facing_gap(const ContactLine& line) {
  constexpr double none = infinity;
  VectorXd gap = VectorXd::Constant(line.node_count(), none);
  for (const FacingPiece& piece : line.pieces)
    for (int end = 0; end < 2; ++end) {
      if (!ends_with(line, end, piece)) continue;
      double& least = gap[line.edge_node(end, piece.contact_edge)];
      least = std::min(least, end == 0 ? piece.gap_begin : piece.gap_end);
    }
  return gap;
}

double abscissa_at(const ContactLine& line, int e, double place) {
  const double first = line.abscissa[line.edge_node(0, e)],
               second = line.abscissa[line.edge_node(1, e)];
  const bool closes = second < first;  // a closed line ends where it begins
  return place == 1 && !closes ? second : first + place * line.length[e];
}

}  // namespace ffcontact
