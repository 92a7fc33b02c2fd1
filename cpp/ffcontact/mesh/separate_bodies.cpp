// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/separate_bodies.hpp"

#include "ffcontact/base/unions.hpp"

namespace ffcontact {

template <int dim>
std::vector<int> body_of_each_vertex(const SimplexMesh<dim>& mesh) {
  Unions bodies(mesh.vertex_count());
  for (const auto& vertices : mesh.cells.colwise())
    for (int k = 1; k <= dim; ++k) bodies.join(vertices[0], vertices[k]);
  return bodies.numbers();
}

template std::vector<int> body_of_each_vertex(const Mesh&);
template std::vector<int> body_of_each_vertex(const SolidMesh&);

}  // namespace ffcontact
