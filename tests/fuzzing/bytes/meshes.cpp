// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of any kind: what takes them says what is wrong, or goes on.
#include "bytes/data.hpp"
#include "ffcontact/interface/contact_line.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/interface/pairing/facing_line.hpp"
#include "ffcontact/mesh/topology.hpp"

using namespace ffcontact;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const Mesh mesh = fuzz::any_mesh(bytes);
  std::vector<int> labels(1 + bytes.up_to(2)), opposite(1 + bytes.up_to(1));
  for (int& label : labels) label = bytes.up_to(5);
  for (int& label : opposite) label = bytes.up_to(5);
  fuzz::refused_or_done([&] {
    require_valid(mesh);
    const Edges edges = edges_of(mesh);
    fuzz::refused_or_done([&] { topology_of(mesh); });
    fuzz::refused_or_done([&] {
      contact_line(mesh, edges, labels,
                   BoundaryCurves(mesh, edges, 90 * bytes.up_to(1)));
    });
    fuzz::refused_or_done([&] {
      const ContactLine line = smooth_contact_line(mesh, edges, labels);
      Matrix2Xd directions(2, line.node_count() + bytes.up_to(1));
      for (double& value : directions.reshaped()) value = bytes.number();
      along_directions(mesh, edges, line, directions);
    });
    fuzz::refused_or_done([&] {
      const ContactLine line = contact_line(mesh, edges, labels);
      const ContactLine facing = facing_line(
          mesh, edges, line, facing_traces(mesh, edges, line, opposite));
      exchanged_line(mesh, edges, facing, opposite);
    });
  });
  return 0;
}
