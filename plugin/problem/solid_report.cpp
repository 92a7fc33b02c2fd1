// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/solid_report.hpp"

#include <string>

#include "ffcontact/base/words.hpp"
#include "ffcontact/interface/pairing/smooth_surface_distances.hpp"
#include "ffcontact/linear/norms.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

void report_surfaces(const JoinedSolids& joined, const Facets<3>& faces,
                     const StatedPair& pair, const SaidOfCurves& said) {
  if (verbosity < 1 || mpirank != 0) return;
  const double rounding = 1e-12 * max_norm(joined.mesh.vertices);
  const auto report = [&](int body, int label, const std::string& taken) {
    const double sagitta = largest_sagitta(
        joined.mesh, faces, contact_surface(joined.mesh, faces, {label}));
    if (sagitta <= rounding || taken.empty()) return;
    cout << "contact: label " << label - joined.label(body, 0);
    if (joined.body_count() > 1) cout << " of mesh " << body + 1;
    cout << ": a smooth surface, up to " << in_digits(sagitta)
         << " mm beside its faces, with " << taken << endl;
  };
  const bool gap = !pair.rigid() && !said.gap;
  const std::string normals = said.normal ? "" : "its normals",
                    and_gap = said.normal ? "its gap" : " and its gap";
  for (int label : pair.labels)
    report(pair.body, label, normals + (gap ? and_gap : ""));
  if (!gap) return;
  for (int label : pair.opposite)
    report(body_of_label(joined, label), label, "its gap");
}

}  // namespace ffcontact::plugin
