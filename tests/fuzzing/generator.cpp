// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ffcontact/base/eigen.hpp"
#include "random_mesh.hpp"

namespace ffcontact::fuzz {

namespace {

constexpr int most_triangles = 120;
constexpr double thinnest = 60;  ///< aspect of the worst triangle

/// Where supports and loads may hold or push: what the shape of the problem leaves
/// possible.
enum class Holding { held, pressed, loose };

/// What is drawn first and everything else follows.
struct Plan {
  Holding support = Holding::held;
  double strain = 1e-3;  ///< typical size of all loads
  double softest = 1;    ///< [MPa]
  bool flat = true;      ///< no kinks in the contact line
  bool loaded = true, moved = true;
};

Field random_field(double size, Dice& dice) {
  Field f;
  f.mean = size * dice.real(-1, 1);
  if (dice.chance(0.4))
    f.slope = size * Vector2d(dice.real(-1, 1), dice.real(-1, 1));
  if (dice.chance(0.2)) {
    f.wave = size * dice.real(-1, 1);
    f.number = {dice.real(-9, 9), dice.real(-9, 9)};
  }
  return f;
}

Field positive_field(double size, Dice& dice) {
  Field f = random_field(size, dice);
  f.mean = std::abs(f.mean);
  return f;
}

Vector2d random_vector(double size, Dice& dice) {
  if (dice.chance(0.3))
    return dice.chance(0.5) ? Vector2d(size * dice.real(-1, 1), 0)
                            : Vector2d(0, size * dice.real(-1, 1));
  return size * Vector2d(dice.real(-1, 1), dice.real(-1, 1));
}

/// Part of a side's edges gets another label.
void split_side(Mesh& mesh, Side side, Side rest, double from) {
  for (int e = 0; e < mesh.boundary.cols(); ++e)
    if (mesh.boundary_label[e] == side &&
        mesh.vertices(0, mesh.boundary(0, e)) >= from &&
        mesh.vertices(0, mesh.boundary(1, e)) >= from)
      mesh.boundary_label[e] = rest;
}

/// y += (height of the kinks at x) (1 - y / height): the bottom becomes a polygon, the
/// top stays.
void kink_bottom(Mesh& mesh, const std::vector<double>& columns,
                 const std::vector<double>& kinks, double height) {
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double x = mesh.vertices(0, v);
    const auto next = std::clamp<std::ptrdiff_t>(
        std::upper_bound(columns.begin(), columns.end(), x) - columns.begin(),
        1, static_cast<std::ptrdiff_t>(columns.size()) - 1);
    const double s =
        (x - columns[next - 1]) / (columns[next] - columns[next - 1]);
    const double shift = (1 - s) * kinks[next - 1] + s * kinks[next];
    mesh.vertices(1, v) += shift * (1 - mesh.vertices(1, v) / height);
  }
}

/// A line through a few of the columns, so that straight parts of several edges remain.
std::vector<double> random_kinks(const std::vector<double>& columns,
                                 double height, Dice& dice) {
  std::vector<std::size_t> corners{0, columns.size() - 1};
  for (int k = dice.integer(1, 3); k > 0; --k)
    corners.push_back(dice.integer(0, static_cast<int>(columns.size()) - 1));
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<double> at_corner, kinks(columns.size());
  for (std::size_t k = 0; k < corners.size(); ++k)
    at_corner.push_back(height * dice.real(-0.5, 0.5));
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    for (std::size_t i = corners[k]; i <= corners[k + 1]; ++i) {
      const double s = (columns[i] - columns[corners[k]]) /
                       (columns[corners[k + 1]] - columns[corners[k]]);
      kinks[i] = (1 - s) * at_corner[k] + s * at_corner[k + 1];
    }
  return kinks;
}

struct Shape {
  int nx, ny;
  double width, height;
};

Shape random_shape(int most, Dice& dice) {
  Shape shape;
  shape.nx = dice.integer(1, dice.chance(0.3) ? 2 : 8);
  shape.ny = dice.integer(
      1, std::clamp(most / (2 * shape.nx), 1, dice.chance(0.3) ? 2 : 8));
  shape.width = dice.chance(0.5) ? shape.nx : dice.decades(0.1, 10) * shape.nx;
  shape.height = shape.ny;
  if (dice.chance(0.08)) {  // a strip
    shape.ny = dice.integer(1, 2);
    shape.height = dice.decades(0.02, 1) * shape.ny;
  }
  return shape;
}

void give_materials(Body& body, const Plan& plan, Dice& dice) {
  const double nu = dice.chance(0.2) ? dice.pick<double>({0, -0.9, 0.49, 0.499})
                                     : dice.real(-0.9, 0.49);
  const bool stiffer = dice.chance(0.3);
  body.materials = {{plan.softest * (stiffer ? dice.decades(1, 1e3) : 1), nu}};
  body.region.assign(body.mesh.cells.cols(), 0);
  if (!dice.chance(0.3)) return;
  const double jump = dice.decades(1, dice.chance(0.5) ? 10
                                      : stiffer        ? 1e3
                                                       : 1e6);
  body.materials.push_back({body.materials[0].E * jump, dice.real(-0.5, 0.49)});
  if (dice.chance(0.5)) std::swap(body.materials[0], body.materials[1]);
  const bool layers = dice.chance(0.5);
  const double middle = body.mesh.vertices.row(1).mean();
  for (int t = 0; t < body.mesh.cell_count(); ++t)
    body.region[t] = layers ? (body.mesh.corner(t, 0) + body.mesh.corner(t, 1) +
                               body.mesh.corner(t, 2))
                                      .y() > 3 * middle
                            : dice.integer(0, 1);
}

bool has_label(const Mesh& mesh, int label) {
  return (mesh.boundary_label.array() == label).any();
}

void clamp(Body& body, int label) {
  for (int c = 0; c < 2; ++c) body.supports.push_back({label, c, {}});
}

/// Both components along one label, or one along each of two sides that are at right
/// angles.
void support_held(Body& body, const std::vector<int>& free_labels, Dice& dice) {
  const auto is_free = [&](int label) {
    return std::find(free_labels.begin(), free_labels.end(), label) !=
           free_labels.end();
  };
  if (dice.chance(0.15) && is_free(top) && is_free(left)) {
    body.supports = {{left, 0, {}}, {top, 1, {}}};
    return;
  }
  clamp(body, dice.pick(free_labels));
  if (dice.chance(0.1))
    body.supports.push_back({dice.pick(free_labels), dice.integer(0, 1), {}});
}

/// Moves all that is held along each label by one affine field.
void move_supports(Body& body, double size, Dice& dice) {
  for (Support& support : body.supports)
    if (dice.chance(0.7)) {
      support.value.mean = size * dice.real(-1, 1);
      if (dice.chance(0.3))
        support.value.slope =
            size * Vector2d(dice.real(-1, 1), dice.real(-1, 1));
    }
  // Two supports that share a vertex and a component must agree on it.
  for (Support& a : body.supports)
    for (const Support& b : body.supports)
      if (a.component == b.component) a.value = b.value;
}

bool supported(const Body& body, int label) {
  return std::any_of(body.supports.begin(), body.supports.end(),
                     [&](const Support& s) { return s.label == label; });
}

std::vector<int> free_labels(const Body& body,
                             const std::vector<int>& contact_labels) {
  std::vector<int> labels;
  for (int label : {bottom, right, top, left, bottom_rest, top_rest, bitten})
    if (has_label(body.mesh, label) &&
        std::find(contact_labels.begin(), contact_labels.end(), label) ==
            contact_labels.end())
      labels.push_back(label);
  return labels;
}

void load(Body& body, const std::vector<int>& labels, const Plan& plan,
          Dice& dice) {
  double stiffness = plan.softest;
  if (dice.chance(0.5))
    stiffness = std::max_element(body.materials.begin(), body.materials.end(),
                                 [](auto& a, auto& b) { return a.E < b.E; })
                    ->E;
  const double size = plan.strain * stiffness;
  for (int label : labels)
    if (!supported(body, label) && dice.chance(0.5))
      body.tractions.push_back({label, random_vector(size, dice)});
  if (dice.chance(0.3)) body.force = random_vector(size, dice);
}

/// One body on a rigid foundation.
void one_body(Case& c, Plan& plan, Dice& dice) {
  Body body;
  const Shape shape = random_shape(most_triangles, dice);
  const std::vector<double> columns =
      places(shape.nx, shape.width, dice.chance(0.7) ? 1 : 8, dice);
  body.mesh = grid(
      columns, places(shape.ny, shape.height, dice.chance(0.7) ? 1 : 8, dice),
      dice);
  if (shape.nx > 1 && dice.chance(0.3))
    split_side(body.mesh, bottom, bottom_rest,
               columns[dice.integer(1, shape.nx - 1)]);
  if (shape.nx > 1 && dice.chance(0.3))
    split_side(body.mesh, top, top_rest,
               columns[dice.integer(1, shape.nx - 1)]);
  std::vector<int> contact{bottom};
  if (has_label(body.mesh, bottom_rest) && dice.chance(0.5))
    contact.push_back(bottom_rest);
  if (plan.support != Holding::pressed && dice.chance(0.15))
    contact.push_back(dice.pick<int>({right, left, top}));
  const std::vector<int> others = free_labels(body, contact);
  plan.flat =
      plan.support == Holding::pressed ? !dice.chance(0.2) : !dice.chance(0.25);
  if (plan.support == Holding::pressed)
    body.supports = {{left, 0, {}}};
  else if (plan.support == Holding::held)
    support_held(body, others, dice);
  if (!plan.flat)
    kink_bottom(body.mesh, columns, random_kinks(columns, shape.height, dice),
                shape.height);
  if (dice.chance(0.3)) split_triangles(body.mesh, dice.integer(1, 8), dice);
  if (dice.chance(0.6)) move_inner_vertices(body.mesh, 0.4, dice);
  if (dice.chance(0.5)) flip_edges(body.mesh, dice.integer(1, 10), dice);
  std::vector<int> kept = contact;
  for (const Support& s : body.supports) kept.push_back(s.label);
  if (dice.chance(0.5))
    bite(body.mesh, dice.integer(1, body.mesh.cell_count()), kept, {}, dice);
  if (dice.chance(0.3)) renumber(body.mesh, dice);
  give_materials(body, plan, dice);
  if (plan.support == Holding::held && dice.chance(0.1))
    body.supports.push_back({dice.pick(contact), dice.integer(0, 1), {}});
  if (plan.support == Holding::held) {
    if (plan.moved) move_supports(body, plan.strain * shape.height, dice);
    if (plan.loaded) load(body, free_labels(body, contact), plan, dice);
  } else if (has_label(body.mesh, top)) {
    body.tractions.push_back(
        {top,
         {plan.support == Holding::pressed
              ? 0
              : plan.strain * plan.softest * dice.real(-0.1, 0.1),
          -plan.strain * plan.softest * dice.real(0.1, 1)}});
    if (plan.support == Holding::pressed && has_label(body.mesh, right) &&
        dice.chance(0.5))
      body.tractions.push_back(
          {right, {plan.strain * plan.softest * dice.real(-1, 1), 0}});
  } else {
    body.force = {0, -plan.strain * plan.softest};
  }
  c.contacts = {{0, contact, {}}};
  c.bodies = {body};
}

/// One body with a crack that lies along its columns, its ends inside or at a side.
void cracked_body(Case& c, Plan& plan, Dice& dice) {
  plan.support = Holding::held;
  Body body;
  Shape shape = random_shape(most_triangles, dice);
  shape.nx = std::max(shape.nx, 4);
  shape.ny = std::clamp(shape.ny, 2, 5);
  body.mesh = grid(
      places(shape.nx, shape.width, dice.chance(0.7) ? 1 : 8, dice),
      places(shape.ny, shape.height, dice.chance(0.7) ? 1 : 8, dice), dice);
  // an edge at least between those at the ends, where nothing opens
  const bool from_side = dice.chance(0.4);
  const int first = from_side ? 0 : dice.integer(1, shape.nx - 3);
  const int last =
      dice.integer(first + (from_side ? 2 : 3), shape.nx - (from_side ? 1 : 0));
  crack(body.mesh, shape.nx, dice.integer(1, shape.ny - 1), first, last);
  support_held(body, free_labels(body, {}), dice);
  if (dice.chance(0.3)) split_triangles(body.mesh, dice.integer(1, 8), dice);
  if (dice.chance(0.6)) move_inner_vertices(body.mesh, 0.4, dice);
  if (dice.chance(0.5)) flip_edges(body.mesh, dice.integer(1, 10), dice);
  if (dice.chance(0.3)) renumber(body.mesh, dice);
  give_materials(body, plan, dice);
  if (plan.moved) move_supports(body, plan.strain * shape.height, dice);
  if (plan.loaded) load(body, free_labels(body, {}), plan, dice);
  c.contacts = {dice.chance(0.5)
                    ? Contact{0, {above_crack}, {{0, below_crack}}}
                    : Contact{0, {below_crack}, {{0, above_crack}}}};
  c.bodies = {body};
}

/// A stack while it grows from its uppermost body down.
struct Stack {
  int count;
  bool matching, equal;
  double width, distance;       ///< of the uppermost body; between facing sides
  std::vector<double> columns;  ///< of the last body
  double from = 0, floor = 0;   ///< its left end and its bottom
  /// of the line below the uppermost body; empty where it is straight
  std::vector<double> kinks;
};

Stack random_stack(Plan& plan, Dice& dice) {
  Stack stack;
  stack.count = dice.chance(0.8) ? 2 : 3;
  stack.matching = dice.chance(0.5);
  stack.equal = dice.chance(0.4);
  stack.width = dice.decades(0.5, 4);
  stack.distance = dice.chance(0.3)
                       ? plan.strain * dice.real(dice.chance(0.3) ? -1 : 0, 1)
                       : 0;
  stack.columns =
      places(dice.integer(1, 5), stack.width, dice.chance(0.5) ? 1 : 4, dice);
  plan.flat = !(stack.matching && stack.equal && stack.count == 2 &&
                stack.distance == 0 && dice.chance(0.3));
  if (!plan.flat) stack.kinks = random_kinks(stack.columns, 0.6, dice);
  return stack;
}

/// Places that all but meet the given ones.
std::vector<double> nearly(std::vector<double> columns, Dice& dice) {
  const double shift = 0.1 * columns.back() /
                       static_cast<double>(columns.size()) *
                       dice.decades(1e-12, 1);
  for (std::size_t i = 1; i + 1 < columns.size(); ++i)
    columns[i] += shift * dice.real(-1, 1);
  return columns;
}

/// The columns of the next body below: as wide or wider, with the same places or others.
void widen(Stack& stack, Dice& dice) {
  const double on_left = stack.equal || dice.chance(0.3)
                             ? 0
                             : dice.real(0.05, 1) * stack.width,
               on_right = stack.equal || dice.chance(0.3)
                              ? 0
                              : dice.real(0.05, 1) * stack.width;
  const double span = stack.columns.back() + on_left + on_right;
  stack.from -= on_left;
  if (!stack.matching && dice.chance(0.6)) {
    stack.columns =
        places(dice.integer(1, 6), span, dice.chance(0.5) ? 1 : 4, dice);
    return;
  }
  if (!stack.matching) stack.columns = nearly(stack.columns, dice);
  if (on_left > 0) {
    for (double& x : stack.columns) x += on_left;
    stack.columns.insert(stack.columns.begin(), 0);
  }
  if (on_right > 0) stack.columns.push_back(span);
}

/// y -> height - y; orientation is lost until it is done again.
void upside_down(Mesh& mesh, double height) {
  mesh.vertices.row(1) = height - mesh.vertices.row(1).array();
}

Mesh mesh_in(Stack& stack, bool uppermost, double height, Dice& dice) {
  Mesh mesh = grid(
      stack.columns,
      places(dice.integer(1, 3), height, dice.chance(0.7) ? 1 : 4, dice), dice);
  if (!stack.kinks.empty() && uppermost) {
    kink_bottom(mesh, stack.columns, stack.kinks, height);
  } else if (!stack.kinks
                  .empty()) {  // the top follows the bottom of the body above
    std::vector<double> turned = stack.kinks;
    for (double& y : turned) y = -y;
    upside_down(mesh, height);
    kink_bottom(mesh, stack.columns, turned, height);
    upside_down(mesh, height);
  }
  stack.floor -= height + (uppermost ? 0 : stack.distance);
  mesh.vertices.row(0).array() += stack.from;
  mesh.vertices.row(1).array() += stack.floor;
  if (dice.chance(0.3)) split_triangles(mesh, dice.integer(1, 4), dice);
  if (dice.chance(0.5)) move_inner_vertices(mesh, 0.4, dice);
  if (dice.chance(0.4)) flip_edges(mesh, dice.integer(1, 6), dice);
  return mesh;
}

void hold(Body& body, const Plan& plan, bool uppermost, bool lowermost,
          double height, Dice& dice) {
  if (lowermost) {
    clamp(body, bottom);
  } else if (plan.support == Holding::pressed) {
    body.supports = {{left, 0, {}}};
  } else if (plan.support == Holding::held) {
    clamp(body, uppermost ? dice.pick<int>({top, top, left, right})
                          : dice.pick<int>({left, right}));
    if (uppermost && plan.moved && supported(body, top))
      move_supports(body, plan.strain * height, dice);
  }
}

void load_in_stack(Body& body, const Plan& plan, bool uppermost, Dice& dice) {
  const double size = plan.strain * plan.softest;
  if (plan.support == Holding::held && plan.loaded) {
    load(body,
         uppermost ? std::vector<int>{left, right, top}
                   : std::vector<int>{left, right},
         plan, dice);
  } else if (plan.support != Holding::held && uppermost) {
    const double push =
        plan.support == Holding::loose ? 0.1 * dice.real(-1, 1) : 0;
    body.tractions.push_back({top, size * Vector2d(push, -dice.real(0.1, 1))});
  }
}

/// Two or three bodies on each other, each as wide as that above it or wider.
void stacked_bodies(Case& c, Plan& plan, Dice& dice) {
  Stack stack = random_stack(plan, dice);
  for (int k = 0; k < stack.count; ++k) {
    const bool uppermost = k == 0, lowermost = k + 1 == stack.count;
    const double height = dice.decades(0.3, 2);
    Body body;
    if (!uppermost) widen(stack, dice);
    body.mesh = mesh_in(stack, uppermost, height, dice);
    hold(body, plan, uppermost, lowermost, height, dice);
    std::vector<int> kept;
    for (const Support& s : body.supports) kept.push_back(s.label);
    if (dice.chance(0.3))
      bite(body.mesh, dice.integer(1, 8), kept, {bottom, top}, dice);
    if (dice.chance(0.2)) renumber(body.mesh, dice);
    give_materials(body, plan, dice);
    load_in_stack(body, plan, uppermost, dice);
    c.bodies.push_back(std::move(body));
  }
  for (int k = 0; k + 1 < stack.count; ++k)
    c.contacts.push_back(stack.equal && dice.chance(0.5)
                             ? Contact{k + 1, {top}, {{k, bottom}}}
                             : Contact{k, {bottom}, {{k + 1, top}}});
  // What lies behind what a line faces is not faced.
  if (stack.count == 3 && dice.chance(0.5)) {
    Contact& first = c.contacts.front();
    if (first.body == 0) first.opposites.push_back({2, top});
    Contact& last = c.contacts.back();
    if (last.body == 2) last.opposites.push_back({0, bottom});
  }
}

/// A body on two others that touch each other, its line facing both.
void body_on_two(Case& c, Plan& plan, Dice& dice) {
  plan.support = dice.chance(0.7) ? Holding::held : Holding::pressed;
  const double width = dice.decades(0.5, 4);
  const std::vector<double> columns =
      places(dice.integer(2, 5), width, dice.chance(0.5) ? 1 : 4, dice);
  const double joint =
      dice.chance(0.5) ? columns[1] : dice.real(0.2, 0.8) * width;
  const auto body_between = [&](double from, double to, bool upper) {
    const double height = dice.decades(0.3, 2);
    Body body;
    body.mesh =
        grid(upper ? columns
                   : places(dice.integer(1, 4), to - from,
                            dice.chance(0.5) ? 1 : 4, dice),
             places(dice.integer(1, 3), height, dice.chance(0.7) ? 1 : 4, dice),
             dice);
    body.mesh.vertices.row(0).array() += from;
    if (!upper) body.mesh.vertices.row(1).array() -= height;
    if (dice.chance(0.5)) move_inner_vertices(body.mesh, 0.4, dice);
    hold(body, plan, upper, !upper, height, dice);
    give_materials(body, plan, dice);
    load_in_stack(body, plan, upper, dice);
    c.bodies.push_back(std::move(body));
  };
  body_between(0, width, true);
  body_between(dice.chance(0.5) ? 0 : -dice.real(0.1, 1) * width, joint, false);
  body_between(joint, dice.chance(0.5) ? width : dice.real(1.1, 2) * width,
               false);
  c.contacts = {{0, {bottom}, {{1, top}, {2, top}}}};
}

void give_law(Case& c, const Plan& plan, Dice& dice) {
  c.law = dice.pick<Law>({Law::frictionless, Law::tresca, Law::coulomb});
  c.multiplier = dice.chance(0.5) ? Multiplier::force : Multiplier::pressure;
  if (plan.support == Holding::loose) {
    c.law = Law::coulomb;
    c.promise = Promise::soundness;
  }
  if (c.law == Law::coulomb &&
      (c.promise == Promise::soundness || dice.chance(0.3))) {
    c.promise = Promise::soundness;
    c.friction = positive_field(3, dice);
    if (dice.chance(0.03))
      c.friction = {dice.decades(1, 1e30), {0, 0}, 0, {0, 0}};
  } else if (c.law == Law::coulomb) {
    c.friction.mean = dice.real(0, 0.2);
    if (dice.chance(0.3))
      c.friction = {
          0.1, 0.05 * Vector2d(dice.real(-1, 1), dice.real(-1, 1)), 0, {0, 0}};
  } else if (c.law == Law::tresca) {
    c.slip_bound = positive_field(
        plan.strain * plan.softest * dice.decades(0.01, 10), dice);
  }
  const bool pressed = plan.support != Holding::held;
  c.has_gap = dice.chance(0.4) && (!c.has_opposites() || plan.flat);
  if (c.has_gap)
    c.gap = c.has_opposites() ? positive_field(plan.strain, dice)
                              : random_field(plan.strain, dice);
  if (pressed && c.has_gap) c.gap.slope.setZero();
  c.has_previous = c.law != Law::frictionless && dice.chance(0.2);
  if (c.has_previous) c.previous = random_field(plan.strain, dice);
}

/// The foundation of a held body becomes a tool that is pressed against it, and turns
/// about a point near its line.
void give_tool(Case& c, const Plan& plan, Dice& dice) {
  const Mesh& mesh = c.bodies.front().mesh;
  Vector2d n(0, 0), middle(0, 0);
  double length = 0;
  for (Index e = 0; e < mesh.boundary.cols(); ++e) {
    if (mesh.boundary_label[e] != c.contacts.front().labels.front()) continue;
    const Vector2d a = mesh.vertices.col(mesh.boundary(0, e)),
                   b = mesh.vertices.col(mesh.boundary(1, e));
    n += Vector2d((b - a).y(), (a - b).x());
    middle += (b - a).norm() * (a + b) / 2;
    length += (b - a).norm();
  }
  if (length == 0) return;
  middle /= length;
  const double force = plan.softest * plan.strain * length * dice.real(0.1, 1);
  Tool tool;
  tool.push =
      -force * n.normalized() +
      force * dice.real(0, 0.3) * Vector2d(dice.real(-1, 1), dice.real(-1, 1));
  tool.turns = dice.chance(0.6);
  tool.about = middle + length * dice.real(0, 1) *
                            Vector2d(dice.real(-1, 1), dice.real(-1, 1));
  if (tool.turns) tool.moment = force * length * dice.real(-0.3, 0.3);
  c.tool = tool;
  c.promise = Promise::soundness;
}

/// x -> scale R S x + shift for all that has places, and lengths with it.
void transform(Case& c, const Matrix2d& turn, double scale,
               const Vector2d& shift) {
  for (Body& body : c.bodies) {
    for (int v = 0; v < body.mesh.vertex_count(); ++v)
      body.mesh.vertices.col(v) =
          scale * (turn * body.mesh.vertices.col(v)) + shift;
    for (Traction& t : body.tractions) t.value = turn * t.value;
    body.force = turn * body.force / scale;
    for (Support& s : body.supports) {
      s.value.mean *= scale;
      s.value.slope *= scale;
    }
  }
  if (c.tool) {
    c.tool->push = scale * (turn * c.tool->push);
    c.tool->moment *= scale * scale;
    c.tool->about = scale * (turn * c.tool->about) + shift;
  }
  for (Field* f : {&c.gap, &c.previous}) {
    f->mean *= scale;
    f->slope *= scale;
    f->wave *= scale;
  }
  c.size *= scale;
}

/// A turn by any angle where every support holds both components, by a right angle
/// otherwise.
void place(Case& c, const Plan& plan, Dice& dice) {
  bool both = plan.support != Holding::pressed;
  for (const Body& body : c.bodies)
    both = both && body.supports.size() % 2 == 0 &&
           (body.supports.empty() ||
            body.supports[0].label == body.supports.back().label);
  Matrix2d turn = Matrix2d::Identity();
  if (both && dice.chance(0.5)) {
    turn = Eigen::Rotation2Dd(dice.real(0, 2 * M_PI)).toRotationMatrix();
  } else if (dice.chance(0.3)) {
    for (int k = dice.integer(1, 3); k > 0; --k)
      turn = (Matrix2d() << 0, -1, 1, 0).finished() * turn;
    if (turn(0, 0) == 0)
      for (Body& body : c.bodies)
        for (Support& s : body.supports) s.component = 1 - s.component;
  }
  const double scale = dice.chance(0.5) ? 1 : dice.decades(1e-9, 1e6);
  Vector2d shift(0, 0);
  if (dice.chance(0.3))
    shift = scale * dice.decades(1, dice.chance(0.9) ? 1e3 : 1e6) *
            Vector2d(dice.real(-1, 1), dice.real(-1, 1));
  transform(c, turn, scale, shift);
  c.origin = c.bodies.front().mesh.vertices.rowwise().mean();
}

void give_matrix(Case& c, Dice& dice) {
  bool moved = false;
  for (const Body& body : c.bodies)
    for (const Support& s : body.supports)
      moved = moved || s.value.mean != 0 || !s.value.slope.isZero(0);
  c.tgv = dice.chance(0.6) ? 1e30 : dice.chance(0.5) || moved ? -1 : -2;
}

bool usable(const Case& c) {
  if (c.cell_count() > most_triangles) return false;
  return std::all_of(c.bodies.begin(), c.bodies.end(), [](const Body& body) {
    return worst_aspect(body.mesh) <= thinnest;
  });
}

Case drawn(Dice& dice) {
  Case c;
  Plan plan;
  plan.support = dice.chance(0.8)   ? Holding::held
                 : dice.chance(0.7) ? Holding::pressed
                                    : Holding::loose;
  plan.softest = dice.decades(0.1, 1e5);
  plan.strain = dice.decades(1e-6, 1e-2);
  plan.loaded = dice.chance(0.75);
  plan.moved = dice.chance(0.5);
  if (dice.chance(0.6))
    one_body(c, plan, dice);
  else if (dice.chance(0.6))
    stacked_bodies(c, plan, dice);
  else if (dice.chance(0.5))
    body_on_two(c, plan, dice);
  else
    cracked_body(c, plan, dice);
  c.size = (c.bodies.back().mesh.vertices.rowwise().maxCoeff() -
            c.bodies.front().mesh.vertices.rowwise().minCoeff())
               .cwiseAbs()
               .maxCoeff();
  give_law(c, plan, dice);
  if (c.bodies.size() == 1 && !c.has_opposites() && c.contacts.size() == 1 &&
      plan.support == Holding::held && dice.chance(0.08))
    give_tool(c, plan, dice);
  place(c, plan, dice);
  give_matrix(c, dice);
  c.sweeps = dice.chance(0.8) ? 2 : dice.pick<int>({0, 1, 5, 40});
  return c;
}

}  // namespace

Case random_case(std::uint64_t seed, std::uint64_t index) {
  Dice dice(seed, index);
  for (;;) {
    Case c = drawn(dice);
    if (!usable(c)) continue;
    c.with_reference =
        index % 10 == 0 && c.cell_count() <= 40 && c.law != Law::coulomb;
    return c;
  }
}

}  // namespace ffcontact::fuzz
