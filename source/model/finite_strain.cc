// SPDX-License-Identifier: GPL-2.0-or-later
// Rubber at one point, (M11) to (M15). F = I + grad u is 3 x 3: in plane
// strain F_33 = 1, in plane stress F_33 follows from P_33 = 0. Everything
// derives, at a fixed degradation g, from the potential (MPa)
//
//   Pi(F, p) = a W~(F) + s p theta(J) - c p^2/2                 (M13), (M13b)
//
// with a, s, c of FinitePressureLaw (c = s^2/lambda_d), W~ of HyperelasticLaw
// and theta of VolumetricForm, J - 1 in the coupled form:
//
//   P   = a dW~/dF + p N,   N = s theta' dJ/dF                   3 x 3, MPa
//   R_p = s theta - c p                                           no unit
//   A   = a d2W~/dF dF + p s (theta'' dJ/dF (x) dJ/dF + theta' d2J/dF dF)
//
//   [ A   N ]
//   [ N  -c ]   the matrix of mixed(), symmetric.
//
// eliminated(): p = s theta/c, A + N (x) N/c. Plane stress: F_33 is condensed
// out of either,
//
//   A_ijkl - A_ij33 A_33kl/A_3333,   N_ij - A_ij33 N_33/A_3333,
//   -(c + N_33^2/A_3333),
//
// A_3333 > 0, or there is no F_33 (finite_strain_kinematics.cc). In material
// that is nearly broken gamma grad u stands for grad u, and a linear part is
// added (energy_interpolation.cc). With a split
// of the pressure, a, s and c depend on the sign of p, which is that of theta
// where p is eliminated; s and c jump there, and s p and p^2 do not.
//
//   D     = 2 W~ + driving p theta                                (M15), MPa
//   psi   = a W~ + c p^2/2        stored energy, Pi with p of the constraint
//   sigma = P F^T/J               Cauchy's stress

#include <model/energy_interpolation.h>
#include <model/finite_strain.h>

#include <base/errors.h>

#include <deal.II/base/symmetric_tensor.h>

#include <limits>

