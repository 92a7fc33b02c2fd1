// SPDX-License-Identifier: GPL-3.0-or-later
#include "pictures/gmsh_fields.hpp"

#include "freefem/text_file.hpp"

namespace ffcontact::plugin {

namespace {

template <class Vertices>
void write_element(TextFile& file, int number, int type, int tag,
                   const Vertices& vertices) {
  file << number << " " << type << " 2 " << tag << " " << tag;
  for (const int v : vertices) file << " " << v + 1;
  file << "\n";
}

/// @param first  number of the first column's node or element
void write_field(TextFile& file, const char* section, const VtuField& field,
                 Index first) {
  file << "$" << section << "\n1\n\"" << field.name << "\"\n1\n0\n3\n0\n"
       << field.values.rows() << "\n"
       << field.values.cols() << "\n";
  for (Index k = 0; k < field.values.cols(); ++k) {
    file << first + k;
    for (const double value : field.values.col(k)) file << " " << value;
    file << "\n";
  }
  file << "$End" << section << "\n";
}

}  // namespace

void write_gmsh_fields(const std::filesystem::path& path,
                       const Fem2D::Mesh3& Th, const VtuCells& cells) {
  constexpr int triangle = 2, tetrahedron = 4;
  TextFile file(path);
  file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << Th.nv << "\n";
  for (int v = 0; v < Th.nv; ++v)
    file << v + 1 << " " << Th(v).x << " " << Th(v).y << " " << Th(v).z << "\n";
  file << "$EndNodes\n$Elements\n" << Th.nbe + Th.nt << "\n";
  for (int e = 0; e < Th.nbe; ++e) {
    const auto& face = Th.be(e);
    write_element(file, e + 1, triangle, face.lab,
                  Vector3i(Th(face[0]), Th(face[1]), Th(face[2])));
  }
  for (int t = 0; t < Th.nt; ++t)
    write_element(file, Th.nbe + t + 1, tetrahedron, Th[t].lab,
                  cells.corners.col(t));
  file << "$EndElements\n";
  for (const VtuField& field : cells.on_points)
    write_field(file, "NodeData", field, 1);
  for (const VtuField& field : cells.on_cells)
    write_field(file, "ElementData", field, Th.nbe + 1);
  file.close();
}

}  // namespace ffcontact::plugin
