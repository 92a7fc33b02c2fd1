// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/doubtful_curve.hpp"

#include "ffcontact/base/words.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

void warn_of_curve(const JoinedSolids& joined, int body, int vertex, int column,
                   const std::string& doubt) {
  if (mpirank != 0) return;
  cout << "contact: label "
       << joined.mesh.boundary_label[column] - joined.label(body, 0)
       << " is curved at vertex " << vertex - joined.first_vertex[body] << " "
       << in_words(joined.mesh.place(vertex), digits_of_figures);
  if (joined.body_count() > 1) cout << " of mesh " << body + 1;
  cout << doubt << endl;
}

}  // namespace ffcontact::plugin
