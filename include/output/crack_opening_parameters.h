// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_opening_parameters_h
#define mixed_cracks_output_crack_opening_parameters_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// Where the opening of a crack is measured: at points along it, each on a
  /// straight line through it; mm.
  template <int dim>
  struct OpeningLine
  {
    dealii::Point<dim>     begin;
    dealii::Point<dim>     end;
    dealii::Tensor<1, dim> normal; ///< along which is integrated; of length 1
    unsigned int           n_positions; ///< evenly spaced, ends included

    dealii::Point<dim> position(unsigned int i) const;
  };

  /// What is measured of open cracks, entries of subsection "Output".
  template <int dim>
  struct CrackOpeningParameters
  {
    bool        crack_volume = false;
    std::string lines_text;
    double      reach = 10.; ///< in length scales

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError for lines that cannot be read.
    void check() const;

    std::vector<OpeningLine<dim>> lines() const;
  };
} // namespace MixedCracks

#endif
