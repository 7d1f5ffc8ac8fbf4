// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_simulation_material_h
#define mixed_cracks_simulation_simulation_material_h

#include <discretization/fields.h>

#include <problem/material_field.h>

#include <simulation/parameters.h>

namespace MixedCracks
{
  /// Smallest and largest value.
  struct Range
  {
    double smallest;
    double largest;

    /// By more than rounding.
    bool
    varies() const
    {
      return largest - smallest > 1e-9 * largest;
    }
  };

  /// The constants as given, over the quadrature points of the mesh.
  struct MaterialRange
  {
    Range lambda;                       ///< three-dimensional, MPa
    Range mu;                           ///< MPa
    Range ratio;                        ///< lambda/mu
    Range nu;                           ///< Poisson ratio
    Range critical_energy_release_rate; ///< G_c, N/mm
  };

  /// Read the map, if there is one, and compare material ids with those of the
  /// mesh. Throws InputError or FileError on all ranks. Collective.
  template <int dim>
  MaterialField<dim>
  make_material_field(const MaterialParameters         &parameters,
                      const dealii::Triangulation<dim> &triangulation);

  /// What an assembler asks for: in plane stress reduced by (M6); empty where
  /// nothing varies.
  template <int dim>
  ConstantsFunction<dim> constants_function(const ModelParameters    &model,
                                            const MaterialField<dim> &field);

  /// Throws the InputError of one point on all ranks. Collective.
  template <int dim>
  MaterialRange material_range(const MaterialField<dim> &field,
                               const Fields<dim>        &fields);

  /// In one sentence, for the log.
  std::string in_words(const MaterialRange &range);
} // namespace MixedCracks

#endif
