// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtu.hpp"

#include "text_file.hpp"

namespace ffcontact::plugin {

namespace {

constexpr int triangle_type = 5;  // of VTK

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

void write_vtu(const std::filesystem::path& path,
               const VtuTriangles& triangles) {
  using Numbers = Eigen::RowVectorXi;
  const Index points = triangles.points.cols(),
              count = triangles.corners.cols();
  MatrixXd places = MatrixXd::Zero(3, points);
  places.topRows<2>() = triangles.points;
  TextFile file(path);
  file << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
          "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
          "<Piece NumberOfPoints=\""
       << points << "\" NumberOfCells=\"" << count << "\">\n<Points>\n";
  write_array(file, "Float64", "points", places);
  file << "</Points>\n<Cells>\n";
  write_array(file, "Int32", "connectivity", triangles.corners);
  write_array(
      file, "Int32", "offsets",
      Numbers(Numbers::LinSpaced(count, 3, 3 * static_cast<int>(count))));
  write_array(file, "Int32", "types",
              Numbers(Numbers::Constant(count, triangle_type)));
  file << "</Cells>\n";
  write_fields(file, "PointData", triangles.on_points);
  write_fields(file, "CellData", triangles.on_triangles);
  file << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  file.close();
}

}  // namespace ffcontact::plugin
