// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_hyperelastic_law_h
#define mixed_cracks_model_hyperelastic_law_h

#include <base/registry.h>

#include <model/deformation.h>
#include <model/point_constants.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// How the energy of a law is written.
  struct HyperelasticForm
  {
    /// Stretch of use, above 1: beyond it the law goes on as neo-Hooke.
    double largest_stretch = 5.;
    /// In the stretches J^(-1/3) lambda_a and without ln J.
    bool isochoric = false;
  };

  /// W~ at one point with its derivatives by F; MPa.
  struct HyperelasticResponse
  {
    double               energy = 0.;
    dealii::Tensor<2, 3> stress;  ///< dW~/dF_iJ
    dealii::Tensor<4, 3> tangent; ///< d2W~/dF_iJ dF_kL
  };

  /// First and second derivative of W~ by F_33; MPa.
  struct OutOfPlaneDerivatives
  {
    double first;
    double second;
  };

  /// A law of rubber: W~(F) of (M12), zero and free of stress at F = I,
  /// isotropic. The volumetric part is another one's, see VolumetricForm. The
  /// constants are arguments, as they may vary from point to point; they must
  /// be without a problem().
  class HyperelasticLaw
  {
  public:
    virtual ~HyperelasticLaw() = default;

    /// What the constants are called, in their order; at most six.
    virtual std::vector<std::string> constant_names() const = 0;

    /// The shear modulus at F = I; MPa.
    virtual double mu(const HyperelasticConstants &constants) const = 0;

    /// lambda_W, what W~ adds to Lame's lambda at F = I; MPa. -2 mu/3 in the
    /// isochoric form.
    virtual double lambda(const HyperelasticConstants &constants) const = 0;

    /// What is wrong with the constants, in words that name them; empty:
    /// nothing.
    virtual std::string
    problem(const HyperelasticConstants &constants) const = 0;

    virtual double energy(const Deformation           &deformation,
                          const HyperelasticConstants &constants) const = 0;

    /// Without @p with_tangent, the tangent is 0, and it takes less time.
    virtual HyperelasticResponse
    response(const Deformation           &deformation,
             const HyperelasticConstants &constants,
             bool                         with_tangent) const = 0;

    /// The derivatives by F_33 where F_13 = F_23 = F_31 = F_32 = 0.
    virtual OutOfPlaneDerivatives
    out_of_plane(const Deformation           &deformation,
                 const HyperelasticConstants &constants) const;

    /// Whether W~ = sum_a w(lambda_a), so that tensile_energy() is there.
    virtual bool
    is_sum_over_stretches() const
    {
      return false;
    }

    /// The sum of w(lambda_a) over the stretches above 1; MPa.
    virtual double tensile_energy(const Deformation           &deformation,
                                  const HyperelasticConstants &constants) const;

    /// Whether W~ is (mu/2)(I1 - 3) - mu ln J, for which F_33 is known in
    /// closed form (M14).
    virtual bool
    is_neo_hooke() const
    {
      return false;
    }
  };

  /// Neo-Hooke, Mooney-Rivlin, Yeoh, Gent and Ogden by name.
  const Registry<HyperelasticLaw, HyperelasticForm> &all_hyperelastic_laws();
} // namespace MixedCracks

#endif
