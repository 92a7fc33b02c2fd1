// SPDX-License-Identifier: GPL-3.0-or-later
#include "case.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::fuzz {

namespace {

constexpr const char* heading = "ffcontact-fuzz-2";

/// Writes name and numbers, line by line.
class Writer {
 public:
  Writer() { text_.precision(17); }
  std::string text() const { return text_.str(); }

  template <class... Values>
  void line(const char* name, const Values&... values) {
    text_ << name;
    (add(values), ...);
    text_ << '\n';
  }

 private:
  template <class Value>
  void add(const Value& value) {
    text_ << ' ' << value;
  }
  void add(const Vector2d& v) { text_ << ' ' << v.x() << ' ' << v.y(); }
  void add(const Field& f) {
    add(f.mean);
    add(f.slope);
    add(f.wave);
    add(f.number);
  }
  void add(const std::vector<int>& values) {
    add(values.size());
    for (int value : values) add(value);
  }

  void add(const std::vector<Opposite>& opposites) {
    add(opposites.size());
    for (const auto& [body, label] : opposites) {
      add(body);
      add(label);
    }
  }

  std::ostringstream text_;
};

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  bool at_end() { return (text_ >> std::ws).eof(); }

  template <class... Values>
  void line(const char* name, Values&... values) {
    std::string found;
    text_ >> found;
    if (found != name)
      throw std::runtime_error("expected " + std::string(name) + ", found \"" +
                               found + "\"");
    (get(values), ...);
    if (!text_)
      throw std::runtime_error("cannot read the values of " +
                               std::string(name));
  }

 private:
  template <class Value>
  void get(Value& value) {
    text_ >> value;
  }
  void get(Vector2d& v) { text_ >> v.x() >> v.y(); }
  void get(Field& f) {
    text_ >> f.mean;
    get(f.slope);
    text_ >> f.wave;
    get(f.number);
  }
  void get(std::vector<int>& values) {
    std::size_t size = 0;
    text_ >> size;
    values.assign(size, 0);
    for (int& value : values) text_ >> value;
  }

  void get(std::vector<Opposite>& opposites) {
    std::size_t size = 0;
    text_ >> size;
    opposites.assign(size, {});
    for (auto& [body, label] : opposites) text_ >> body >> label;
  }

  std::istringstream text_;
};

void write(Writer& out, const Body& body) {
  const Mesh& mesh = body.mesh;
  out.line("body", mesh.vertices.cols(), mesh.cells.cols(),
           mesh.boundary.cols(), body.materials.size(), body.tractions.size(),
           body.supports.size());
  for (int v = 0; v < mesh.vertex_count(); ++v)
    out.line("v", Vector2d(mesh.vertices.col(v)));
  for (int t = 0; t < mesh.cell_count(); ++t)
    out.line("t", mesh.cells(0, t), mesh.cells(1, t), mesh.cells(2, t),
             body.region[t]);
  for (int e = 0; e < mesh.boundary.cols(); ++e)
    out.line("e", mesh.boundary(0, e), mesh.boundary(1, e),
             mesh.boundary_label[e]);
  for (const Material& m : body.materials) out.line("material", m.E, m.nu);
  for (const Traction& t : body.tractions)
    out.line("traction", t.label, t.value);
  for (const Support& s : body.supports)
    out.line("support", s.label, s.component, s.value);
  out.line("force", body.force);
}

Body body_of(Reader& in) {
  Body body;
  Mesh& mesh = body.mesh;
  Index vertices = 0, triangles = 0, boundary = 0;
  std::size_t materials = 0, tractions = 0, supports = 0;
  in.line("body", vertices, triangles, boundary, materials, tractions,
          supports);
  mesh.vertices.resize(2, vertices);
  mesh.cells.resize(3, triangles);
  mesh.boundary.resize(2, boundary);
  mesh.boundary_label.resize(boundary);
  body.region.resize(triangles);
  for (Index v = 0; v < vertices; ++v)
    in.line("v", mesh.vertices(0, v), mesh.vertices(1, v));
  for (Index t = 0; t < triangles; ++t)
    in.line("t", mesh.cells(0, t), mesh.cells(1, t), mesh.cells(2, t),
            body.region[t]);
  for (Index e = 0; e < boundary; ++e)
    in.line("e", mesh.boundary(0, e), mesh.boundary(1, e),
            mesh.boundary_label[e]);
  body.materials.resize(materials);
  body.tractions.resize(tractions);
  body.supports.resize(supports);
  for (Material& m : body.materials) in.line("material", m.E, m.nu);
  for (Traction& t : body.tractions) in.line("traction", t.label, t.value);
  for (Support& s : body.supports)
    in.line("support", s.label, s.component, s.value);
  in.line("force", body.force);
  return body;
}

}  // namespace

int Case::cell_count() const {
  int count = 0;
  for (const Body& body : bodies) count += body.mesh.cell_count();
  return count;
}

bool Case::has_opposites() const {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const Contact& c) { return !c.opposites.empty(); });
}

std::string kind(const Case& problem) {
  constexpr const char* laws[] = {"frictionless", "tresca", "coulomb"};
  return std::string(laws[static_cast<int>(problem.law)]) +
         (problem.multiplier == Multiplier::force ? " force " : " pressure ") +
         std::to_string(problem.bodies.size()) +
         (problem.bodies.size() > 1 ? " bodies"
          : problem.has_opposites() ? " body with a crack"
          : problem.tool            ? " body and a tool"
                                    : " body") +
         (problem.promise == Promise::solution ? "" : " (soundness only)");
}

std::string text_of(const Case& c) {
  Writer out;
  out.line(heading);
  out.line("law", static_cast<int>(c.law), static_cast<int>(c.multiplier),
           static_cast<int>(c.promise), c.sweeps, c.with_reference, c.tgv);
  out.line("place", c.origin, c.size);
  out.line("friction", c.friction);
  out.line("slipbound", c.slip_bound);
  out.line("gap", c.has_gap, c.gap);
  out.line("previous", c.has_previous, c.previous);
  out.line("bodies", c.bodies.size(), c.contacts.size());
  for (const Body& body : c.bodies) write(out, body);
  for (const Contact& contact : c.contacts)
    out.line("contact", contact.body, contact.labels, contact.opposites);
  if (c.tool)
    out.line("tool", c.tool->push, c.tool->turns, c.tool->moment,
             c.tool->about);
  return out.text();
}

Case case_of(const std::string& text) {
  Reader in(text);
  Case c;
  int law = 0, multiplier = 0, promise = 0;
  std::size_t bodies = 0, contacts = 0;
  in.line(heading);
  in.line("law", law, multiplier, promise, c.sweeps, c.with_reference, c.tgv);
  c.law = static_cast<Law>(law);
  c.multiplier = static_cast<Multiplier>(multiplier);
  c.promise = static_cast<Promise>(promise);
  in.line("place", c.origin, c.size);
  in.line("friction", c.friction);
  in.line("slipbound", c.slip_bound);
  in.line("gap", c.has_gap, c.gap);
  in.line("previous", c.has_previous, c.previous);
  in.line("bodies", bodies, contacts);
  while (c.bodies.size() < bodies) c.bodies.push_back(body_of(in));
  c.contacts.resize(contacts);
  for (Contact& contact : c.contacts)
    in.line("contact", contact.body, contact.labels, contact.opposites);
  if (in.at_end()) return c;
  Tool& tool = c.tool.emplace();
  in.line("tool", tool.push, tool.turns, tool.moment, tool.about);
  return c;
}

}  // namespace ffcontact::fuzz
