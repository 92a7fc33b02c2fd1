// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

/// What a fuzzer's bytes stand for, out of order or not.
namespace ffcontact::fuzz {

/// Bytes one after the other; 0 where they end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size)
      : data_(data), left_(size) {}

  bool empty() const { return left_ == 0; }
  int next() {
    if (empty()) return 0;
    --left_;
    return *data_++;
  }
  /// 0 to most
  int up_to(int most) { return next() % (most + 1); }
  /// Small multiples of an eighth, as a rule; 32 of the 256 bytes are other values.
  double number() {
    constexpr double odd[] = {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity(),
                              1e300,
                              -1e300,
                              1e-300,
                              1e30,
                              1e-13,
                              1e9};
    const int byte = next();
    return byte < 224 ? (byte - 64) / 8.0 : odd[byte % 8];
  }
  VectorXd numbers(Index count) {
    VectorXd values(count);
    for (double& value : values) value = number();
    return values;
  }
  /// Indices of 0 to count - 1, of which one in sixteen is out of range.
  int index(int count) {
    const int byte = next();
    if (byte >= 240) return byte % 2 == 0 ? -1 : count + byte % 3;
    return count > 0 ? byte % count : 0;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

/// A grid of at most 4 x 4 squares in contact at the bottom (label 1), or what is left of
/// it when some of its numbers are replaced; or triangles without any order.
inline Mesh any_mesh(Bytes& bytes) {
  const bool ordered = bytes.next() < 192;
  const int nx = 1 + bytes.up_to(3), ny = 1 + bytes.up_to(3);
  const auto vertex = [&](int i, int j) { return j * (nx + 1) + i; };
  Mesh mesh;
  mesh.vertices.resize(2, (nx + 1) * (ny + 1));
  for (int v = 0; v < mesh.vertex_count(); ++v)
    mesh.vertices.col(v) << v % (nx + 1), v / (nx + 1);
  mesh.cells.resize(3, 2 * nx * ny);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      mesh.cells.middleCols<2>(2 * (j * nx + i)) << vertex(i, j), vertex(i, j),
          vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i + 1, j + 1),
          vertex(i, j + 1);
  mesh.boundary.resize(2, 2 * (nx + ny));
  mesh.boundary_label.resize(mesh.boundary.cols());
  int b = 0;
  const auto add = [&](int from, int to, int label) {
    mesh.boundary.col(b) << from, to;
    mesh.boundary_label[b++] = label;
  };
  for (int i = 0; i < nx; ++i) add(vertex(i, 0), vertex(i + 1, 0), 1);
  for (int j = 0; j < ny; ++j) add(vertex(nx, j), vertex(nx, j + 1), 2);
  for (int i = 0; i < nx; ++i) add(vertex(i, ny), vertex(i + 1, ny), 3);
  for (int j = 0; j < ny; ++j) add(vertex(0, j), vertex(0, j + 1), 4);

  const int count = mesh.vertex_count();
  for (int k = bytes.up_to(6); k > 0; --k) {
    const int what = bytes.up_to(3), place = bytes.next();
    if (what == 0)
      mesh.vertices.reshaped()[place % (2 * count)] = bytes.number();
    else if (what == 1)
      mesh.cells.reshaped()[place % mesh.cells.size()] = bytes.index(count);
    else if (what == 2)
      mesh.boundary.reshaped()[place % mesh.boundary.size()] =
          bytes.index(count);
    else
      mesh.boundary_label[place % mesh.boundary_label.size()] = bytes.up_to(4);
  }
  if (!ordered)
    for (int& v : mesh.cells.reshaped()) v = bytes.index(count);
  return mesh;
}

/// Runs what may refuse its input.
template <class Call>
void refused_or_done(Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument&) {
  } catch (const std::runtime_error&) {
  }
}

}  // namespace ffcontact::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size);
