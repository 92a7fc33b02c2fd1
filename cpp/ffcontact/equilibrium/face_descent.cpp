// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/face_descent.hpp"

#include <Eigen/LU>

#include "ffcontact/base/parted_sum.hpp"

namespace ffcontact {

FaceLoads difference_loads(const FaceSetting& setting,
                           const FaceMoments& moments, int cell) {
  const auto& [mesh, faces, edges, stars] = setting.topology;
  FaceLoads loads = loads_of(mesh, faces, moments, cell);
  const TetrahedronCorners vectors = face_vectors(corners_of(mesh, cell));
  for (int k = 0; k < 4; ++k) {
    const Vector3d third =
        traction(setting.stress.col(cell), vectors.col(k)) / 3;
    loads.middleCols<3>(3 * k).colwise() -= third;
  }
  return loads;
}

SolidStress difference_stress(const FaceSetting& setting,
                              const FaceMoments& moments, int cell) {
  return composite_stress(corners_of(setting.topology.mesh, cell),
                          difference_loads(setting, moments, cell),
                          setting.body_loads.col(cell).reshaped(3, 4));
}

FaceDescent::FaceDescent(const FaceSetting& setting, const FaceMoments& moments,
                         const FaceShare& share, const FaceExchange& exchange)
    : setting_(setting),
      share_(share),
      exchange_(exchange),
      forms_(setting.topology, setting.hooke),
      stars_(setting.topology, share, setting.boundary, forms_),
      corrections_(Matrix9Xd::Zero(9, moments.cols())),
      residual_(9, moments.cols()),
      direction_(9, moments.cols()),
      next_(9, moments.cols()),
      images_(36, setting.topology.mesh.cell_count()),
      image_(9, moments.cols()) {
  const SolidTopology& topology = setting.topology;
  const int cells = topology.mesh.cell_count();
  VectorXd squares = VectorXd::Zero(cells);
#pragma omp parallel for
  for (int t = 0; t < cells; ++t) {
    if (!share.cell[t]) continue;
    const TetrahedronCorners corners = corners_of(topology.mesh, t);
    const Matrix6d compliance = setting.hooke[t].inverse();
    const SolidStress tau = difference_stress(setting, moments, t);
    squares[t] = energy(corners, compliance, tau);
    images_.col(t) =
        -face_slope(corners, compliance, tau, wrench_bases(topology, t));
  }
  of_share_ = parted_sum(cells, [&](int t) { return squares[t]; });
}

double FaceDescent::begin() {
  exchange_.complete(images_);
  gather(residual_);
  return exchange_.sum(of_share_);
}

/// y = sum of what the tetrahedra beside each face have for it in images_.
void FaceDescent::gather(Matrix9Xd& y) const {
  const Facets<3>& faces = setting_.topology.faces;
#pragma omp parallel for
  for (int f = 0; f < faces.count(); ++f) {
    Vector9d sum = Vector9d::Zero();
    for (int t : faces.cells.col(f))
      for (int k = 0; k < 4 && t >= 0; ++k)
        if (faces.of_cell(k, t) == f) sum += images_.col(t).segment<9>(9 * k);
    y.col(f) = sum;
  }
}

double FaceDescent::dot(const Matrix9Xd& a, const Matrix9Xd& b) const {
  return exchange_.sum(parted_sum(static_cast<int>(a.cols()), [&](int f) {
    return share_.counted[f] ? a.col(f).dot(b.col(f)) : 0;
  }));
}

void FaceDescent::add(double factor, const Matrix9Xd& y, Matrix9Xd& x) const {
#pragma omp parallel for
  for (Index f = 0; f < x.cols(); ++f) x.col(f) += factor * y.col(f);
}

void FaceDescent::turn_direction() {
  stars_(residual_, next_);
  if (square_ > 0) add(-dot(next_, image_) / square_, direction_, next_);
  direction_.swap(next_);

  const SolidTopology& topology = setting_.topology;
#pragma omp parallel for
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    if (share_.cell[t])
      images_.col(t) =
          forms_.times(t, unknowns_at(topology.faces, direction_, t));
  exchange_.complete(images_);
  gather(image_);
  square_ = dot(direction_, image_);
}

double FaceDescent::step() {
  turn_direction();
  if (!(square_ > 0)) return 0;
  const double slope = dot(residual_, direction_), length = slope / square_;
  add(length, direction_, corrections_);
  add(-length, image_, residual_);
  return length * slope;
}

void add_corrections(const FaceSetting& setting, const Matrix9Xd& corrections,
                     FaceMoments& moments) {
  const SolidMesh& mesh = setting.topology.mesh;
  const Facets<3>& faces = setting.topology.faces;
  const KnownComponents known =
      without_contact(setting.boundary.known, setting.contact);
#pragma omp parallel for
  for (int f = 0; f < faces.count(); ++f) {
    const Matrix3d corners = facet_points<3>(mesh, faces.vertices.col(f));
    const Vector9d added = wrench_basis(corners) * corrections.col(f);
    for (int row = 0; row < 9; ++row)
      if (!known(row % 3, f)) moments(row, f) += added[row];
  }
}

}  // namespace ffcontact
