// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/cone_correction.hpp"
#include "ffcontact/contact/law/multiplier_projection.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
//
#include "freefem/guard.hpp"
#include "freefem/views.hpp"
#include "problem/contact_type.hpp"
#include "problem/systems.hpp"
#include "registration.hpp"

namespace ffcontact::plugin {

namespace {

/// The contact and two arrays pn, pt: what contactproject and conecorrection take.
ArrayOfaType contact_and_pressures() {
  return ArrayOfaType(atype<ContactVariable*>(), atype<KN<double>*>(),
                      atype<KN<double>*>());
}

/// nodes outside = contactproject(C, pn, pt, multiplier=, g=, ...): pn and pt are
/// projected in place; empty arrays become zeros, one value a node.
class ContactProject : public E_F0mps {
 public:
  using Result = long;

  explicit ContactProject(const basicAC_F0& arguments)
      : named_(arguments, {{"multiplier", &typeid(string*)},
                           {"g", &typeid(KN<double>*)},
                           {"verbosity", &typeid(long)}}),
        contact_(to<ContactVariable*>(arguments[0])),
        normal_(to<KN<double>*>(arguments[1])),
        tangential_(to<KN<double>*>(arguments[2])) {}

  static ArrayOfaType typeargs() { return contact_and_pressures(); }
  static E_F0* f(const basicAC_F0& arguments) {
    return new ContactProject(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("contactproject", [&] { return SetAny<long>(run(stack)); });
  }

 private:
  long run(Stack stack) const {
    const ContactProblem<2>& problem = *stated_contact(stack, contact_).problem;
    ContactLaw<2> law = problem.law;
    law.multiplier = multiplier_of(stack, named_);
    KN<double>*pn = value_of<KN<double>*>(stack, normal_),
    *pt = value_of<KN<double>*>(stack, tangential_);
    const int nodes = problem.contact.node_count();
    const Matrix2Xd pressure = pn->N() == 0 && pt->N() == 0
                                   ? Matrix2Xd(Matrix2Xd::Zero(2, nodes))
                                   : pressures_of(problem, pn, pt);
    const Expression g = named_.expression("g");
    const VectorXd given =
        g ? VectorXd(vector_of(value_of<KN<double>*>(stack, g))) : VectorXd();
    const MultiplierProjection projection =
        projected_multipliers(problem.contact, law, pressure, given);

    pn->resize(nodes);
    pt->resize(nodes);
    vector_of(pn) = projection.pressure.row(0);
    vector_of(pt) = projection.pressure.row(1);
    if (named_.verbosity_level(stack) > 0 && mpirank == 0)
      cout << "contactproject: " << nodes << " nodes, " << projection.outside
           << " were outside" << endl;
    return projection.outside;
  }

  NamedArguments named_;
  Expression contact_, normal_, tangential_;
};

/// edges that (4.1) cannot mend = conecorrection(C, pn, pt, ...)
class ConeCorrectionFunction : public E_F0mps {
 public:
  using Result = long;

  explicit ConeCorrectionFunction(const basicAC_F0& arguments)
      : named_(arguments, {{"multiplier", &typeid(string*)},
                           {"A", &typeid(Matrice_Creuse<double>*)},
                           {"verbosity", &typeid(long)},
                           {"rn", &typeid(KN<double>*)},
                           {"rt", &typeid(KN<double>*)},
                           {"shift", &typeid(KN<double>*)},
                           {"corrected", &typeid(long*)},
                           {"cone", &typeid(double*)}}),
        contact_(to<ContactVariable*>(arguments[0])),
        normal_(to<KN<double>*>(arguments[1])),
        tangential_(to<KN<double>*>(arguments[2])) {}

  static ArrayOfaType typeargs() { return contact_and_pressures(); }
  static E_F0* f(const basicAC_F0& arguments) {
    return new ConeCorrectionFunction(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("conecorrection", [&] { return SetAny<long>(run(stack)); });
  }

 private:
  long run(Stack stack) const {
    const Contact& contact = stated_contact(stack, contact_);
    const ContactProblem<2>& problem = *contact.problem;
    if (problem.law.has_bonded())
      refuse(
          "bonded bodies have no friction cone, so that there is nothing to "
          "correct: take pn and pt as they are");
    const Matrix2Xd given =
        pressures_of(problem, value_of<KN<double>*>(stack, normal_),
                     value_of<KN<double>*>(stack, tangential_));
    const Matrix2Xd density =
        multiplier_density(problem.contact, multiplier_of(stack, named_),
                           prescribed(stack, contact), given);
    const ConeCorrection correction = correct_to_cone(
        problem.contact, problem.law, edge_densities(problem.contact, density));
    const double cone =
        cone_defect(problem.contact, problem.law, correction.densities);
    const auto unmended = static_cast<long>(correction.uncorrected.size());
    named_.put(stack, "rn", correction.densities.normal.reshaped());
    named_.put(stack, "rt", correction.densities.tangential.reshaped());
    named_.put(stack, "shift", correction.shift);
    named_.put(stack, "corrected",
               static_cast<long>(correction.corrected_count()));
    named_.put(stack, "cone", cone);
    if (named_.verbosity_level(stack) > 0 && mpirank == 0)
      cout << "conecorrection: " << problem.contact.edge_count() << " edges, "
           << correction.corrected_count() << " corrected, " << unmended
           << " unmended, cone defect " << cone << endl;
    return unmended;
  }

  /// The prescribed dofs of A=, of the matrix that the contact was solved with, or none.
  Flags prescribed(Stack stack, const Contact& contact) const {
    const ContactProblem<2>& problem = *contact.problem;
    const Expression A = named_.expression("A");
    if (!A && contact.solved) return contact.solved->system->prescribed;
    if (!A) return Flags(problem.dof_count(), 0);
    problem.require_bodies("A", 1);
    const RowMatrix matrix =
        matrix_of(value_of<Matrice_Creuse<double>*>(stack, A));
    problem.require_dofs("A", 0, matrix.rows());
    return prescribed_dofs(matrix);
  }

  NamedArguments named_;
  Expression contact_, normal_, tangential_;
};

}  // namespace

void register_multiplier_functions() {
  Global.Add("contactproject", "(", new OneOperatorCode<ContactProject>());
  Global.Add("conecorrection", "(",
             new OneOperatorCode<ConeCorrectionFunction>());
}

}  // namespace ffcontact::plugin
