// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/optimal_size.hpp"
//
#include "guard.hpp"
#include "registration.hpp"
#include "views.hpp"

namespace ffcontact::plugin {

namespace {

/// predicted triangles = optimalsize(Th, eps, target=, size=, ...)
class OptimalSizeFunction : public E_F0mps {
 public:
  using Result = double;

  explicit OptimalSizeFunction(const basicAC_F0& arguments)
      : named_(arguments, {{"target", &typeid(double)},
                           {"hmin", &typeid(double)},
                           {"hmax", &typeid(double)},
                           {"gradation", &typeid(double)},
                           {"largeststep", &typeid(double)},
                           {"rate", &typeid(KN<double>*)},
                           {"verbosity", &typeid(long)},
                           {"size", &typeid(KN<double>*)},
                           {"ratio", &typeid(KN<double>*)},
                           {"wanted", &typeid(double*)},
                           {"predicted", &typeid(double*)}}),
        mesh_(to<pmesh>(arguments[0])),
        local_error_(to<KN<double>*>(arguments[1])) {}

  static ArrayOfaType typeargs() { return ArrayOfaType(atype<pmesh>(), atype<KN<double>*>()); }
  static E_F0* f(const basicAC_F0& arguments) { return new OptimalSizeFunction(arguments); }

  AnyType operator()(Stack stack) const override {
    return guarded("optimalsize", [&] { return SetAny<double>(run(stack)); });
  }

 private:
  double run(Stack stack) const {
    const Mesh mesh = mesh_of(GetAny<pmesh>((*mesh_)(stack)));
    SizeSettings settings;
    settings.target = named_.number(stack, "target", settings.target);
    settings.smallest = named_.number(stack, "hmin", settings.smallest);
    settings.largest = named_.number(stack, "hmax", settings.largest);
    settings.gradation = named_.number(stack, "gradation", settings.gradation);
    settings.largest_step = named_.number(stack, "largeststep", settings.largest_step);
    const Expression given_rate = named_.expression("rate");
    const Eigen::VectorXd rate =
        given_rate ? Eigen::VectorXd(vector_of(GetAny<KN<double>*>((*given_rate)(stack)))) : Eigen::VectorXd();
    const OptimalSize optimal =
        optimal_size(mesh, edges_of(mesh), vector_of(GetAny<KN<double>*>((*local_error_)(stack))), rate, settings);
    named_.put(stack, "size", optimal.size);
    named_.put(stack, "ratio", optimal.ratio);
    named_.put(stack, "wanted", optimal.wanted);
    named_.put(stack, "predicted", optimal.predicted_error);
    if (named_.verbosity_level(stack) > 0 && mpirank == 0)
      cout << "optimalsize: sizes " << optimal.size.minCoeff() << " to " << optimal.size.maxCoeff() << ", about "
           << std::lround(optimal.predicted_count) << " triangles for eps " << 100 * optimal.predicted_error << " %"
           << endl;
    return optimal.predicted_count;
  }

  NamedArguments named_;
  Expression mesh_, local_error_;
};

}  // namespace

void register_sizing_functions() { Global.Add("optimalsize", "(", new OneOperatorCode<OptimalSizeFunction>()); }

}  // namespace ffcontact::plugin
