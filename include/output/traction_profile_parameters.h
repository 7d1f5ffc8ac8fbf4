// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_traction_profile_parameters_h
#define mixed_cracks_output_traction_profile_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <discretization/boundary_ids.h>

#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// Boundaries whose tractions are written, entries of subsection "Output".
  struct TractionProfileParameters
  {
    std::string  text;
    unsigned int every = 1; ///< steps

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Names and numbers, in the order of the entry. Throws InputError for
    /// unknown boundaries and for one that is named twice.
    std::vector<std::pair<std::string, BoundaryIds>>
    boundaries(const NamedBoundaries &ids) const;
  };
} // namespace MixedCracks

#endif
