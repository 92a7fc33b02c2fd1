// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/sizing/local_rates.hpp"
//
#include "contact_arguments.hpp"
#include "guard.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// Sweeps at most when the script asks for a tightness and not for a number of sweeps.
constexpr int most_sweeps = 20;

/// eps = contacterror(Th, A, u, pn, pt, label=, friction=, lambda=, G=, traction=[Fx, Fy], eps=, ...)
class ContactErrorFunction : public E_F0mps {
 public:
  using Result = double;

  explicit ContactErrorFunction(const basicAC_F0& arguments)
      : named_(arguments,
               ContactArguments::table(
                   {{"lambda", &typeid(double)},    {"G", &typeid(double)},          {"hooke", &typeid(E_Array)},
                    {"traction", &typeid(E_Array)}, {"bodyforce", &typeid(E_Array)}, {"tractions", &typeid(string*)},
                    {"sweeps", &typeid(long)},      {"tightness", &typeid(double)},  {"verbosity", &typeid(long)},
                    {"eps", &typeid(KN<double>*)},  {"rate", &typeid(KN<double>*)},  {"e", &typeid(double*)},
                    {"elastic", &typeid(double*)},  {"contact", &typeid(double*)},   {"history", &typeid(KN<double>*)},
                    {"rn", &typeid(KN<double>*)},   {"rt", &typeid(KN<double>*)},    {"corrected", &typeid(long*)},
                    {"mended", &typeid(long*)},     {"unmended", &typeid(long*)},    {"oscillation", &typeid(double*)},
                    {"sxx", &typeid(KN<double>*)},  {"syy", &typeid(KN<double>*)},   {"sxy", &typeid(KN<double>*)},
                    {"balance", &typeid(double*)},  {"cone", &typeid(double*)},      {"admissible", &typeid(bool*)}})),
        mesh_(to<pmesh>(arguments[0])),
        matrix_(to<Matrice_Creuse<double>*>(arguments[1])),
        displacement_(to<KN<double>*>(arguments[2])),
        normal_(to<KN<double>*>(arguments[3])),
        tangential_(to<KN<double>*>(arguments[4])) {
    for (int c = 0; c < 2; ++c) {
      traction_[c] = named_.component("traction", c, 2);
      body_force_[c] = named_.component("bodyforce", c, 2);
    }
    for (int c = 0; c < 6; ++c) hooke_[c] = named_.component("hooke", c, 6);
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
    const EstimateSettings settings = estimate_settings(stack);
    const RowMatrix A = matrix_of(GetAny<Matrice_Creuse<double>*>((*matrix_)(stack)));
    contact.require_dofs("A", A.rows());
    const BodyForce force = body_force_loads(stack, body_force_[0], body_force_[1], *fem_mesh, contact.mesh);
    const ElasticSystem system = elastic_system(A, Eigen::VectorXd::Zero(A.rows()));
    const SolvedBody body = solved_body(stack, contact, *fem_mesh, force.loads);
    const Estimate estimate = estimate_error(contact.mesh, contact.edges, contact.line, system, body, settings);
    put(stack, estimate);
    if (named_.given("rate")) named_.put(stack, "rate", rates(contact, system, body, estimate));
    named_.put(stack, "oscillation", force.oscillation);
    report(stack, contact, estimate, CPUtime() - start);
    return estimate.relative;
  }

  EstimateSettings estimate_settings(Stack stack) const {
    EstimateSettings settings;
    const std::string tractions = named_.text(stack, "tractions", "free");
    if (tractions == "fixed")
      settings.tractions = Tractions::fixed;
    else if (tractions == "published")
      settings.tractions = Tractions::published;
    else if (tractions != "free")
      refuse("tractions must be \"free\", \"fixed\" or \"published\", got \"", tractions, "\"");
    RelaxationSettings& relaxation = settings.relaxation;
    relaxation.tightness = named_.number(stack, "tightness", relaxation.tightness);
    const int sweeps = relaxation.tightness > 0 ? most_sweeps : relaxation.sweeps;
    relaxation.sweeps = static_cast<int>(named_.integer(stack, "sweeps", sweeps));
    return settings;
  }

  SolvedBody solved_body(Stack stack, const ContactArguments& contact, const Fem2D::Mesh& fem_mesh,
                         const BodyLoadsOfAll& body_loads) const {
    KN<double>* u = GetAny<KN<double>*>((*displacement_)(stack));
    contact.require_dofs("u", u->N());
    SolvedBody body;
    body.hooke = hooke(stack, fem_mesh);
    body.displacement = vector_of(u);
    body.pressure =
        contact.pressures(GetAny<KN<double>*>((*normal_)(stack)), GetAny<KN<double>*>((*tangential_)(stack)));
    body.law = contact.law;
    body.neumann = traction_moments(stack, traction_[0], traction_[1], fem_mesh, contact.mesh);
    body.body_loads = body_loads;
    return body;
  }

