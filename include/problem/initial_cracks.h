// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_initial_cracks_h
#define mixed_cracks_problem_initial_cracks_h

#include <base/expression.h>

#include <deal.II/base/parameter_handler.h>

#include <problem/geometry.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// In 3-d a flat, penny-shaped crack; in 2-d a broken circle, whose normal
  /// is 0. In mm.
  template <int dim>
  struct CrackDisc
  {
    dealii::Point<dim>     center;
    dealii::Tensor<1, dim> normal; ///< of length 1
    double                 radius;
  };

  /// Subsection "Initial cracks": the phase field at the start: on the
  /// slits of the geometry, unless told otherwise, and on top of them.
  template <int dim>
  struct InitialCracks
  {
    std::string text;
    /// whether the phase field is 0 on the slits of the geometry
    bool        broken_slits = true;
    std::string discs_text;
    std::string phase_field_text;
    std::string half_width_text = "0.5*h";

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError for cracks and expressions that cannot be read.
    void check() const;

    std::vector<Segment<dim>> segments() const;

    std::vector<CrackDisc<dim>> discs() const;
  };

  /// The same, ready to be evaluated.
  template <int dim>
  class InitialPhaseField
  {
  public:
    /// Throws InputError like InitialCracks::check().
    explicit InitialPhaseField(const InitialCracks<dim> &cracks);

    /// Phase field of a node at @p position of a cell of size @p h (mm),
    /// between 0 and 1. Throws InputError for values that are not finite and
    /// for a negative half width; this may happen on one rank alone.
    double value(const dealii::Point<dim> &position, double h) const;

    /// Segments and discs as the .prm has them: "Initial cracks/Cracks: found
    /// '0,0 : 1,0'".
    const std::vector<std::string> &
    names() const
    {
      return crack_names;
    }

    /// Set @p breaks to 1 for those that break this node; one for each of
    /// names(). Throws like value().
    void note_broken(const dealii::Point<dim> &position,
                     double                    h,
                     std::vector<int>         &breaks) const;

  private:
    double width_for(double h) const;

    const std::vector<Segment<dim>>   segments;
    const std::vector<CrackDisc<dim>> discs;
    std::vector<std::string>          crack_names; // segments, then discs
    const Expression                  half_width;
    std::shared_ptr<const Expression> phase_field; // or null
  };
} // namespace MixedCracks

#endif
