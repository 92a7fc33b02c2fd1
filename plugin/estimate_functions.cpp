// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/estimate/stress_on_triangles.hpp"
#include "ffcontact/sizing/local_rates.hpp"
//
#include "contact_arguments.hpp"
#include "guard.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// Sweeps at most when the script asks for a tightness and not for a number of sweeps.
constexpr int most_sweeps = 20;

/// The components of one body's Hooke tensor, loads and body forces.
struct BodyExpressions {
  Expression traction[2], body_force[2], hooke[6];
};

/// eps = contacterror(Th, A, u, pn, pt, label=, friction=, lambda=, G=, traction=[Fx, Fy], eps=, ...), or with mesh, matrix and
/// displacement of each of several bodies.
template <int bodies>
class ContactErrorFunction : public E_F0mps {
 public:
  using Result = double;

  explicit ContactErrorFunction(const basicAC_F0& arguments) : named_(arguments, table()) {
    for (int k = 0; k < bodies; ++k) {
      mesh_.push_back(to<pmesh>(arguments[3 * k]));
      matrix_.push_back(to<Matrice_Creuse<double>*>(arguments[3 * k + 1]));
      displacement_.push_back(to<KN<double>*>(arguments[3 * k + 2]));
      for (int c = 0; c < 2; ++c) {
        body_[k].traction[c] = named_.component(name("traction", k), c, 2);
        body_[k].body_force[c] = named_.component(name("bodyforce", k), c, 2);
      }
      for (int c = 0; c < 6; ++c) body_[k].hooke[c] = named_.component(name("hooke", k), c, 6);
    }
    normal_ = to<KN<double>*>(arguments[3 * bodies]);
    tangential_ = to<KN<double>*>(arguments[3 * bodies + 1]);
  }

  static ArrayOfaType typeargs() {
    std::vector<aType> types;
    for (int k = 0; k < bodies; ++k)
      types.insert(types.end(), {atype<pmesh>(), atype<Matrice_Creuse<double>*>(), atype<KN<double>*>()});
    types.insert(types.end(), {atype<KN<double>*>(), atype<KN<double>*>()});
    return ArgumentTypes(types);
  }
  static E_F0* f(const basicAC_F0& arguments) { return new ContactErrorFunction(arguments); }

  AnyType operator()(Stack stack) const override {
    return guarded("contacterror", [&] { return SetAny<double>(run(stack)); });
  }

 private:
  static const char* name(const char* parameter, int body) { return name_of_body(parameter, body, bodies); }

  static NamedArguments::Table table() {
    NamedArguments::Table own = for_bodies({{"lambda", &typeid(double)},
                                            {"G", &typeid(double)},
                                            {"hooke", &typeid(E_Array)},
                                            {"traction", &typeid(E_Array)},
                                            {"bodyforce", &typeid(E_Array)},
                                            {"eps", &typeid(KN<double>*)},
                                            {"rate", &typeid(KN<double>*)},
                                            {"sxx", &typeid(KN<double>*)},
                                            {"syy", &typeid(KN<double>*)},
                                            {"sxy", &typeid(KN<double>*)}},
                                           bodies);
    own.insert(own.end(), {{"multiplier", &typeid(string*)},
                           {"tractions", &typeid(string*)},
                           {"construction", &typeid(string*)},
                           {"sweeps", &typeid(long)},
                           {"tightness", &typeid(double)},
                           {"verbosity", &typeid(long)},
                           {"e", &typeid(double*)},
                           {"elastic", &typeid(double*)},
                           {"contact", &typeid(double*)},
                           {"history", &typeid(KN<double>*)},
                           {"rn", &typeid(KN<double>*)},
                           {"rt", &typeid(KN<double>*)},
                           {"rabscissa", &typeid(KN<double>*)},
                           {"corrected", &typeid(long*)},
                           {"mended", &typeid(long*)},
                           {"unmended", &typeid(long*)},
                           {"oscillation", &typeid(double*)},
                           {"balance", &typeid(double*)},
                           {"cone", &typeid(double*)},
                           {"penetration", &typeid(double*)},
                           {"admissible", &typeid(bool*)}});
    return ContactArguments::table(own, bodies);
  }