namespace MixedCracks
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    const double undefined = std::numeric_limits<double>::quiet_NaN();

    template <int rank, int dim>
    Tensor<rank, dim>
    filled(const double value)
    {
      Tensor<rank, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        if constexpr (rank == 1)
          result[d] = value;
        else
          result[d] = filled<rank - 1, dim>(value);
      return result;
    }

    template <int dim>
    ElasticResponse<dim>
    undefined_response()
    {
      ElasticResponse<dim> result;
      result.stress                 = filled<2, dim>(undefined);
      result.constraint             = undefined;
      result.constraint_by_pressure = undefined;
      result.finite = FiniteTangent<dim>{filled<4, dim>(undefined),
                                         filled<2, dim>(undefined)};
      return result;
    }

    // A and N without F_33, whose equation is that of P_33
    void
    condense(Tensor<4, 3> &tangent, Tensor<2, 3> &coupling, double &by_pressure)
    {
      const double       stiffness = tangent[2][2][2][2];
      const double       normal    = coupling[2][2];
      const Tensor<2, 3> row       = tangent[2][2];
      add_outer_product(tangent, -1. / stiffness, row, row);
      coupling -= normal / stiffness * row;
      by_pressure -= normal * normal / stiffness;
    }

    // P(H) -> gamma P(gamma H) + (1 - gamma^2) g mu_L H, and the tangents;
    // @p distortion: a = g of FinitePressureCoefficients
    template <int dim>
    void
    interpolate(const Tensor<2, dim>        &gradient,
                const double                 share,
                const double                 distortion,
                const HyperelasticLaw       &law,
                const HyperelasticConstants &constants,
                ElasticResponse<dim>        &response)
    {
      if (share == 1.)
        return;
      const double linear =
        (1. - share * share) * distortion * linear_modulus(law, constants);
      response.stress *= share;
      response.stress += linear * gradient;
      response.finite->coupling *= share;
      response.finite->stress_by_gradient *= share * share;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          response.finite->stress_by_gradient[i][j][i][j] += linear;
    }

    HyperelasticForm
    form_of(const MaterialDescription &description, const bool isochoric)
    {
      return {description.largest_stretch, isochoric};
    }

    // mu of the usual pair does for neo-Hooke
    HyperelasticConstants
    constants_of(const HyperelasticLaw &law, const PointConstants &at)
    {
      HyperelasticConstants constants = at.hyperelastic;
      if (law.constant_names().size() == 1 && constants[0] == 0.)
        constants[0] = at.mu;
      return constants;
    }
  } // namespace



  std::string
  finite_strain_problem(const MaterialDescription &description,
                        const PointConstants      &at)
  {
    if (!(description.largest_stretch > 1.))
      return "the largest stretch must be above 1";
    const auto form = all_volumetric_forms().make(description.volumetric_form);
    const auto law  = all_hyperelastic_laws().make(
      description.hyperelastic_law, form_of(description, form->is_isochoric()));
    const HyperelasticConstants constants = constants_of(*law, at);
    const std::string           problem   = law->problem(constants);
    if (!problem.empty())
      return description.hyperelastic_law + ": " + problem;
    if (!(at.lambda > law->lambda(constants)))
      return description.hyperelastic_law + ": lambda must be above the " +
             std::to_string(law->lambda(constants)) +
             " MPa that the law itself has";
    return "";
  }



  template <int dim>
  FiniteStrain<dim>::FiniteStrain(const MaterialDescription &description)
    : plane_stress(dim == 2 && description.plane_stress)
    , form(all_volumetric_forms().make(description.volumetric_form))
    , law(all_hyperelastic_laws().make(
        description.hyperelastic_law,
        form_of(description, form->is_isochoric())))
    , split(all_finite_splits().make(description.energy_split))
    , pressure_law(all_finite_pressure_laws().make(
        description.pressure_law,
        FinitePressureConstants{description.relaxation,
                                description.residual_stiffness}))
  {
    resists_closure = !split->fades(-1.);
    is_one_constant = law->constant_names().size() == 1;
    if (split->only_stretches_drive && !law->is_sum_over_stretches())
      throw InputError("Energy split = " + description.energy_split +
                       " is for neo-Hooke and Ogden, not for " +
                       description.hyperelastic_law +
                       ", whose energy is no sum over the stretches.");
    const std::string problem =
      description.constants
        ? finite_strain_problem(description, *description.constants)
        : "";
    if (!problem.empty())
      throw InputError(problem + ".");
  }



  template <int dim>
  HyperelasticConstants
  FiniteStrain<dim>::law_constants(const PointConstants &at) const
  {
    HyperelasticConstants constants = at.hyperelastic;
    if (is_one_constant && constants[0] == 0.)
      constants[0] = at.mu;
    return constants;
  }



  template <int dim>
  FiniteModuli
  FiniteStrain<dim>::moduli(const PointConstants &at) const
  {
    const HyperelasticConstants constants = law_constants(at);
    return {law->mu(constants), at.lambda - law->lambda(constants)};
  }



  template <int dim>
  FinitePressureCoefficients
  FiniteStrain<dim>::coefficients(const double          sign,
                                  const double          g,
                                  const PointConstants &at) const
  {
    return pressure_law->coefficients(moduli(at), g, split->fades(sign));
  }



  template <int dim>
  typename FiniteStrain<dim>::Full
  FiniteStrain<dim>::in_space(const Deformation                &deformation,
                              const double                      pressure,
                              const FinitePressureCoefficients &now,
                              const PointConstants             &at,
                              const bool with_tangent) const
  {
    const VolumeMeasure  theta = form->measure(deformation.volume_change);
    HyperelasticResponse shape =
      law->response(deformation, law_constants(at), with_tangent);
    Full result;
    result.coupling = now.volume * theta.first * deformation.cofactor;
    result.stress = now.distortion * shape.stress + pressure * result.coupling;
    result.constraint = now.volume * theta.value - now.compliance * pressure;
    result.constraint_by_pressure = -now.compliance;
    if (!with_tangent)
      return result;
    result.tangent     = now.distortion * shape.tangent;
    const double force = now.volume * pressure;
    add_second_volume_derivative(
      result.tangent, force * theta.first, deformation);
    if (theta.second != 0.)
      add_outer_product(result.tangent,
                        force * theta.second,
                        deformation.cofactor,
                        deformation.cofactor);
    return result;
  }



  // what the body sees of it: the part in the plane, without F_33
  template <int dim>
  ElasticResponse<dim>
  FiniteStrain<dim>::in_body(Full &full, const bool with_tangent) const
  {
    if (with_tangent && plane_stress)
      condense(full.tangent, full.coupling, full.constraint_by_pressure);
    ElasticResponse<dim> result;
    result.constraint             = full.constraint;
    result.constraint_by_pressure = full.constraint_by_pressure;
    FiniteTangent<dim> &finite    = result.finite.emplace();
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
      {
        result.stress[i][j]   = full.stress[i][j];
        finite.coupling[i][j] = full.coupling[i][j];
        if (with_tangent)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int l = 0; l < dim; ++l)
              finite.stress_by_gradient[i][j][k][l] = full.tangent[i][j][k][l];
      }
    return result;
  }



  template <int dim>
  ElasticResponse<dim>
  FiniteStrain<dim>::mixed(const Gradient       &gradient,
                           const double          pressure,
                           const double          g,
                           const PointConstants &at,
                           const bool            with_tangent) const
  {
    const auto deformation = at_pressure(gradient, pressure, g, at);
    if (!deformation)
      return undefined_response<dim>();
    const FinitePressureCoefficients now = coefficients(pressure, g, at);
    Full full = in_space(*deformation, pressure, now, at, with_tangent);
    ElasticResponse<dim> result = in_body(full, with_tangent);
    interpolate(gradient,
                share_of_law(g),
                now.distortion,
                *law,
                law_constants(at),
                result);
    return result;
  }



  template <int dim>
  ElasticResponse<dim>
  FiniteStrain<dim>::eliminated(const Gradient       &gradient,
                                const double          g,
                                const PointConstants &at,
                                const bool            with_tangent) const
  {
    const auto deformation = at_constraint(gradient, g, at);
    if (!deformation)
      return undefined_response<dim>();
    const double theta = form->measure(deformation->volume_change).value;
    const FinitePressureCoefficients now  = coefficients(theta, g, at);
    Full                             full = in_space(
      *deformation, now.volume * theta / now.compliance, now, at, with_tangent);
    if (with_tangent)
      add_outer_product(
        full.tangent, 1. / now.compliance, full.coupling, full.coupling);
    ElasticResponse<dim> result   = in_body(full, with_tangent);
    result.constraint             = 0.;
    result.constraint_by_pressure = 0.;
    result.finite->coupling       = 0.;
    interpolate(gradient,
                share_of_law(g),
                now.distortion,
                *law,
                law_constants(at),
                result);
    return result;
  }



  template class FiniteStrain<2>;
  template class FiniteStrain<3>;
} // namespace MixedCracks
