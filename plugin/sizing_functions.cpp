// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
#include "ffcontact/sizing/optimal_size.hpp"
//
#include "contact_arguments.hpp"
#include "guard.hpp"
#include "registration.hpp"
#include "views.hpp"

namespace ffcontact::plugin {

namespace {

/// predicted triangles = optimalsize(Th, eps, target=, size=, ...), or with mesh and eps of each of several bodies: one wanted
/// error and one Lambda for all of them.
template <int bodies>
class OptimalSizeFunction : public E_F0mps {
 public:
  using Result = double;

  explicit OptimalSizeFunction(const basicAC_F0& arguments) : named_(arguments, table()) {
    for (int k = 0; k < bodies; ++k) {
      mesh_.push_back(to<pmesh>(arguments[2 * k]));
      local_error_.push_back(to<KN<double>*>(arguments[2 * k + 1]));
    }
  }

  static ArrayOfaType typeargs() {
    std::vector<aType> types;
    for (int k = 0; k < bodies; ++k) types.insert(types.end(), {atype<pmesh>(), atype<KN<double>*>()});
    return ArgumentTypes(types);
  }
  static E_F0* f(const basicAC_F0& arguments) { return new OptimalSizeFunction(arguments); }

  AnyType operator()(Stack stack) const override {
    return guarded("optimalsize", [&] { return SetAny<double>(run(stack)); });
  }

 private:
  static const char* name(const char* parameter, int body) { return name_of_body(parameter, body, bodies); }

  static NamedArguments::Table table() {
    NamedArguments::Table table = for_bodies(
        {{"rate", &typeid(KN<double>*)}, {"size", &typeid(KN<double>*)}, {"ratio", &typeid(KN<double>*)}}, bodies);
    table.insert(table.end(), {{"target", &typeid(double)},
                               {"hmin", &typeid(double)},
                               {"hmax", &typeid(double)},
                               {"gradation", &typeid(double)},
                               {"largeststep", &typeid(double)},
                               {"verbosity", &typeid(long)},
                               {"wanted", &typeid(double*)},
                               {"predicted", &typeid(double*)}});
    return table;
  }

  /// The given arrays of all bodies one after the other; none where the first is not given.
  static Eigen::VectorXd joined(Stack stack, const std::vector<Expression>& arrays) {
    Eigen::VectorXd values;
    for (Expression array : arrays) {
      if (!array) return {};
      const Eigen::VectorXd own = vector_of(value_of<KN<double>*>(stack, array));
      values.conservativeResize(values.size() + own.size());
      values.tail(own.size()) = own;
    }
    return values;
  }

  double run(Stack stack) const {
    std::vector<Mesh> meshes;
    std::vector<Expression> rates;
    for (int k = 0; k < bodies; ++k) {
      meshes.push_back(mesh_of(value_of<pmesh>(stack, mesh_[k])));
      require_size("eps", value_of<KN<double>*>(stack, local_error_[k])->N(), meshes[k].triangle_count());
      rates.push_back(named_.expression(name("rate", k)));
    }
    const JoinedMesh all = joined_mesh(meshes);
    SizeSettings settings;
    settings.target = named_.number(stack, "target", settings.target);
    settings.smallest = named_.number(stack, "hmin", settings.smallest);
    settings.largest = named_.number(stack, "hmax", settings.largest);
    settings.gradation = named_.number(stack, "gradation", settings.gradation);
    settings.largest_step = named_.number(stack, "largeststep", settings.largest_step);
    const OptimalSize optimal =
        optimal_size(all.mesh, edges_of(all.mesh), joined(stack, local_error_), joined(stack, rates), settings);
    for (int k = 0; k < bodies; ++k) {
      const int v = all.first_vertex[k], t = all.first_triangle[k];
      named_.put(stack, name("size", k), optimal.size.segment(v, all.first_vertex[k + 1] - v));
      named_.put(stack, name("ratio", k), optimal.ratio.segment(t, all.first_triangle[k + 1] - t));
    }
    named_.put(stack, "wanted", optimal.wanted);
    named_.put(stack, "predicted", optimal.predicted_error);
    if (named_.verbosity_level(stack) > 0 && mpirank == 0)
      cout << "optimalsize: sizes " << optimal.size.minCoeff() << " to " << optimal.size.maxCoeff() << ", about "
           << std::lround(optimal.predicted_count) << " triangles for eps " << 100 * optimal.predicted_error << " %"
           << endl;
    return optimal.predicted_count;
  }

  NamedArguments named_;
  std::vector<Expression> mesh_, local_error_;
};

}  // namespace

void register_sizing_functions() {
  Global.Add("optimalsize", "(", new OneOperatorCode<OptimalSizeFunction<1>>());
  Global.Add("optimalsize", "(", new OneOperatorCode<OptimalSizeFunction<2>>());
  Global.Add("optimalsize", "(", new OneOperatorCode<OptimalSizeFunction<3>>());
}

}  // namespace ffcontact::plugin
