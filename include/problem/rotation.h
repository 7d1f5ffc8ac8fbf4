// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_rotation_h
#define mixed_cracks_problem_rotation_h

#include <deal.II/base/point.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A part of the boundary turned as a rigid whole about a point (2-d) or an
  /// axis (3-d).
  template <int dim>
  class Rotation
  {
  public:
    /// "rotation about 0, 0", in 3-d "rotation about 0, 0, 0 axis 0, 0, 1" or
    /// "twist about ...": components across the axis only, which is x, y or z
    /// then; null for words that begin otherwise. Throws InputError that names
    /// @p parameter.
    static std::shared_ptr<const Rotation> read(const std::string &words,
                                                const std::string &parameter);

    /// How read() wants it, for messages.
    static std::string form();

    /// Displacement (mm) of a point turned by @p angle (rad), positive
    /// counter-clockwise seen against the axis: (R - I)(x - c), exact.
    dealii::Tensor<1, dim> displacement(const dealii::Point<dim> &point,
                                        double                    angle) const;

    /// Which components are prescribed.
    const std::vector<unsigned int> &
    components() const
    {
      return prescribed;
    }

  private:
    dealii::Point<dim>        centre;
    dealii::Tensor<1, 3>      axis; // of length 1
    std::vector<unsigned int> prescribed;
  };
} // namespace MixedCracks

#endif
