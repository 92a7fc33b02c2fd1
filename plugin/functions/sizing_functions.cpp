// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/appended.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/sizing/optimal_size.hpp"
//
#include "freefem/guard.hpp"
#include "freefem/views.hpp"
#include "parallel/shared_contact.hpp"
#include "problem/contact_type.hpp"
#include "registration.hpp"
#include "solids.hpp"

namespace ffcontact::plugin {

namespace {

/// What is given for each body.
const NamedArguments::Table sizes_of_bodies = {{"rate", &typeid(KN<double>*)},
                                               {"size", &typeid(KN<double>*)},
                                               {"ratio", &typeid(KN<double>*)}};

/// @throws std::invalid_argument  if eps is 0 where contacterror has not found that
template <int d>
void require_filled(const ContactOf<d>& contact, const VectorXd& eps) {
  if (!eps.isZero(0)) return;
  const auto& solved = contact.solved;
  if (!solved || !solved->estimate || solved->estimate->relative > 0)
    refuse(
        "eps is 0 everywhere: give the array that contacterror(C, ..., eps=) "
        "has filled");
}

/// predicted cells = optimalsize(C, eps, target=, size=, ...), with eps of each body:
/// one wanted error and one Lambda for all of them.
class OptimalSizeFunction : public E_F0mps {
 public:
  using Result = double;

  explicit OptimalSizeFunction(const basicAC_F0& arguments)
      : named_(arguments, table(arguments)),
        contact_(to<ContactVariable*>(arguments[0])) {
    for (int k = 1; k < arguments.size(); ++k)
      local_error_.push_back(to<KN<double>*>(arguments[k]));
  }

  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<ContactVariable*>(), atype<KN<double>*>(), true);
  }
  static E_F0* f(const basicAC_F0& arguments) {
    return new OptimalSizeFunction(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("optimalsize", [&] { return SetAny<double>(run(stack)); });
  }

 private:
  static NamedArguments::Table table(const basicAC_F0& arguments) {
    NamedArguments::Table table = for_bodies(sizes_of_bodies, arguments);
    table.insert(table.end(), {{"target", &typeid(double)},
                               {"part", &typeid(double)},
                               {"hmin", &typeid(double)},
                               {"hmax", &typeid(double)},
                               {"gradation", &typeid(double)},
                               {"largeststep", &typeid(double)},
                               {"verbosity", &typeid(long)},
                               {"wanted", &typeid(double*)},
                               {"predicted", &typeid(double*)},
                               {"spread", &typeid(double*)},
                               {"error", &typeid(double*)}});
    return table;
  }

  /// The given arrays of all bodies one after the other; none where the first is not
  /// given.
  static VectorXd joined(Stack stack, const std::vector<Expression>& arrays) {
    VectorXd values;
    for (Expression array : arrays) {
      if (!array) return {};
      append(vector_of(value_of<KN<double>*>(stack, array)), values);
    }
    return values;
  }

  SizeSettings settings(Stack stack) const {
    SizeSettings settings;
    settings.target = named_.number(stack, "target", settings.target);
    settings.part = named_.number(stack, "part", settings.part);
    settings.smallest = named_.number(stack, "hmin", settings.smallest);
    settings.largest = named_.number(stack, "hmax", settings.largest);
    settings.gradation = named_.number(stack, "gradation", settings.gradation);
    settings.largest_step =
        named_.number(stack, "largeststep", settings.largest_step);
    return settings;
  }

  double run(Stack stack) const {
    const Contact& contact = contact_of_processes(stack, contact_);
    if (!contact.shared)
      return contact.problem
                 ? run(stack, contact, given(stack, *contact.problem))
                 : run(stack, contact, given(stack, *contact.solid->problem));
    SharedContact& shared = *contact.shared;
    return solids().sizes_of_parts(stack, named_, shared,
                                   shared.plane
                                       ? given(stack, shared.plane->own)
                                       : given(stack, shared.solid->own),
                                   [&](const std::vector<VectorXd>& whole) {
                                     return run(stack, contact, whole);
                                   });
  }

  /// Error and rate of all cells of the bodies.
  template <int d>
  std::vector<VectorXd> given(Stack stack, const Bodies<d>& all) const {
    const int bodies = all.body_count();
    all.require_bodies("eps", local_error_.size());
    require_names_of_bodies(named_, sizes_of_bodies, bodies);
    std::vector<Expression> rates;
    for (int k = 0; k < bodies; ++k) {
      require_size("eps", value_of<KN<double>*>(stack, local_error_[k])->N(),
                   all.joined.first_cell[k + 1] - all.joined.first_cell[k]);
      rates.push_back(named_.expression(name_of_body("rate", k, bodies)));
    }
    return {joined(stack, local_error_), joined(stack, rates)};
  }

  double run(Stack stack, const Contact& contact,
             const std::vector<VectorXd>& arrays) const {
    const SizeSettings bounds = settings(stack);
    if (!contact.shared)
      contact.problem ? require_filled<2>(contact, arrays[0])
                      : require_filled(*contact.solid, arrays[0]);
    if (const ContactProblem<2>* plane = contact.problem.get())
      return answer(stack, plane->joined,
                    optimal_size(plane->mesh, plane->facets.vertices, arrays[0],
                                 arrays[1], bounds));
    const ContactProblem<3>& solid = *contact.solid->problem;
    return answer(stack, solid.joined, solids().sizes(solid, arrays, bounds));
  }

  template <int dim>
  double answer(Stack stack, const JoinedBodies<dim>& all,
                const OptimalSize& optimal) const {
    put(stack, all, optimal);
    report(stack, words_of(all), optimal);
    return optimal.predicted_count;
  }

  template <int dim>
  void put(Stack stack, const JoinedBodies<dim>& all,
           const OptimalSize& optimal) const {
    const int bodies = all.body_count();
    for (int k = 0; k < bodies; ++k) {
      const int v = all.first_vertex[k], t = all.first_cell[k];
      named_.put(stack, name_of_body("size", k, bodies),
                 optimal.size.segment(v, all.first_vertex[k + 1] - v));
      named_.put(stack, name_of_body("ratio", k, bodies),
                 optimal.ratio.segment(t, all.first_cell[k + 1] - t));
    }
    named_.put(stack, "wanted", optimal.wanted);
    named_.put(stack, "predicted", optimal.predicted_error);
    named_.put(stack, "spread", optimal.spread);
    named_.put(stack, "error", optimal.error);
  }

  template <int dim>
  static const char* words_of(const JoinedBodies<dim>&) {
    return MeshWords<dim>::cells;
  }

  void report(Stack stack, const char* cells,
              const OptimalSize& optimal) const {
    if (named_.verbosity_level(stack) < 1 || mpirank != 0) return;
    cout << "optimalsize: sizes " << optimal.size.minCoeff() << " to "
         << optimal.size.maxCoeff() << ", about "
         << std::lround(optimal.predicted_count) << " " << cells << " for eps "
         << 100 * optimal.predicted_error << " %" << endl;
    if (optimal.cautious)
      cout << "optimalsize: eps is above 50 %, and says little of where the "
              "error is: none of the "
           << cells << " grows to more than twice its size" << endl;
  }

  NamedArguments named_;
  Expression contact_;
  std::vector<Expression> local_error_;
};

}  // namespace

void register_sizing_functions() {
  Global.Add("optimalsize", "(", new OneOperatorCode<OptimalSizeFunction>());
}

}  // namespace ffcontact::plugin
