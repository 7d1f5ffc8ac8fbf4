// SPDX-License-Identifier: GPL-2.0-or-later
#include <model/energy_split.h>

#include <deal.II/base/exceptions.h>

namespace MixedCracks
{
  namespace
  {
    using dealii::identity_tensor;
    using dealii::outer_product;
    using dealii::SymmetricTensor;
    using dealii::trace;
    using dealii::unit_symmetric_tensor;

    template <int dim>
    class NoSplit : public EnergySplit<dim>
    {
    public:
      SplitStress<dim>
      evaluate(const SymmetricTensor<2, dim> &strain,
               const double                   mu) const override
      {
        SplitStress<dim> result;
        result.positive         = 2. * mu * strain;
        result.positive_tangent = 2. * mu * identity;
        return result;
      }

      int
      branch(const SymmetricTensor<2, dim> &) const override
      {
        return 0;
      }

      bool
      splits_pressure() const override
      {
        return false;
      }

    private:
      const SymmetricTensor<4, dim> identity = identity_tensor<dim>();
    };



    // (M3), [Amor09]: the volume change drives the crack in expansion only,
    // the deviator always
    template <int dim>
    class VolumetricDeviatoricSplit : public EnergySplit<dim>
    {
    public:
      explicit VolumetricDeviatoricSplit(const int deviator_dimension)
        : n(dim == 3 ? 3. : deviator_dimension)
        , volumetric(outer_product(unit_symmetric_tensor<dim>(),
                                   unit_symmetric_tensor<dim>()) /
                     n)
        , deviatoric(identity_tensor<dim>() - volumetric)
      {
        Assert(deviator_dimension == 2 || deviator_dimension == 3,
               dealii::ExcMessage("The deviator is one of 2 or 3 dimensions."));
      }

      SplitStress<dim>
      evaluate(const SymmetricTensor<2, dim> &strain,
               const double                   mu) const override
      {
        SplitStress<dim> result;
        result.positive         = 2. * mu * strain;
        result.positive_tangent = 2. * mu * deviatoric;
        if (expands(strain))
          result.positive_tangent += 2. * mu * volumetric;
        else
        {
          const double pressure = 2. * mu / n * trace(strain);
          for (unsigned int d = 0; d < dim; ++d)
          {
            result.negative[d][d] = pressure;
            result.positive[d][d] -= pressure;
          }
          result.negative_tangent = 2. * mu * volumetric;
        }
        return result;
      }

      int
      branch(const SymmetricTensor<2, dim> &strain) const override
      {
        return expands(strain) ? 1 : 0;
      }

      bool
      splits_pressure() const override
      {
        return true;
      }

    private:
      static bool
      expands(const SymmetricTensor<2, dim> &strain)
      {
        return trace(strain) > 0.;
      }

      const double                  n;
      const SymmetricTensor<4, dim> volumetric; ///< I x I / n
      const SymmetricTensor<4, dim> deviatoric;
    };
  } // namespace



  template <int dim>
  const Registry<EnergySplit<dim>, int> &
  all_energy_splits()
  {
    static const Registry<EnergySplit<dim>, int> list(
      "energy split",
      {{"none",
        "the whole energy drives the crack and is degraded by it, in "
        "compression too",
        [](const int) -> std::unique_ptr<EnergySplit<dim>> {
          return std::make_unique<NoSplit<dim>>();
        }},
       {"volumetric-deviatoric",
        "expansion and change of shape drive the crack, compression does not "
        "(Amor, Marigo and Maurini 2009)",
        [](const int n) -> std::unique_ptr<EnergySplit<dim>> {
          return std::make_unique<VolumetricDeviatoricSplit<dim>>(n);
        }}});
    return list;
  }



  template const Registry<EnergySplit<2>, int> &all_energy_splits<2>();
  template const Registry<EnergySplit<3>, int> &all_energy_splits<3>();
} // namespace MixedCracks
