// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_point_constants_h
#define mixed_cracks_model_point_constants_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <functional>

namespace MixedCracks
{
  /// The constants of a law of rubber, in the order of
  /// HyperelasticLaw::constant_names(), the rest 0.
  using HyperelasticConstants = std::array<double, 6>;

  /// The constants of the material that may differ from point to point.
  struct PointConstants
  {
    /// MPa. Small strains: already reduced by (M6) in plane stress; finite
    /// strain: that of three dimensions, K - 2 mu/3.
    double lambda;
    /// MPa. Finite strain: the one at F = I, HyperelasticLaw::mu().
    double mu;
    double critical_energy_release_rate; ///< G_c, N/mm

    /// Finite strain only. Neo-Hooke takes mu where this is all 0.
    HyperelasticConstants hyperelastic{};
  };

  /// The constants at a point (mm) of a cell with a material id. Throws
  /// InputError, perhaps on one rank alone. Empty: they are the same
  /// everywhere, those of the MaterialDescription.
  template <int dim>
  using ConstantsFunction =
    std::function<PointConstants(const dealii::Point<dim> &,
                                 dealii::types::material_id)>;

  /// The constants at the quadrature points of one cell, of which it is only
  /// a view: one for each, or one for all.
  class CellConstants
  {
  public:
    /// Of no cell yet.
    CellConstants() = default;

    /// The same at every point.
    explicit CellConstants(const PointConstants &everywhere)
      : first(&everywhere)
      , stride(0)
    {}

    /// One for each point, one after the other.
    explicit CellConstants(const PointConstants *first)
      : first(first)
      , stride(1)
    {}

    const PointConstants &
    operator[](const unsigned int q) const
    {
      return first[q * stride];
    }

  private:
    const PointConstants *first  = nullptr;
    unsigned int          stride = 0;
  };
} // namespace MixedCracks

#endif
