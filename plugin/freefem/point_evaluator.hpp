// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/packed.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

/// Evaluates expressions at points of a mesh and gives the script its current point back.
class PointEvaluator {
 public:
  explicit PointEvaluator(Stack stack)
      : point_(MeshPointStack(stack)), stack_(stack), saved_(*point_) {}
  ~PointEvaluator() { *point_ = saved_; }
  PointEvaluator(const PointEvaluator&) = delete;
  PointEvaluator& operator=(const PointEvaluator&) = delete;

  /// What the evaluation made is freed at once: FreeFEM frees temporaries only at the end
  /// of the statement. Those that were there before are the statement's own: texts of a
  /// sum, a mesh among the arguments.
  double value(Expression expression) const {
    StackOfPtr2Free& temporaries = *WhereStackOfPtr2Free(stack_);
    const auto own = count_of(temporaries);
    const int own_memory = temporaries.topmemory4tmp;
    const double result = GetAny<double>((*expression)(stack_));
    temporaries.clean(own);
    temporaries.topmemory4tmp = own_memory;  // clean() gives all of it away
    return result;
  }

 protected:
  /// Where expressions are taken.
  Fem2D::MeshPoint& point() { return *point_; }

 private:
  Fem2D::MeshPoint* point_;
  Stack stack_;
  Fem2D::MeshPoint saved_;
};

}  // namespace ffcontact::plugin