  Hooke hooke(Stack stack, const Fem2D::Mesh& fem_mesh) const {
    const bool lame = named_.given("lambda") && named_.given("G");
    if (lame == named_.given("hooke"))
      refuse("give either lambda= and G= (Lame's constants) or hooke=[C11, C12, C13, C22, C23, C33]");
    Hooke hooke(fem_mesh.nt);
    if (lame) {
      const Eigen::VectorXd lambda = at_triangles(stack, named_.expression("lambda"), fem_mesh, 0);
      const Eigen::VectorXd G = at_triangles(stack, named_.expression("G"), fem_mesh, 0);
      for (Eigen::Index t = 0; t < G.size(); ++t) hooke[t] = isotropic(lambda[t], G[t]);
      return hooke;
    }
    constexpr int row[] = {0, 0, 0, 1, 1, 2}, column[] = {0, 1, 2, 1, 2, 2};
    for (int c = 0; c < 6; ++c) {
      const Eigen::VectorXd values = at_triangles(stack, hooke_[c], fem_mesh, 0);
      for (Eigen::Index t = 0; t < values.size(); ++t)
        hooke[t](row[c], column[c]) = hooke[t](column[c], row[c]) = values[t];
    }
    return hooke;
  }

  static Eigen::VectorXd rates(const ContactArguments& contact, const ElasticSystem& system, const SolvedBody& body,
                               const Estimate& estimate) {
    const Stars stars = stars_of(contact.mesh, contact.edges);
    const BoundaryTractions boundary = boundary_tractions(contact.mesh, contact.edges, system.prescribed, body.neumann,
                                                          contact.line, estimate.tractions);
    return local_rates(contact.mesh, stars,
                       singular_vertices(contact.mesh, contact.edges, stars, body.hooke,
                                         stresses(contact.mesh, body.hooke, body.displacement), boundary,
                                         contact_edge_numbers(contact.line, contact.edges)));
  }

  /// One stress component as a P1dc array on splitmesh3(Th), whose triangle 3 t + k is triangle t with vertex k moved to the
  /// centroid. FreeFEM keeps P1dc values at the vertices shrunk by 1 % towards the triangle's centroid.
  static Eigen::VectorXd stress_component(const Estimate& estimate, int component) {
    constexpr double shrink = 0.01;
    Eigen::VectorXd values(9 * static_cast<Eigen::Index>(estimate.stress.size()));
    for (std::size_t t = 0; t < estimate.stress.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d corners =
            estimate.stress[t].block<1, 3>(component, 3 * k).transpose();  // k+1, k+2, centroid
        for (int c = 0; c < 3; ++c) {
          const int vertex = (k + 1 + c) % 3;
          values[9 * static_cast<Eigen::Index>(t) + 3 * k + vertex] =
              (1 - shrink) * corners[c] + shrink * corners.mean();
        }
      }
    return values;
  }

  void put(Stack stack, const Estimate& estimate) const {
    named_.put(stack, "eps", estimate.local);
    named_.put(stack, "e", estimate.e);
    named_.put(stack, "elastic", estimate.elastic);
    named_.put(stack, "contact", estimate.contact);
    named_.put(stack, "history", Eigen::Map<const Eigen::VectorXd>(estimate.history.data(), estimate.history.size()));
    named_.put(stack, "rn", estimate.tractions.normal.reshaped());
    named_.put(stack, "rt", estimate.tractions.tangential.reshaped());
    named_.put(stack, "corrected", static_cast<long>(estimate.corrected_count()));
    named_.put(stack, "mended", static_cast<long>(estimate.mended.size()));
    named_.put(stack, "unmended", static_cast<long>(estimate.unmended.size()));
    if (named_.given("sxx")) named_.put(stack, "sxx", stress_component(estimate, 0));
    if (named_.given("syy")) named_.put(stack, "syy", stress_component(estimate, 1));
    if (named_.given("sxy")) named_.put(stack, "sxy", stress_component(estimate, 2));
    named_.put(stack, "balance", estimate.equilibrium.largest());
    named_.put(stack, "cone", estimate.cone);
    named_.put(stack, "admissible", estimate.admissible);
  }

  void report(Stack stack, const ContactArguments& contact, const Estimate& estimate, double seconds) const {
    const long level = named_.verbosity_level(stack);
    if (level < 1 || mpirank != 0) return;
    cout << "contacterror: " << contact.mesh.triangle_count() << " triangles, eps " << 100 * estimate.relative
         << " %, e " << estimate.e << ", " << estimate.corrected_count() << " edges corrected, "
         << estimate.mended.size() << " mended, " << seconds << " s" << endl;
    if (!estimate.admissible) cout << "contacterror: not admissible: " << estimate.reason << endl;
    if (level > 1)
      cout << "contacterror: elastic part " << estimate.elastic << ", contact part of e^2 " << estimate.contact
           << ", equilibrium defect " << estimate.equilibrium.largest() << ", cone defect " << estimate.cone << endl;
  }

  NamedArguments named_;
  Expression mesh_, matrix_, displacement_, normal_, tangential_;
  Expression traction_[2], body_force_[2], hooke_[6];
};

}  // namespace

void register_estimate_functions() { Global.Add("contacterror", "(", new OneOperatorCode<ContactErrorFunction>()); }

}  // namespace ffcontact::plugin
