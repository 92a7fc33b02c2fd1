// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/contact/checks/compliance_ratio.hpp"
#include "ffcontact/interface/bonded_line.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/interface/pairing/constant_ends.hpp"
#include "ffcontact/interface/pairing/facing_line.hpp"
#include "problem/glued_vertices.hpp"
#include "problem/pair_sides.hpp"
//
#include "freefem/plane_values.hpp"
#include "problem/contact_statement.hpp"
#include "problem/curve_report.hpp"

namespace ffcontact::plugin {

namespace {

/// Says at any verbosity where a line that faces bodies has a vertex in which more than two
/// boundary edges meet, as where FreeFEM's + took two vertices for one: nothing opens there.
void warn_of_touching(const Mesh& mesh, const ContactLine& own) {
  if (mpirank != 0) return;
  VectorXi edges_at = VectorXi::Zero(mesh.vertex_count());
  for (int v : mesh.boundary.reshaped()) ++edges_at[v];
  for (int v : own.vertex)
    if (edges_at[v] > 2) {
      cout
          << "contact: at vertex " << v << " " << in_words(mesh.place(v))
          << " the body touches itself in a single vertex of the contact "
             "line, which neither opens nor slides: where bodies are joined by "
             "FreeFEM's T1 + T2, state contact(T1, T2, ...)"
          << endl;
      return;
    }
}

/// What is stated of lines, the curves of their bodies, those of bonded ones do not count, and
/// what is glued.
struct LineStatement : Statement<2> {
  BoundaryCurves curves;
  GluedVertices<2> glued;
  BoundaryCurves none{};

  const BoundaryCurves& curves_of(const StatedPair& pair) const {
    return pair.bonded ? none : curves;
  }

  /// The line without multipliers that have nothing to do.
  ContactLine steered(const StatedPair& pair, const ContactLine& line) const {
    if (pair.bonded) return with_constant_ends(mesh, facets, line);
    Flags held(mesh.vertex_count(), 0);
    return glued.hold(pair, line, held) ? without_ends(mesh, facets, line, held)
                                        : line;
  }
};

LineStatement line_statement(const Statement<2>& said,
                             const std::vector<StatedPair>& pairs) {
  const GluedVertices<2> glued(said.bodies.joined);
  if (std::all_of(pairs.begin(), pairs.end(),
                  [](const StatedPair& pair) { return pair.bonded; }))
    return {said, {}, glued};
  return {said, BoundaryCurves(said.mesh, said.facets, said.corner), glued};
}

/// A curve has one contact direction where it touches what is flatter.
ContactLine own_line(const LineStatement& said, const StatedPair& pair) {
  const BodyPart<2> body = said.part(pair.body);
  if (pair.bonded) return bonded_line(body.mesh, body.facets, pair.labels);
  ContactLine line =
      stated_line(said.stack, said.named, body, pair.labels, said.curves);
  if (said.named.given("normal") || !turns(line)) return line;
  const Expression gap = said.named.expression("gap");
  const VectorXd distance =
      gap || pair.rigid()
          ? at_nodes(said.stack, gap, body, line, stated_places(line, false), 0)
          : facing_traces(said.mesh, said.facets, line, pair.opposite,
                          said.curves)
                .gap;
  return with_one_direction_a_curve(said.mesh, std::move(line), distance);
}

void require_one_side(const LineStatement& said, const StatedPair& pair,
                      const ContactLine& own) {
  if (!must_not_face_itself(pair)) return;
  const std::optional<TouchingPlace> touching =
      touching_place(said.mesh, said.facets, own, pair.labels);
  if (touching)
    refuse_both_sides(
        said.mesh.boundary_label[said.facets.boundary_index[touching->edge]],
        in_words(Vector2d(said.mesh.origin + touching->place)));
}

/// @param stated  the line of the body that comes first
Carrier<2> carrier(const LineStatement& said, const StatedPair& pair,
                   const ContactLine& stated, ContactLine line,
                   bool on_opposite) {
  const StatedPlaces places = stated_places(line, on_opposite);
  StatedAbscissae at = stated_abscissae(said.facets, stated, line, places);
  Carrier<2> result;
  for (int vertex : at.vertex)
    result.own_vertex.push_back(vertex -
                                said.bodies.joined.first_vertex[pair.body]);
  result.abscissa = std::move(at.node);
  result.edge_abscissa = std::move(at.edge_end);
  if (pair.bonded)
    result.law = bonded_law<2>(line.node_count());
  else
    put_law(said.stack, said.named, said.part(pair.body), line, places, result);
  result.contact = std::move(line);
  return result;
}

PairSides<2> facing_sides(const LineStatement& said, const StatedPair& pair,
                          const ContactLine& own, int wanted) {
  const FacingTraces traces = facing_traces(
      said.mesh, said.facets, own, pair.opposite, said.curves_of(pair));
  ContactLine facing = facing_line(said.mesh, said.facets, own, traces);
  std::optional<ContactLine> exchanged;
  if (wanted != 1)
    exchanged = exchanged_line(said.mesh, said.facets, facing, pair.opposite);
  if (!exchanged && wanted == 2)
    refuse(
        "side=2: the other body cannot carry the multipliers, as two parts of "
        "the first one's line face the same part of it; give one contact "
        "direction with normal=[nx, ny], or side=1");
  facing = said.steered(pair, facing);
  if (exchanged) exchanged = said.steered(pair, *exchanged);
  PairSides<2> sides{false, wanted, carrier(said, pair, own, facing, false)};
  if (!exchanged) return sides;
  sides.other = carrier(said, pair, own, *exchanged, true);
  sides.compliance_ratio = [&bodies = said.bodies,
                            facing](const ElasticSystem& system) {
    return compliance_ratio(bodies.joined.mesh, bodies.facets, facing, system);
  };
  return sides;
}

PairSides<2> sides_of(const LineStatement& said,
                      const std::vector<StatedPair>& pairs, int k) {
  const StatedPair& pair = pairs[k];
  const ContactLine own = own_line(said, pair);
  require_one_side(said, pair, own);
  if (!pair.bonded)
    report_curves(said.bodies.joined, said.facets, said.curves, said.corner,
                  pair, own,
                  {said.named.given("normal"), said.named.given("gap")});
  if (pair.rigid()) return {true, 1, carrier(said, pair, own, own, false)};
  if (said.bodies.body_count() == 1) warn_of_touching(said.mesh, own);
  return facing_sides(said, pair, own,
                      wanted_side(said.stack, said.named, k, count_of(pairs)));
}

}  // namespace

std::vector<PairSides<2>> read_sides(const Statement<2>& said,
                                     const std::vector<StatedPair>& pairs) {
  LineStatement of_lines = line_statement(said, pairs);
  return bonded_first<2>(pairs, of_lines.glued,
                         [&](int k) { return sides_of(of_lines, pairs, k); });
}

}  // namespace ffcontact::plugin
