// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"
#include "ffcontact/parallel/contact_layer.hpp"
#include "ffcontact/parallel/messages.hpp"

/// relax_facets by several processes: each has the forms and the factors of its part,
/// process 0 the contact besides. The answer does not depend on their number but for the
/// rounding of sums.
namespace ffcontact {

/// The halos of a part.
class HaloExchange : public FacetExchange<3> {
 public:
  /// @param part  stays where it is, as messages
  HaloExchange(const FacePart& part, const Messages& messages)
      : part_(part), messages_(messages) {}
  double sum(double of_share) const override;
  void complete(FacetImages<3>& images) const override;

 private:
  const FacePart& part_;
  const Messages& messages_;
};

/// What a process does; what takes memory is done before anything is exchanged.
class PartRelaxation {
 public:
  /// @param messages  stays where it is
  PartRelaxation(FacePart part, const Messages& messages);
  PartRelaxation(const PartRelaxation&) = delete;

  const FacePart& part() const { return part_; }
  std::vector<double> relax(ContactRelaxation<3>& contact,
                            const RelaxationSettings& settings) {
    return ffcontact::relax<3>(descent_, contact, settings);
  }
  /// (w, y) of the faces that it counts, in their order.
  Matrix9Xd corrections();

 private:
  FacePart part_;
  HaloExchange exchange_;
  FacetDescent<3> descent_;
};

/// Process 0.
class LeadingRelaxation {
 public:
  /// @param setting   of the whole, as moments; it stays where it is
  /// @param owner     the process of each tetrahedron
  /// @param messages  stays where it is
  LeadingRelaxation(const FacetSetting<3>& setting, const FaceMoments& moments,
                    std::vector<int> owner, const Messages& messages);

  FacePart part_of(int process) const { return parts_.part(process); }
  /// Makes its own part ready.
  void prepare();
  /// As relax_facets, while the others follow.
  std::vector<double> relax(const RelaxationSettings& settings,
                            FaceMoments& moments);

 private:
  const FacetSetting<3>& setting_;
  const Messages& messages_;
  ContactLayer layer_;
  FaceParts parts_;
  std::unique_ptr<PartRelaxation> own_;
};

/// Any other process, while process 0 leads.
void follow(PartRelaxation& relaxation, const Messages& messages,
            const RelaxationSettings& settings);

}  // namespace ffcontact
