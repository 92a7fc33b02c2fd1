// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/stated_tool.hpp"

#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

namespace {

/// [x, y], or 0 where it is not given.
Vector2d pair_of(const SolveCall& call, const char* name) {
  Vector2d values(0, 0);
  if (!call.named.given(name)) return values;
  for (int c = 0; c < 2; ++c)
    values[c] = value_of<double>(call.stack, call.named.component(name, c, 2));
  return values;
}

void require_used(const NamedArguments& named, const char* name,
                  const char* with) {
  if (named.given(name) && !named.given(with))
    refuse(name, "= is for ", with, "=");
}

void add_motion(const Vector3d& motion, RigidTool& tool) {
  tool.free.conservativeResize(3, tool.free.cols() + 1);
  tool.free.rightCols(1) = motion;
}

void add_translations(const SolveCall& call, RigidTool& tool) {
  if (!call.named.given("guide")) {
    add_motion(Vector3d::UnitX(), tool);
    add_motion(Vector3d::UnitY(), tool);
    return;
  }
  const Vector2d guide = pair_of(call, "guide");
  if (!(guide.norm() > 0))
    refuse("guide must be a direction [gx, gy], got [", guide.x(), ", ",
           guide.y(), "]");
  Vector3d along = Vector3d::Zero();
  along.head<2>() = guide.normalized();
  add_motion(along, tool);
}

}  // namespace

std::optional<RigidTool> stated_tool(const SolveCall& call,
                                     const Vector2d& origin) {
  const NamedArguments& named = call.named;
  require_used(named, "guide", "push");
  require_used(named, "about", "moment");
  if (!named.given("push") && !named.given("moment")) {
    if (named.given("tool")) refuse("tool= is for push= or moment=");
    return std::nullopt;
  }
  RigidTool tool;
  tool.about = pair_of(call, "about") - origin;
  tool.push.head<2>() = pair_of(call, "push");
  tool.push[2] = named.number(call.stack, "moment", 0);
  tool.free.resize(3, 0);
  if (named.given("push")) add_translations(call, tool);
  if (named.given("moment")) add_motion(Vector3d::UnitZ(), tool);
  return tool;
}

void require_no_tool(const NamedArguments& named) {
  for (const char* name : {"push", "moment", "about", "guide", "tool"})
    if (named.given(name))
      refuse(name, "= is for plane bodies on a rigid foundation");
}

}  // namespace ffcontact::plugin
