// SPDX-License-Identifier: GPL-3.0-or-later
#include "pictures/vtu.hpp"

#include "freefem/text_file.hpp"

namespace ffcontact::plugin {

namespace {

constexpr int triangle_type = 5, tetrahedron_type = 10;  // of VTK

template <class Values>
void write_array(TextFile& file, const char* type, const std::string& name,
                 const Values& values) {
  file << "<DataArray type=\"" << type << "\" Name=\"" << name
       << "\" NumberOfComponents=\"" << values.rows()
       << "\" format=\"ascii\">\n";
  for (Index k = 0; k < values.cols(); ++k) {
    for (Index c = 0; c < values.rows(); ++c)
      file << (c > 0 ? " " : "") << values(c, k);
    file << "\n";
  }
  file << "</DataArray>\n";
}

void write_fields(TextFile& file, const char* place,
                  const std::vector<VtuField>& fields) {
  file << "<" << place << ">\n";
  for (const VtuField& field : fields)
    write_array(file, "Float64", field.name, field.values);
  file << "</" << place << ">\n";
}

}  // namespace

void write_vtu(const std::filesystem::path& path, const VtuCells& cells) {
  using Numbers = Eigen::RowVectorXi;
  const Index count = cells.corners.cols();
  const int corners = static_cast<int>(cells.corners.rows());
  TextFile file(path);
  file << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
          "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
          "<Piece NumberOfPoints=\""
       << cells.points.cols() << "\" NumberOfCells=\"" << count
       << "\">\n<Points>\n";
  write_array(file, "Float64", "points", cells.points);
  file << "</Points>\n<Cells>\n";
  write_array(file, "Int32", "connectivity", cells.corners);
  write_array(file, "Int32", "offsets",
              Numbers(Numbers::LinSpaced(count, corners,
                                         corners * static_cast<int>(count))));
  write_array(file, "Int32", "types",
              Numbers(Numbers::Constant(
                  count, corners == 3 ? triangle_type : tetrahedron_type)));
  file << "</Cells>\n";
  write_fields(file, "PointData", cells.on_points);
  write_fields(file, "CellData", cells.on_cells);
  file << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  file.close();
}

}  // namespace ffcontact::plugin
