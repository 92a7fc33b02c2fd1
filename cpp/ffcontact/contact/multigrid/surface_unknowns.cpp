// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/surface_unknowns.hpp"

#include <map>
#include <utility>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// What the frames of a shared vertex have, and no row of its own elsewhere.
void put_shared(const ContactSurface& surface, SurfaceUnknowns& unknowns,
                Flags& is_shared) {
  is_shared.assign(surface.node_count(), 0);
  for (const SharedVertex& shared : unknowns.shared) {
    for (const int row : shared.rows) is_shared[row / 3] = 1;
    unknowns.frames.put(shared.vertex, shared.T);
    for (int j = 0; j < count_of(shared.faced); ++j)
      if (!shared.B[j].isZero(0))
        unknowns.frames.follow(shared.vertex, shared.faced[j].vertex,
                               shared.B[j]);
  }
}

/// T of the other contact vertices and the unknowns of their rows.
void put_frames(const ContactSurface& surface, const SurfaceTrace& trace,
                const Flags& is_shared, SurfaceUnknowns& unknowns) {
  const ContactTrace& moved = trace.trace;
  std::vector<Matrix3d> T(surface.node_count(), Matrix3d::Zero());
  for (int k = 0; k < count_of(trace.primary); ++k) {
    const int row = trace.primary[k], node = row / 3;
    if (is_shared[node]) continue;
    unknowns.of_row[row] = 3 * surface.vertex[node] + row % 3;
    for (SparseMatrix::InnerIterator e(moved.to_kept, k); e; ++e)
      T[node](moved.kept_dofs[e.row()] % 3, row % 3) = e.value();
  }
  for (int i = 0; i < surface.node_count(); ++i)
    if (!T[i].isZero(0)) unknowns.frames.put(surface.vertex[i], T[i]);
}

/// By w = v - v_prescribed - A_o w_o.
void put_followed(const ContactSurface& surface, const SurfaceTrace& trace,
                  const Flags& is_shared, VertexFrames<3>& frames) {
  const ContactTrace& moved = trace.trace;
  std::map<std::pair<int, int>, Matrix3d> B;
  for (Index k = count_of(trace.primary); k < moved.A.cols(); ++k)
    for (SparseMatrix::InnerIterator w(moved.to_kept, k); w; ++w) {
      const int dof = moved.kept_dofs[w.row()];
      for (SparseMatrix::InnerIterator e(moved.A, k); e; ++e) {
        const int row = static_cast<int>(e.row());
        if (is_shared[row / 3]) continue;
        const std::pair link(surface.vertex[row / 3], dof / 3);
        const auto known = B.try_emplace(link, Matrix3d::Zero()).first;
        known->second(row % 3, dof % 3) -= e.value() * w.value();
      }
    }
  for (const auto& [link, block] : B)
    if (!block.isZero(0)) frames.follow(link.first, link.second, block);
}

}  // namespace

bool faces_itself(const ContactSurface& surface, const SurfaceTrace& trace) {
  for (int k = 0; k < count_of(trace.primary); ++k)
    for (SparseMatrix::InnerIterator e(trace.trace.A, k); e; ++e)
      if (surface.vertex[e.row() / 3] != surface.vertex[trace.primary[k] / 3])
        return true;
  return false;
}

SurfaceUnknowns surface_unknowns(const ContactSurface& surface,
                                 const SurfaceTrace& trace,
                                 const CompliantLayer& layer,
                                 const ElasticSystem& system) {
  const VectorXd compliance =
      nodal_compliance(layer, surface.area, 3, trace.held);
  SurfaceUnknowns unknowns{
      VertexFrames<3>(system), VectorXi::Constant(3 * surface.node_count(), -1),
      compliance, shared_vertices(surface, trace, compliance, system)};
  Flags is_shared;
  put_shared(surface, unknowns, is_shared);
  put_frames(surface, trace, is_shared, unknowns);
  put_followed(surface, trace, is_shared, unknowns.frames);
  return unknowns;
}

}  // namespace ffcontact
