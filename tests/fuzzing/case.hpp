// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/mesh/mesh.hpp"

/// Random contact problems, solved, estimated and judged by code that shares nothing with
/// the library but its interface.
namespace ffcontact::fuzz {

/// mean + slope . x + wave sin(number . x) of places x that are relative to the problem:
/// (x - origin) / size.
struct Field {
  double mean = 0;
  Vector2d slope{0, 0};
  double wave = 0;
  Vector2d number{0, 0};

  double at(const Vector2d& x) const {
    return mean + slope.dot(x) + wave * std::sin(number.dot(x));
  }
};

struct Material {
  double E, nu;  ///< [MPa], [-]
};

struct Traction {
  int label;
  Vector2d value;  ///< [MPa]
};

/// One component prescribed at the vertices of a label.
struct Support {
  int label, component;
  Field value;  ///< [mm]
};

struct Body {
  Mesh mesh;
  std::vector<int> region;          ///< per triangle
  std::vector<Material> materials;  ///< per region
  std::vector<Traction> tractions;
  std::vector<Support> supports;
  Vector2d force{0, 0};  ///< [N/mm^3]
};

struct Opposite {
  int body, label;
};

/// A contact line: labels of a body, against the rigid foundation (no opposites) or labels
/// of other bodies, or of its own.
struct Contact {
  int body;
  std::vector<int> labels;
  std::vector<Opposite> opposites;
};

/// A rigid foundation that is pushed, and turns about a point where its moment is given.
struct Tool {
  Vector2d push{0, 0};  ///< [N/mm]
  bool turns = false;
  double moment = 0;  ///< about `about` [N]
  Vector2d about{0, 0};
};

enum class Law { frictionless, tresca, coulomb };

/// What the theory promises of the problem.
enum class Promise {
  /// there is a solution, unless prescribed values rule it out: it must be found and its
  /// estimate admissible
  solution,
  soundness,  ///< what is called a solution is one
};

/// A contact problem, complete: what is random about it has been drawn.
struct Case {
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
  Law law = Law::frictionless;
  Multiplier multiplier = Multiplier::force;
  Field friction,
      slip_bound;  ///< what is below 0 counts as 0; read as the law asks
  bool has_gap = false, has_previous = false;
  Field gap, previous;  ///< [mm]; without a gap that of the meshes is taken
  std::optional<Tool> tool;
  /// how supports stand in the matrix: 1e30, -1 or -2, as FreeFEM's tgv
  double tgv = 1e30;
  Vector2d origin{0, 0};
  double size = 1;
  Promise promise = Promise::solution;
  int sweeps = 2;
  /// is the bound (2.20) to be compared with a finer solution?
  bool with_reference = false;

  Vector2d place(const Vector2d& x) const { return (x - origin) / size; }
  int cell_count() const;
  /// Does a line face a trace that yields?
  bool has_opposites() const;
};

/// One word each: "tresca force 2 bodies".
std::string kind(const Case& problem);

/// Text with all digits; read_case(text_of(c)) is c.
std::string text_of(const Case& problem);

/// @throws std::runtime_error  if the text is not that of a case
Case case_of(const std::string& text);

}  // namespace ffcontact::fuzz
