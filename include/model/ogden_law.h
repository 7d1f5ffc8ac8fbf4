// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_ogden_law_h
#define mixed_cracks_model_ogden_law_h

#include <model/hyperelastic_law.h>

namespace MixedCracks
{
  /// Ogden's law, a sum over the principal stretches; mu1, alpha1, mu2, ...
  /// for up to three terms. A term with mu_i = 0 is not there.
  class OgdenLaw : public HyperelasticLaw
  {
  public:
    explicit OgdenLaw(const HyperelasticForm &form)
      : form(form)
    {}

    std::vector<std::string> constant_names() const override;

    double mu(const HyperelasticConstants &constants) const override;

    double lambda(const HyperelasticConstants &constants) const override;

    std::string problem(const HyperelasticConstants &constants) const override;

    double energy(const Deformation           &deformation,
                  const HyperelasticConstants &constants) const override;

    HyperelasticResponse response(const Deformation           &deformation,
                                  const HyperelasticConstants &constants,
                                  bool with_tangent) const override;

    OutOfPlaneDerivatives
    out_of_plane(const Deformation           &deformation,
                 const HyperelasticConstants &constants) const override;

    bool
    is_sum_over_stretches() const override
    {
      return true;
    }

    double
    tensile_energy(const Deformation           &deformation,
                   const HyperelasticConstants &constants) const override;

  private:
    const HyperelasticForm form;
  };
} // namespace MixedCracks

#endif
