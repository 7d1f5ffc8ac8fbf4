// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_mean_strain_h
#define mixed_cracks_problem_mean_strain_h

#include <base/expression.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// The entry "Boundary conditions/Mean strain" of a body with periodic sides:
  /// at small strain the symmetric E of u+ - u- = E L, at finite strain the
  /// mean of the displacement gradient, H_ij of du_i/dx_j.
  template <int dim>
  class MeanStrain
  {
  public:
    struct Component
    {
      std::string                       name; ///< "xy"
      unsigned int                      i, j;
      std::shared_ptr<const Expression> expression; ///< of t
    };

    /// Read "component : expression ; ...". Throws InputError, naming the
    /// entry, for what is not of that form, a component that there is not, or
    /// twice.
    MeanStrain(const std::string &text, bool finite_strain);

    bool
    empty() const
    {
      return components.empty();
    }

    /// Throws InputError where a value is not finite.
    dealii::Tensor<2, dim> at(double time) const;

    /// Throws InputError for a component that makes no difference, as none of
    /// @p periods, the vectors between the sides, has that direction.
    void
    require_effect(const std::vector<dealii::Tensor<1, dim>> &periods) const;

  private:
    const bool             finite_strain;
    std::vector<Component> components;
  };
} // namespace MixedCracks

#endif
