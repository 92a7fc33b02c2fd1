// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_descent.hpp"

#include "ffcontact/base/parted_sum.hpp"

namespace ffcontact {

namespace {

/// x + factor y, in place.
void add(double factor, const VectorXd& y, VectorXd& x) {
#pragma omp parallel for
  for (Index i = 0; i < x.size(); ++i) x[i] += factor * y[i];
}

/// The local number of an edge in one of its triangles.
int local_edge(const Edges& edges, int edge, int triangle) {
  const auto of_triangle = edges.of_cell.col(triangle);
  return of_triangle[0] == edge ? 0 : of_triangle[1] == edge ? 1 : 2;
}

}  // namespace

template <class OfTriangle>
void StarDescent::gather(double factor, const OfTriangle& of_triangle,
                         VectorXd& y) const {
  const AirySpace& space = setting_.space;
  const Stars& stars = setting_.stars;
#pragma omp parallel for
  for (int v = 0; v < space.mesh.vertex_count(); ++v) {
    Vector3d sum = Vector3d::Zero();
    for (int k = stars.triangle_start[v]; k < stars.triangle_start[v + 1]; ++k)
      sum += of_triangle(stars.triangle[k]).at_vertices.col(stars.local[k]);
    y.segment<3>(space.of_vertex(v)) += factor * sum;
  }
#pragma omp parallel for
  for (int e = 0; e < space.edges.count(); ++e) {
    double sum = 0;
    for (int t : space.edges.cells.col(e))
      if (t >= 0) sum += of_triangle(t).on_edges[local_edge(space.edges, e, t)];
    y[space.of_edge(e)] += factor * sum;
  }
}

template <class OfTriangle>
double StarDescent::sum(const OfTriangle& of_triangle) const {
  return parted_sum(setting_.space.mesh.cell_count(), of_triangle);
}

StarDescent::StarDescent(const StarSetting& setting)
    : setting_(setting),
      solves_(setting),
      airy_(VectorXd::Zero(setting.space.unknowns())),
      residual_(airy_),
      // Not a vector, which would be filled with zeros by one thread first.
      image_(new LocalAiry[setting.space.mesh.cell_count()]) {
  const auto slope = [&](int t) -> const LocalAiry& {
    return setting.energies[t].slope;
  };
  gather(-1, slope, residual_);
}

double StarDescent::product_with_image(const VectorXd& z) const {
  return sum(
      [&](int t) { return dot(local_airy(setting_.space, z, t), image_[t]); });
}

void StarDescent::turn_direction() {
  VectorXd z = solves_(residual_);
  if (square_ > 0) {
    const double product = product_with_image(z);
    add(-product / square_, direction_, z);
  }
  direction_ = std::move(z);
}

double StarDescent::square_of_direction() {
  return sum([&](int t) {
    const LocalAiry p = local_airy(setting_.space, direction_, t);
    image_[t] = setting_.energies[t].times(p);
    return dot(p, image_[t]);
  });
}

double StarDescent::step() {
  turn_direction();
  square_ = square_of_direction();
  const double slope = residual_.dot(direction_);
  if (!(square_ > 0) || !(slope > 0)) {
    square_ = 0;
    return 0;
  }
  const double length = slope / square_;
  add(length, direction_, airy_);
  gather(
      -length, [&](int t) -> const LocalAiry& { return image_[t]; }, residual_);
  return length * slope;
}

void StarDescent::note(int triangle, const LocalAiry& added) {
  const AirySpace& space = setting_.space;
  const LocalAiry image = setting_.energies[triangle].times(added);
  for (int r = 0; r < 3; ++r) {
    const int v = space.mesh.cells(r, triangle),
              e = space.edges.of_cell(r, triangle);
    residual_.segment<3>(space.of_vertex(v)) -= image.at_vertices.col(r);
    residual_[space.of_edge(e)] -= image.on_edges[r];
  }
}

double StarDescent::changed(const std::set<int>& triangles,
                            const std::function<double(VectorXd&)>& change) {
  const AirySpace& space = setting_.space;
  std::vector<LocalAiry> before;
  for (int t : triangles) before.push_back(local_airy(space, airy_, t));
  const double result = change(airy_);
  auto old = before.begin();
  for (int t : triangles) {
    LocalAiry added = local_airy(space, airy_, t);
    added.at_vertices -= old->at_vertices;
    added.on_edges -= old++->on_edges;
    note(t, added);
  }
  return result;
}

}  // namespace ffcontact
