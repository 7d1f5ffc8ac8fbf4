// SPDX-License-Identifier: GPL-2.0-or-later
// The split of the stress into what opens cracks and what does not,
//
//   sigma = g(phi) sigma+ + sigma-,        psi+ = 1/2 sigma+ : eps.
//
// Only psi+ drives phi and only sigma+ fades with it; without a split, material
// would break, and interpenetrate, under compression. Split here is 2 mu eps
// (MPa), the part of the stress without the pressure; the pressure p I belongs
// to sigma+ where p > 0 and to sigma- elsewhere (PressureLaw says how it
// fades), unless splits_pressure() is false. <a> = max(a, 0).
//
//   name                   part of sigma+ without the pressure
//   none                   2 mu eps
//   volumetric-deviatoric  2 mu dev_n(eps) + (2 mu/n) <tr eps> I         (M3)
//   spectral               2 mu sum_a <eps_a> n_a (x) n_a                (M4)
//   ... as printed         2 mu dev_3(eps) + mu <tr eps> I            [Mang21]
//
// with dev_n(eps) = eps - (tr eps/n) I, n = 3 for the law in space, which plane
// strain restricts to the plane, and n = 2 for a law within the plane (plane
// stress). The other part is the rest, 2 mu eps minus it, but for the last
// line: its parts add up to 2 mu dev_3(eps) + mu tr(eps) I, which is 2 mu eps
// only where tr eps = 0. It is there to compare with the paper, and intact
// material is not linearly elastic with it.
//
// Every split is homogeneous of degree one in eps (twice the strain, twice the
// stress), so that sigma+ = C+(eps) : eps with C+ = d(sigma+)/d(eps) and psi+ =
// 1/2 eps : C+ : eps. C+ changes with the regime the strain is in only, for the
// first two splits; a matrix assembled for one state is that of another where
// all points are in the same regime, which tangent_regime() tells.

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

    // sigma+ = 2 mu eps, sigma- = 0,  C+ = 2 mu 1,  C- = 0  (1: the identity on
    // symmetric tensors). One regime; p is degraded whatever its sign.
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



    // (M3), [Amor09]: the change of shape always opens cracks, the change of
    // volume only where it is expansion,
    //
    //   sigma+ = 2 mu (eps - (tr eps/n) I) + factor mu <tr eps> I
    //   sigma- = factor mu (tr eps - <tr eps>) I
    //
    //   C+ = 2 mu (1 - I (x) I/n) + factor mu H(tr eps) I (x) I
    //   C- = factor mu (1 - H(tr eps)) I (x) I,     H(a) = 1 for a > 0, else 0.
    //
    // factor = 2/n makes the parts add up to 2 mu eps; [Mang21] prints 1 with n
    // = 3. Two regimes: expansion and the rest.
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
