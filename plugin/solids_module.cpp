// SPDX-License-Identifier: GPL-3.0-or-later
// The module ffcontact_solids.
#include "ffcontact/mesh/cell_quality.hpp"
#include "ffcontact/mesh/ridges.hpp"
#include "ffcontact/sizing/cell_shape.hpp"
//
#include "estimate/bounds_call.hpp"
#include "estimate/material_and_loads.hpp"
#include "freefem/new_mesh.hpp"
#include "freefem/read_mesh.hpp"
#include "gmsh/gmsh_program.hpp"
#include "gmsh/solid_remesh.hpp"
#include "parallel/shared_error.hpp"
#include "parallel/shared_solve.hpp"
#include "parallel/shared_statement.hpp"
#include "pictures/solid_picture_files.hpp"
#include "solids.hpp"
#include "solve/contact_solve.hpp"

namespace ffcontact::plugin {

namespace {

template <int dim>
ContactStatement statement_of(SharedStatement<dim> shared) {
  ContactStatement statement;
  if constexpr (dim == 2)
    statement.plane = std::move(shared.problem);
  else
    statement.solid = std::move(shared.problem);
  statement.shared = std::move(shared.contact);
  return statement;
}

template <int dim>
ContactStatement statement(Stack stack, const NamedArguments& named,
                           const FemMeshes<dim>& meshes) {
  if (const auto team = stated_team(stack, named))
    return statement_of(state_shared<dim>(stack, named, meshes, team));
  return statement_of<dim>(
      {std::make_shared<ContactProblem<dim>>(stack, named, meshes), nullptr});
}

Solid solid_of(pmesh3 Th) {
  Solid solid{mesh_of(Th), VectorXi(Th->nt)};
  for (int t = 0; t < Th->nt; ++t) solid.regions[t] = (*Th)[t].lab;
  return solid;
}

class SolidsModule : public Solids {
 public:
  ContactStatement stated(Stack stack, const NamedArguments& named,
                          const std::vector<pmesh3>& meshes) const override {
    return statement<3>(stack, named, meshes);
  }

  ContactStatement stated(Stack stack, const NamedArguments& named,
                          const std::vector<pmesh>& meshes) const override {
    return statement<2>(stack, named, meshes);
  }

  long solve(const SolveCall& call, Contact& contact) const override {
    return contact.shared ? solve_shared(call, contact)
                          : solve_here(call, *contact.solid);
  }

  double error(Stack stack, const NamedArguments& named, Contact& contact,
               const JudgePlane& judge) const override {
    const ReadBodies<2> plane = reader_of<2>(stack, named);
    const ReadBodies<3> read = reader_of<3>(stack, named);
    if (!contact.shared)
      return contact_error(stack, named, *contact.solid, read);
    SharedContact& shared = *contact.shared;
    if (shared.plane)
      return error_shared<2>(stack, named, shared, plane, judge);
    return error_shared<3>(stack, named, shared, read,
                           [&](const ReadBodies<3>& whole) {
                             return contact_error(stack, named, *contact.solid,
                                                  whole, relax_shared(shared));
                           });
  }

  double bounds(const BoundsCall& call,
                const ContactOf<3>& contact) const override {
    return solid_bounds(call, contact);
  }

  OptimalSize sizes(const ContactProblem<3>& problem,
                    const std::vector<VectorXd>& arrays,
                    const SizeSettings& settings) const override {
    return optimal_size(problem.mesh,
                        ridges_of(problem.mesh, problem.facets).vertices,
                        arrays[0], arrays[1], settings);
  }

  double sizes_of_parts(
      Stack stack, const NamedArguments& named, SharedContact& contact,
      const std::vector<VectorXd>& arrays,
      const std::function<double(const std::vector<VectorXd>&)>& sizes)
      const override {
    return sizes_shared(stack, named, contact, arrays, sizes);
  }

  void draw(const std::filesystem::path& folder, long step,
            const ContactOf<3>& contact) const override {
    const SolvedContact<3>& solved = solved_contact(contact);
    if (mpirank == 0) write_pictures(folder, step, *contact.problem, solved);
  }

  VectorXd quality(pmesh3 mesh) const override {
    return cell_quality(mesh_of(mesh));
  }
  VectorXd mean_edges(pmesh3 mesh) const override {
    return ffcontact::mean_edges(mesh_of(mesh));
  }

  pmesh3 remeshed(Stack stack, pmesh3 mesh, const Ref<const VectorXd>& size,
                  double corner) const override {
    const Solid fine = plugin::remeshed(solid_of(mesh), size, corner);
    return fem_mesh_of(stack, fine.mesh, fine.regions);
  }

  GmshMesh<3> gmsh_solid(const std::filesystem::path& file) const override {
    return plugin::gmsh_solid(file);
  }

  void use_processes(MakeProcesses make) const override {
    plugin::use_processes(make);
  }
};

}  // namespace

}  // namespace ffcontact::plugin

const ffcontact::plugin::Solids* ffcontact_solids() {
  static const ffcontact::plugin::SolidsModule module;
  return &module;
}
