// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/curve_report.hpp"

#include <cmath>
#include <string>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/interface/boundary_chains.hpp"
#include "ffcontact/interface/curve_directions.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

namespace {

constexpr double degrees = 180 / M_PI;

/// What a line takes from its curves, behind "a smooth curve".
std::string taken_from(const ContactLine& own, bool has_facing,
                       const SaidOfCurves& said) {
  const bool gap = has_facing && !said.gap;
  if (said.normal) return gap ? ", with its gap" : "";
  const std::string normals =
      turns(own) ? "its normals" : "one contact direction";
  return ", with " + normals + (gap ? " and its gap" : "");
}

void report_label(const JoinedMesh& joined, int body, int label,
                  const std::string& sentence) {
  cout << "contact: label " << label - joined.label(body, 0);
  if (joined.body_count() > 1) cout << " of mesh " << body + 1;
  cout << ": " << sentence << endl;
}

/// Of one label that belongs to a body.
class LabelReport {
 public:
  LabelReport(const JoinedMesh& joined, const Edges& edges, int body, int label)
      : joined_(joined),
        edges_(edges),
        body_(body),
        label_(label),
        boundary_(labelled_boundary(joined.mesh, edges, {label})) {}

  void say_curve(const BoundaryCurves& curves, const std::string& taken) const {
    const CurvedEdges found = curved_edges(curves, packed(boundary_));
    if (found.count == 0) return;
    report_label(joined_, body_, label_,
                 std::to_string(found.count) + " edges that turn by at most " +
                     in_digits(found.largest_turn * degrees) +
                     " degrees are a smooth curve, up to " +
                     in_digits(found.sagitta) + " mm beside them" + taken +
                     "; corner=0 keeps the polygon");
  }

  /// A regular polygon of six sides or more may be a circle of few edges.
  void say_polygon(double corner) const {
    const CorneredEdges found =
        cornered_edges(joined_.mesh, edges_, boundary_, corner / degrees);
    if (found.count < 6) return;
    const double turn = found.largest_turn * degrees;
    report_label(joined_, body_, label_,
                 std::to_string(found.count) + " edges with corners of " +
                     in_digits(turn) + " degrees are a polygon; corner=" +
                     std::to_string(5 * static_cast<int>(turn / 5 + 1)) +
                     " takes them for a curve");
  }

 private:
  const JoinedMesh& joined_;
  const Edges& edges_;
  int body_, label_;
  std::vector<int> boundary_;
};

}  // namespace

void report_curves(const JoinedMesh& joined, const Edges& edges,
                   const BoundaryCurves& curves, double corner,
                   const StatedPair& pair, const ContactLine& own,
                   const SaidOfCurves& said) {
  if (verbosity < 1 || mpirank != 0) return;
  const auto report = [&](int body, int label, const std::string& taken) {
    const LabelReport of_label(joined, edges, body, label);
    of_label.say_curve(curves, taken);
    if (corner > 0 && !said.normal) of_label.say_polygon(corner);
  };
  for (int label : pair.labels)
    report(pair.body, label, taken_from(own, !pair.rigid(), said));
  if (said.gap) return;
  for (int label : pair.opposite)
    report(body_of_label(joined, label), label, ", with its gap");
}

}  // namespace ffcontact::plugin
