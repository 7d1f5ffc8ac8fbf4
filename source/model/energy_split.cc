// SPDX-License-Identifier: GPL-2.0-or-later
#include <model/energy_split.h>
#include <model/spectral_split.h>

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

      StressParts<dim>
      parts(const SymmetricTensor<2, dim> &strain,
            const double                   mu) const override
      {
        return {2. * mu * strain, {}};
      }

      int
      tangent_regime(const SymmetricTensor<2, dim> &) const override
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
    // the deviator always. The coefficient of <tr eps> I is @p factor mu: 2/n
    // makes the parts add up.
    template <int dim>
    class VolumetricDeviatoricSplit : public EnergySplit<dim>
    {
    public:
      explicit VolumetricDeviatoricSplit(const int deviator_dimension)
        : VolumetricDeviatoricSplit(deviator_dimension,
                                    2. / effective(deviator_dimension))
      {}

      VolumetricDeviatoricSplit(const int    deviator_dimension,
                                const double factor)
        : n(effective(deviator_dimension))
        , factor(factor)
        , volumetric(outer_product(unit_symmetric_tensor<dim>(),
                                   unit_symmetric_tensor<dim>()))
        , deviatoric(identity_tensor<dim>() - volumetric / n)
      {
        Assert(deviator_dimension == 2 || deviator_dimension == 3,
               dealii::ExcMessage("The deviator is one of 2 or 3 dimensions."));
      }

      SplitStress<dim>
      evaluate(const SymmetricTensor<2, dim> &strain,
               const double                   mu) const override
      {
        SplitStress<dim> result;
        static_cast<StressParts<dim> &>(result) = parts(strain, mu);
        result.positive_tangent                 = 2. * mu * deviatoric;
        (expands(strain) ? result.positive_tangent : result.negative_tangent) +=
          factor * mu * volumetric;
        return result;
      }

      StressParts<dim>
      parts(const SymmetricTensor<2, dim> &strain,
            const double                   mu) const override
      {
        StressParts<dim> result;
        result.positive            = 2. * mu * strain;
        const double volume_change = trace(strain);
        const bool   expansion     = expands(strain);
        const double pressure      = factor * mu * volume_change;
        for (unsigned int d = 0; d < dim; ++d)
        {
          result.positive[d][d] -= 2. * mu / n * volume_change;
          (expansion ? result.positive : result.negative)[d][d] += pressure;
        }
        return result;
      }

      int
      tangent_regime(const SymmetricTensor<2, dim> &strain) const override
      {
        return expands(strain) ? 1 : 0;
      }

      bool
      splits_pressure() const override
      {
        return true;
      }

      bool
      adds_up() const override
      {
        return factor == 2. / n;
      }

    private:
      static double
      effective(const int deviator_dimension)
      {
        return dim == 3 ? 3. : deviator_dimension;
      }

      static bool
      expands(const SymmetricTensor<2, dim> &strain)
      {
        return trace(strain) > 0.;
      }

      const double                  n;
      const double                  factor;
      const SymmetricTensor<4, dim> volumetric; ///< I x I
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
        }},
       {"spectral",
        "principal strains in tension drive the crack, and so does expansion "
        "(Miehe, Hofacker and Welschinger 2010); with 'Pressure law = "
        "degraded bulk' in the displacement formulation this is the energy "
        "of that paper",
        [](const int) -> std::unique_ptr<EnergySplit<dim>> {
          return std::make_unique<SpectralSplit<dim>>();
        }},
       {"volumetric-deviatoric as printed",
        "the coefficients printed by Mang et al. (2021), mu <tr eps> and a "
        "deviator with 1/3; they do not add up to the elastic stress, not even "
        "in intact material, and are here for comparison only",
        [](const int) -> std::unique_ptr<EnergySplit<dim>> {
          return std::make_unique<VolumetricDeviatoricSplit<dim>>(3, 1.);
        }}});
    return list;
  }



  template const Registry<EnergySplit<2>, int> &all_energy_splits<2>();
  template const Registry<EnergySplit<3>, int> &all_energy_splits<3>();
} // namespace MixedCracks
