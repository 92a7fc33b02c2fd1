// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "parallel/team.hpp"

namespace ffcontact::plugin {

/// CondensedStiffness by a factor that processes hold together, as process 0 sees it.
class SharedStiffness : public CondensedStiffness {
 public:
  /// @param dofs  of each process, in the whole
  /// @param own   the part of process 0
  /// @throws std::runtime_error  as CondensedStiffness
  SharedStiffness(std::shared_ptr<Team> team,
                  const std::vector<std::vector<int>>& dofs,
                  const ElasticSystem& own, const ElasticSystem& system,
                  const std::vector<int>& kept, Precision precision);
  ~SharedStiffness() override;

  Precision precision() const override { return precision_; }
  const MatrixXd& schur() const override { return schur_; }
  Load condensed(const Ref<const VectorXd>& load) const override;
  VectorXd extended(Load load, const Ref<const VectorXd>& kept) const override;

 private:
  void require_regular(const ElasticSystem& system) const;
  Index kept_count() const { return kept_; }

  std::shared_ptr<Team> team_;
  Precision precision_;
  Index kept_;
  std::vector<int> order_;  ///< the free dofs, the kept ones last
  VectorXd scale_;          ///< diag(K)^-1/2 [all dofs]
  long factor_ = 0;
  MatrixXd schur_;
  mutable VectorXd last_;  ///< the load that the factor has halfway
};

/// R K R of one part in the order of a factor.
MatrixPart matrix_part(const ElasticSystem& part, const FactorOrder& order);

}  // namespace ffcontact::plugin
