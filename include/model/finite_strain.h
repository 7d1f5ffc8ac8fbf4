// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_finite_strain_h
#define mixed_cracks_model_finite_strain_h

#include <model/elastic_response.h>
#include <model/point_constants.h>

namespace MixedCracks
{
  struct MaterialDescription;

  /// Placeholder of the contract; the model layer has its own.
  template <int dim>
  class FiniteStrain
  {
  public:
    using Gradient = dealii::Tensor<2, dim>;

    explicit FiniteStrain(const MaterialDescription &);

    ElasticResponse<dim> mixed(const Gradient &,
                               double                p,
                               double                g,
                               const PointConstants &at,
                               bool                  with_tangent) const;
    ElasticResponse<dim> eliminated(const Gradient &,
                                    double                g,
                                    const PointConstants &at,
                                    bool                  with_tangent) const;

    struct Potential
    {
      double distortion;    ///< MPa
      double volume_change; ///< 1
      double compliance;    ///< 1/MPa
    };
    Potential            potential(const Gradient &,
                                   double                p,
                                   double                g,
                                   const PointConstants &at) const;
    double               eliminated_energy(const Gradient &,
                                           double                g,
                                           const PointConstants &at) const;
    static double        determinant(const Gradient &);
    double               volume_ratio(const Gradient &,
                                      double                p,
                                      double                g,
                                      const PointConstants &at) const;
    dealii::Tensor<2, 3> deformation_gradient(const Gradient &,
                                              double                p,
                                              double                g,
                                              const PointConstants &at) const;
  };
} // namespace MixedCracks

#endif
