// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/contact_settings.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/law/held_rows.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// The problem as it was stated, and what its multipliers P are to the bodies. Rows d i + c.
template <int d>
struct StatedContact {
  using NodalVectors = Matrix<double, d, Dynamic>;

  const LineOrSurface<d>& contact;
  const ContactLaw<d>& law;
  const ElasticSystem& system;
  const ContactSettings& settings;
  const HeldRows<d> held;
  const NodalLaw cones = nodal_law(law, contact);

  /// Contact forces W P at the nodes.
  NodalVectors forces_of(const VectorXd& P) const;

  /// The load on all dofs of those that load a body.
  VectorXd load_of(const VectorXd& P) const;

  /// v = W (u_n - gap, u_t - previous) of a displacement on all dofs, on held rows that of the
  /// prescribed values, with a layer that carries P.
  VectorXd v_of(const VectorXd& displacement, const VectorXd& P) const;

  /// Largest violation of the law, Prop. 3.4 for pressures and Prop. 3.5 for forces, relative
  /// to the largest multiplier, or the largest displacement of the body, gap or previous
  /// displacement.
  /// @param least  what v and P are relative to at least: where all nodes stick u is nothing
  ///               but rounding, and P where none is loaded
  double law_defect(const VectorXd& displacement, const VectorXd& P,
                    const LawScales& least = {}) const;

 private:
  VectorXd weighted(const NodalVectors& values) const;
  ContactLaw<d> law_under(const VectorXd& P) const;
  Flags idle() const;
  double largest_weight() const;
};

/// @throws std::invalid_argument  if law, sizes or settings do not fit
template <int d>
void require_valid(const SimplexMesh<d>& mesh, const LineOrSurface<d>& contact,
                   const ContactLaw<d>& law, const ElasticSystem& system,
                   const ContactSettings& settings) {
  require_valid(law, contact);
  require_size("A", system.dof_count(), d * mesh.vertices.cols());
  require_same_tgv(system, extent_of(mesh));
  require_valid(settings, contact.node_count());
}

/// On a line, with its held rows. All of them outlive it.
inline StatedContact<2> stated_on_line(const ContactLine& line,
                                       const ContactLaw<2>& law,
                                       const ElasticSystem& system,
                                       const ContactSettings& settings) {
  return {line, law, system, settings, held_rows(line, law, system)};
}

}  // namespace ffcontact
