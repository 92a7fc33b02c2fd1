// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
#include "ffcontact/estimate/estimate.hpp"
//
#include "contact_arguments.hpp"
#include "guard.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// eps = contacterror(Th, A, u, pn, pt, label=, friction=, lambda=, G=, traction=[Fx, Fy], eps=, ...)
class ContactErrorFunction : public E_F0mps {
 public:
  using Result = double;

  explicit ContactErrorFunction(const basicAC_F0& arguments)
      : named_(arguments, ContactArguments::table({{"lambda", &typeid(double)},
                                                   {"G", &typeid(double)},
                                                   {"traction", &typeid(E_Array)},
                                                   {"bodyforce", &typeid(E_Array)},
                                                   {"sweeps", &typeid(long)},
                                                   {"verbosity", &typeid(long)},
                                                   {"eps", &typeid(KN<double>*)},
                                                   {"e", &typeid(double*)},
                                                   {"elastic", &typeid(double*)},
                                                   {"contact", &typeid(double*)},
                                                   {"history", &typeid(KN<double>*)},
                                                   {"rn", &typeid(KN<double>*)},
                                                   {"rt", &typeid(KN<double>*)},
                                                   {"corrected", &typeid(long*)},
                                                   {"unmended", &typeid(long*)},
                                                   {"balance", &typeid(double*)},
                                                   {"cone", &typeid(double*)},
                                                   {"admissible", &typeid(bool*)}})),
        mesh_(to<pmesh>(arguments[0])),
        matrix_(to<Matrice_Creuse<double>*>(arguments[1])),
        displacement_(to<KN<double>*>(arguments[2])),
        normal_(to<KN<double>*>(arguments[3])),
        tangential_(to<KN<double>*>(arguments[4])) {
    for (int c = 0; c < 2; ++c) {
      traction_[c] = named_.component("traction", c, 2);
      body_force_[c] = named_.component("bodyforce", c, 2);
    }
  }

  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<pmesh>(), atype<Matrice_Creuse<double>*>(), atype<KN<double>*>(), atype<KN<double>*>(),
                        atype<KN<double>*>());
  }
  static E_F0* f(const basicAC_F0& arguments) { return new ContactErrorFunction(arguments); }

  AnyType operator()(Stack stack) const override {
    return guarded("contacterror", [&] { return SetAny<double>(run(stack)); });
  }

 private:
  double run(Stack stack) const {
    const double start = CPUtime();
    const pmesh fem_mesh = GetAny<pmesh>((*mesh_)(stack));
    const ContactArguments contact(stack, named_, fem_mesh);
    EstimateSettings settings;
    settings.sweeps = static_cast<int>(named_.integer(stack, "sweeps", settings.sweeps));
    const Estimate estimate =
        estimate_error(contact.mesh, contact.edges, contact.line, solved_body(stack, contact, *fem_mesh), settings);
    put(stack, estimate);
    report(stack, contact, estimate, CPUtime() - start);
    return estimate.relative;
  }

  SolvedBody solved_body(Stack stack, const ContactArguments& contact, const Fem2D::Mesh& fem_mesh) const {
    KN<double>* u = GetAny<KN<double>*>((*displacement_)(stack));
    const RowMatrix A = matrix_of(GetAny<Matrice_Creuse<double>*>((*matrix_)(stack)));
    contact.require_dofs("A", A.rows());
    contact.require_dofs("u", u->N());

    SolvedBody body;
    body.hooke = hooke(stack, fem_mesh);
    body.prescribed = prescribed_dofs(A);
    body.displacement = vector_of(u);
    body.pressure = contact.pressures(GetAny<KN<double>*>((*normal_)(stack)), GetAny<KN<double>*>((*tangential_)(stack)));
    body.law = contact.law;
    body.neumann = traction_moments(stack, traction_[0], traction_[1], fem_mesh, contact.mesh);
    body.body_force.resize(2, contact.mesh.triangle_count());
    for (int c = 0; c < 2; ++c) body.body_force.row(c) = at_triangles(stack, body_force_[c], fem_mesh, 0).transpose();
    return body;
  }

  Hooke hooke(Stack stack, const Fem2D::Mesh& fem_mesh) const {
    if (!named_.given("lambda") || !named_.given("G")) refuse("lambda= and G= (Lame's constants) are needed");
    const Eigen::VectorXd lambda = at_triangles(stack, named_.expression("lambda"), fem_mesh, 0);
    const Eigen::VectorXd G = at_triangles(stack, named_.expression("G"), fem_mesh, 0);
    Hooke hooke;
    for (Eigen::Index t = 0; t < G.size(); ++t) hooke.push_back(isotropic(lambda[t], G[t]));
    return hooke;
  }

  void put(Stack stack, const Estimate& estimate) const {
    named_.put(stack, "eps", estimate.local);
    named_.put(stack, "e", estimate.e);
    named_.put(stack, "elastic", estimate.elastic);
    named_.put(stack, "contact", estimate.contact);
    named_.put(stack, "history", Eigen::Map<const Eigen::VectorXd>(estimate.history.data(), estimate.history.size()));
    named_.put(stack, "rn", estimate.tractions.densities.normal.reshaped());
    named_.put(stack, "rt", estimate.tractions.densities.tangential.reshaped());
    named_.put(stack, "corrected", static_cast<long>(estimate.tractions.corrected_count()));
    named_.put(stack, "unmended", static_cast<long>(estimate.tractions.uncorrected.size()));
    named_.put(stack, "balance", estimate.equilibrium.largest());
    named_.put(stack, "cone", estimate.cone);
    named_.put(stack, "admissible", estimate.admissible);
  }

  void report(Stack stack, const ContactArguments& contact, const Estimate& estimate, double seconds) const {
    const long level = named_.verbosity_level(stack);
    if (level < 1 || mpirank != 0) return;
    cout << "contacterror: " << contact.mesh.triangle_count() << " triangles, eps " << 100 * estimate.relative << " %, e "
         << estimate.e << ", " << estimate.tractions.corrected_count() << " edges corrected, "
         << estimate.tractions.uncorrected.size() << " unmended, " << seconds << " s" << endl;
    if (!estimate.admissible) cout << "contacterror: not admissible: " << estimate.reason << endl;
    if (level > 1)
      cout << "contacterror: elastic part " << estimate.elastic << ", contact part of e^2 " << estimate.contact
           << ", equilibrium defect " << estimate.equilibrium.largest() << ", cone defect " << estimate.cone << endl;
  }

  NamedArguments named_;
  Expression mesh_, matrix_, displacement_, normal_, tangential_;
  Expression traction_[2], body_force_[2];
};

}  // namespace

void register_estimate_functions() { Global.Add("contacterror", "(", new OneOperatorCode<ContactErrorFunction>()); }

}  // namespace ffcontact::plugin
