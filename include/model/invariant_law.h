// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_invariant_law_h
#define mixed_cracks_model_invariant_law_h

#include <model/hyperelastic_law.h>

namespace MixedCracks
{
  /// A function of one variable with its derivatives.
  struct Curve
  {
    double value;
    double first;
    double second;
  };

  /// The laws f(I1) + h(I2) - m ln J, with m such that F = I is free of
  /// stress, or f(I1 J^(-2/3)) + h(I2 J^(-4/3)). A law gives f and h; f goes
  /// on linearly beyond the I1 of the uniaxial stretch of use.
  class InvariantLaw : public HyperelasticLaw
  {
  public:
    explicit InvariantLaw(const HyperelasticForm &form);

    double mu(const HyperelasticConstants &constants) const override;

    double lambda(const HyperelasticConstants &constants) const override;

    double energy(const Deformation           &deformation,
                  const HyperelasticConstants &constants) const override;

    HyperelasticResponse response(const Deformation           &deformation,
                                  const HyperelasticConstants &constants,
                                  bool with_tangent) const override;

  protected:
    /// f as a function of @p excess = I1 - 3, with f(0) = 0; MPa.
    virtual Curve of_first(double                       excess,
                           const HyperelasticConstants &constants) const = 0;

    /// h as a function of @p excess = I2 - 3, with h(0) = 0; MPa.
    virtual Curve of_second(double                       excess,
                            const HyperelasticConstants &constants) const;

    /// Whether h is not 0.
    virtual bool
    has_second() const
    {
      return false;
    }

    /// I1 - 3 up to which f holds.
    virtual double
    reach(const HyperelasticConstants &) const
    {
      return reach_of_use;
    }

    const HyperelasticForm form;
    /// I1 - 3 of the uniaxial incompressible stretch of use.
    const double reach_of_use;

  private:
    Curve of_first_continued(double                       excess,
                             const HyperelasticConstants &constants) const;

    double log_coefficient(const HyperelasticConstants &constants) const;
  };
} // namespace MixedCracks

#endif