  double run(Stack stack) const {
    const double start = CPUtime();
    const ContactArguments contact(stack, named_, values_of<pmesh, const Fem2D::Mesh*>(stack, mesh_));
    const EstimateSettings settings = estimate_settings(stack);
    std::vector<ElasticSystem> systems;
    for (int k = 0; k < bodies; ++k) {
      const RowMatrix A = matrix_of(value_of<Matrice_Creuse<double>*>(stack, matrix_[k]));
      contact.require_dofs("A", k, A.rows());
      systems.push_back(elastic_system(A, Eigen::VectorXd::Zero(A.rows())));
    }
    const ElasticSystem system = bodies == 1 ? std::move(systems.front()) : joined_systems(systems);
    double oscillation = 0;
    const SolvedBody body = solved_body(stack, contact, system.prescribed, oscillation);
    const Estimate estimate = estimate_error(contact.mesh, contact.edges, contact.line, system, body, settings);
    put(stack, contact, estimate);
    put_rates(stack, contact, system, body);
    named_.put(stack, "oscillation", oscillation);
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
    const std::string construction = named_.text(stack, "construction", "composite");
    if (construction == "polynomial")
      settings.construction = Construction::polynomial;
    else if (construction != "composite")
      refuse("construction must be \"composite\" or \"polynomial\", got \"", construction, "\"");
    RelaxationSettings& relaxation = settings.relaxation;
    relaxation.tightness = named_.number(stack, "tightness", relaxation.tightness);
    const int sweeps = relaxation.tightness > 0 ? most_sweeps : relaxation.sweeps;
    relaxation.sweeps = static_cast<int>(named_.integer(stack, "sweeps", sweeps));
    return settings;
  }

  SolvedBody solved_body(Stack stack, const ContactArguments& contact, const std::vector<char>& prescribed,
                         double& oscillation) const {
    const JoinedMesh& joined = contact.joined;
    SolvedBody body;
    body.displacement.resize(contact.first_dof(bodies));
    body.neumann.resize(4, joined.first_boundary.back());
    body.body_loads.resize(6, joined.first_triangle.back());
    for (int k = 0; k < bodies; ++k) {
      const Fem2D::Mesh& fem_mesh = *contact.fem_meshes[k];
      KN<double>* u = value_of<KN<double>*>(stack, displacement_[k]);
      contact.require_dofs("u", k, u->N());
      body.displacement.segment(contact.first_dof(k), contact.dof_count(k)) = vector_of(u);
      add_hooke(stack, k, fem_mesh, body.hooke);
      const Mesh mesh = mesh_of(&fem_mesh);
      body.neumann.middleCols(joined.first_boundary[k], mesh.boundary.cols()) =
          traction_moments(stack, body_[k].traction[0], body_[k].traction[1], fem_mesh, mesh);
      const BodyForce force = body_force_loads(stack, body_[k].body_force[0], body_[k].body_force[1], fem_mesh, mesh);
      body.body_loads.middleCols(joined.first_triangle[k], mesh.triangles.cols()) = force.loads;
      oscillation = std::hypot(oscillation, force.oscillation);
    }
    body.law = contact.law;
    body.law.multiplier = multiplier_of(stack, named_);
    body.pressure = multiplier_density(
        contact.line, body.law.multiplier, prescribed,
        contact.pressures(value_of<KN<double>*>(stack, normal_), value_of<KN<double>*>(stack, tangential_)));
    return body;
  }

  /// Appends the tensors of one body's triangles.
  void add_hooke(Stack stack, int body, const Fem2D::Mesh& fem_mesh, Hooke& all) const {
    const Expression lambda = named_.expression(name("lambda", body)), G = named_.expression(name("G", body));
    const bool lame = lambda && G;
    if (lame == named_.given(name("hooke", body)))
      refuse("give either ", name("lambda", body), "= and ", name("G", body), "= (Lame's constants) or ",
             name("hooke", body), "=[C11, C12, C13, C22, C23, C33]");
    Hooke hooke(fem_mesh.nt);
    if (lame) {
      const Eigen::VectorXd lambdas = at_triangles(stack, lambda, fem_mesh, 0);
      const Eigen::VectorXd Gs = at_triangles(stack, G, fem_mesh, 0);
      for (Eigen::Index t = 0; t < Gs.size(); ++t) hooke[t] = isotropic(lambdas[t], Gs[t]);
    } else {
      constexpr int row[] = {0, 0, 0, 1, 1, 2}, column[] = {0, 1, 2, 1, 2, 2};
      for (int c = 0; c < 6; ++c) {
        const Eigen::VectorXd values = at_triangles(stack, body_[body].hooke[c], fem_mesh, 0);
        for (Eigen::Index t = 0; t < values.size(); ++t)
          hooke[t](row[c], column[c]) = hooke[t](column[c], row[c]) = values[t];
      }
    }
    all.insert(all.end(), hooke.begin(), hooke.end());
  }

  void put_rates(Stack stack, const ContactArguments& contact, const ElasticSystem& system,
                 const SolvedBody& body) const {
    bool wanted = false;
    for (int k = 0; k < bodies; ++k) wanted = wanted || named_.given(name("rate", k));
    if (!wanted) return;
    const Stars stars = stars_of(contact.mesh, contact.edges);
    const BoundaryTractions boundary = boundary_tractions(contact.mesh, contact.edges, system.prescribed, body.neumann,
                                                          contact.line, edge_densities(contact.line, body.pressure));
    const std::vector<SingularVertex> singular = singular_vertices(
        contact.mesh, contact.edges, stars, body.hooke, stresses(contact.mesh, body.hooke, body.displacement), boundary,
        contact_edge_numbers(contact.line, contact.edges));
    put_by_triangles(stack, contact, "rate", local_rates(contact.mesh, stars, singular));
  }

