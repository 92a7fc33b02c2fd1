// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/tool_work.hpp"

#include <algorithm>

#include "ffcontact/estimate/tractions/nearest_in_cone.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

double largest_on(const ContactLine& line, const Ref<const VectorXd>& field) {
  double largest = 0;
  for (const int v : line.vertex)
    largest = std::max(largest, max_norm(field.segment<2>(2 * v)));
  return largest;
}

}  // namespace

ToolWork tool_work(const Mesh& mesh, const ContactLine& line,
                   const SolvedBody<2>& body) {
  if (!body.tool) return {MatrixXd(2 * mesh.vertices.cols(), 0), VectorXd(0)};
  ToolWork tool{tool_fields(mesh, *body.tool),
                body.tool->free.transpose() * body.tool->push};
  for (Index k = 0; k < tool.work.size(); ++k) {
    const double size = largest_on(line, tool.fields.col(k));
    tool.fields.col(k) /= size;
    tool.work[k] /= size;
  }
  return tool;
}

double tool_defect(const ContactLine& line, const ToolWork& tool,
                   const ContactDensities& densities) {
  if (tool.work.size() == 0) return 0;
  return max_norm(resultants_of(line, densities, tool.fields) - tool.work) /
         line.length.sum();
}

}  // namespace ffcontact