  void put_by_triangles(Stack stack, const ContactArguments& contact, const char* parameter,
                        const Eigen::VectorXd& values) const {
    const std::vector<int>& first = contact.joined.first_triangle;
    for (int k = 0; k < bodies; ++k)
      named_.put(stack, name(parameter, k), values.segment(first[k], first[k + 1] - first[k]));
  }

  /// One stress component as a P1dc array on splitmesh3(Th), whose triangle 3 t + k is triangle t with vertex k moved to the
  /// centroid. FreeFEM keeps P1dc values at the vertices shrunk by 1 % towards the triangle's centroid.
  static Eigen::VectorXd stress_component(const std::vector<CompositeStress>& stress, int component) {
    constexpr double shrink = 0.01;
    Eigen::VectorXd values(9 * static_cast<Eigen::Index>(stress.size()));
    for (std::size_t t = 0; t < stress.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d corners = stress[t].block<1, 3>(component, 3 * k).transpose();  // k+1, k+2, centroid
        for (int c = 0; c < 3; ++c) {
          const int vertex = (k + 1 + c) % 3;
          values[9 * static_cast<Eigen::Index>(t) + 3 * k + vertex] =
              (1 - shrink) * corners[c] + shrink * corners.mean();
        }
      }
    return values;
  }

  void put_stress(Stack stack, const ContactArguments& contact, const Estimate& estimate) const {
    constexpr const char* parameter[] = {"sxx", "syy", "sxy"};
    bool wanted = false;
    for (const char* p : parameter)
      for (int k = 0; k < bodies; ++k) wanted = wanted || named_.given(name(p, k));
    if (!wanted) return;
    const std::vector<CompositeStress> stress = stress_on_triangles(contact.mesh, estimate);
    const std::vector<int>& first = contact.joined.first_triangle;
    for (int c = 0; c < 3; ++c) {
      const Eigen::VectorXd values = stress_component(stress, c);
      for (int k = 0; k < bodies; ++k)
        named_.put(stack, name(parameter[c], k), values.segment(9 * first[k], 9 * (first[k + 1] - first[k])));
    }
  }

  /// Abscissae of the ends of the edges on which r_hat is linear, two an edge.
  static Eigen::VectorXd abscissae(const ContactLine& line) {
    Eigen::VectorXd values(2 * line.edge_count());
    for (int e = 0; e < line.edge_count(); ++e) {
      values[2 * e] = line.abscissa[line.edge_node(0, e)];
      values[2 * e + 1] = values[2 * e] + line.length[e];
    }
    return values;
  }

  void put(Stack stack, const ContactArguments& contact, const Estimate& estimate) const {
    put_by_triangles(stack, contact, "eps", estimate.local);
    put_stress(stack, contact, estimate);
    named_.put(stack, "rabscissa", abscissae(estimate.refinement ? estimate.refinement->line : contact.line));
    named_.put(stack, "e", estimate.e);
    named_.put(stack, "elastic", estimate.elastic);
    named_.put(stack, "contact", estimate.contact);
    named_.put(stack, "history", Eigen::Map<const Eigen::VectorXd>(estimate.history.data(), estimate.history.size()));
    named_.put(stack, "rn", estimate.tractions.normal.reshaped());
    named_.put(stack, "rt", estimate.tractions.tangential.reshaped());
    named_.put(stack, "corrected", static_cast<long>(estimate.corrected_count()));
    named_.put(stack, "mended", static_cast<long>(estimate.mended.size()));
    named_.put(stack, "unmended", static_cast<long>(estimate.unmended.size()));
    named_.put(stack, "balance", estimate.equilibrium.largest());
    named_.put(stack, "cone", estimate.cone);
    named_.put(stack, "penetration", estimate.penetration);
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
           << ", equilibrium defect " << estimate.equilibrium.largest() << ", cone defect " << estimate.cone
           << ", penetration " << estimate.penetration << endl;
  }

  NamedArguments named_;
  std::vector<Expression> mesh_, matrix_, displacement_;
  Expression normal_, tangential_;
  BodyExpressions body_[bodies];
};

}  // namespace

void register_estimate_functions() {
  Global.Add("contacterror", "(", new OneOperatorCode<ContactErrorFunction<1>>());
  Global.Add("contacterror", "(", new OneOperatorCode<ContactErrorFunction<2>>());
  Global.Add("contacterror", "(", new OneOperatorCode<ContactErrorFunction<3>>());
}

}  // namespace ffcontact::plugin
