// SPDX-License-Identifier: GPL-2.0-or-later
// Entries of the model: which equations are solved (doc/model.md names them M1
// to M10). l and kappa may be expressions in
//
//   h = mean of measure^(1/dim) over the finest cells of the first mesh  (mm),
//
// so that "2*h" keeps l/h while the mesh is refined from case to case. They are
// evaluated once there is a mesh and stay when it is adapted.
//
// Plane stress is a material of its own: lambda is replaced by 2 lambda
// mu/(lambda + 2 mu) (M6), and deviators are those of the plane, n = 2. Plane
// strain has the deviator of space, n = 3, unless n is given.

#include <base/errors.h>
#include <base/expression.h>

#include <deal.II/base/patterns.h>

#include <problem/model_parameters.h>

#include <limits>
#include <sstream>

namespace MixedCracks
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    const double tiny = std::numeric_limits<double>::min();

    const std::string length_scale_name       = "Model/Length scale";
    const std::string residual_stiffness_name = "Model/Residual stiffness";

    // what the equations are
    void
    add_equations(dealii::ParameterHandler &prm, ModelParameters &model)
    {
      prm.add_parameter("Formulation",
                        model.formulation,
                        "Unknowns: 'mixed': displacement u, pressure p and "
                        "phase field phi, for nearly incompressible solids; "
                        "'displacement': u and phi, which locks there.",
                        Patterns::Selection("mixed|displacement"));
      prm.add_parameter("Displacement degree",
                        model.displacement_degree,
                        "Polynomial degree of u; 'auto': 2 in the mixed "
                        "formulation (Taylor-Hood with p of degree 1), 1 in "
                        "the displacement formulation.",
                        Patterns::Selection("auto|1|2"));
      prm.add_parameter("Kinematics",
                        model.kinematics,
                        "'plane strain': lambda, mu as given; 'plane stress': "
                        "lambda* = 2 lambda mu/(lambda + 2 mu) in place of "
                        "lambda (M6), at finite strain F_33 from P_33 = 0 at "
                        "each point (M14). Ignored in 3-d.",
                        Patterns::Selection("plane strain|plane stress"));
      prm.add_parameter("Crack density",
                        model.crack_density,
                        "Crack surface density gamma = a(phi)/l + b l "
                        "|grad phi|^2 (M1). " +
                          all_crack_densities().documentation(),
                        Patterns::Selection(all_crack_densities().selection()));
      prm.add_parameter(
        "Length scale",
        model.length_scale,
        "The length l of the crack density (epsilon in the paper): a number or "
        "an expression in h, as '2*h'. h is the edge of the finest cells of the "
        "first mesh, the mean of (measure)^(1/dim), and stays when the mesh is "
        "adapted. A program whose h is the diagonal of a cell has sqrt(dim) h "
        "in its place, one that counts k levels of adaptation in has h/2^k: "
        "there '4*h' on the diagonal of the last mesh is "
        "'4*sqrt(2)*h/2^k' here in 2-d. Unit: mm.",
        Patterns::Anything());
      prm.add_parameter(
        "Residual stiffness",
        model.residual_stiffness,
        "kappa of g(phi) = (1 - kappa) phi^2 + kappa, from 0 to below 1: a "
        "number or an expression in h, the edge of the finest cells of the "
        "first mesh as in Model/Length scale, as '0.01*h'. With 0, broken "
        "cells have no stiffness at all: the matrix may be singular, and the "
        "linear solver has to be a direct one. Unit: 1.",
        Patterns::Anything());
    }

    // how tension and compression differ
    void
    add_split(dealii::ParameterHandler &prm, ModelParameters &model)
    {
      prm.add_parameter(
        "Energy split",
        model.energy_split,
        "Which part of the stress drives the crack and is degraded (M3), "
        "(M4); (M13), (M15) at finite strain, where it has to be set. " +
          documentation(energy_split_choices()),
        Patterns::Selection(selection(energy_split_choices())));
      prm.add_parameter("Deviator dimension",
                        model.deviator_dimension,
                        "n of (M3): eps - tr(eps)/n I; 'auto': 3 in plane "
                        "strain, 2 in plane stress. Ignored in 3-d, where it "
                        "is 3, and at finite strain.",
                        Patterns::Selection("auto|2|3"));
      prm.add_parameter(
        "Pressure law",
        model.pressure_law,
        "How the pressure fades where the material is damaged; at finite "
        "strain 'relaxed bulk' is (M13), with J - 1 in place of div u. " +
          documentation(pressure_law_choices()),
        Patterns::Selection(selection(pressure_law_choices())));
      prm.add_parameter("Relaxation constant",
                        model.relaxation,
                        "c of (M8) and (M13), 1/lambda_d = 1/lambda + "
                        "(1-g)/(g c mu); only for 'relaxed bulk'. Unit: 1.",
                        Patterns::Double(tiny));
    }

    // Whether a value can only be known with the mesh. Throws InputError for
    // what is no expression.
    bool
    depends_on_h(const std::string &text, const std::string &parameter)
    {
      return Expression(text, {"h"}, parameter).uses("h");
    }

    // @p allowed in words
    double
    evaluate_in_h(const std::string &text,
                  const std::string &parameter,
                  const double       h,
                  bool (*const is_allowed)(double value),
                  const std::string &allowed)
    {
      const double value = Expression(text, {"h"}, parameter)({h});
      if (is_allowed(value))
        return value;
      std::ostringstream message;
      message << parameter << ": '" << text << "' is " << value;
      if (depends_on_h(text, parameter))
        message << " for h = " << h << " mm, the edge of the finest cells of "
                << "the first mesh";
      message << "; allowed is " << allowed << ".";
      throw InputError(message.str());
    }
  } // namespace



  void
  ModelParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Model");
    add_equations(prm, *this);
    strain.add_parameters(prm);
    add_split(prm, *this);
    prm.leave_subsection();
  }



  void
  ModelParameters::check(const int dim) const
  {
    if (mixed() && displacement_degree == "1")
      throw InputError("Model/Displacement degree: found 1 with "
                       "Model/Formulation = mixed; the pair Q1-Q1 for u and p "
                       "is not stable. Allowed: auto, 2.");
    strain.check(energy_split, pressure_law);
    if (is_plane_stress(dim) && !strain.is_finite() &&
        deviator_dimension == "3")
      throw InputError("Model/Deviator dimension: found 3 with "
                       "Model/Kinematics = plane stress, whose law acts in the "
                       "plane. Allowed: auto, 2.");
    // h is not known yet: the others are looked at when there is a mesh
    if (!depends_on_h(length_scale, length_scale_name))
      evaluate_length_scale(1.);
    if (!depends_on_h(residual_stiffness, residual_stiffness_name))
      evaluate_residual_stiffness(1.);
  }



  unsigned int
  ModelParameters::degree() const
  {
    if (displacement_degree == "auto")
      return mixed() ? 2 : 1;
    return displacement_degree == "1" ? 1 : 2;
  }



  int
  ModelParameters::deviator(const int dim) const
  {
    if (dim == 3)
      return 3;
    if (deviator_dimension == "auto")
      return kinematics == "plane stress" ? 2 : 3;
    return deviator_dimension == "2" ? 2 : 3;
  }



  ElasticConstants
  ModelParameters::in_kinematics(const ElasticConstants &constants,
                                 const int               dim) const
  {
    return is_plane_stress(dim) && !strain.is_finite() ? plane_stress(constants)
                                                       : constants;
  }



  PointConstants
  ModelParameters::at_point(const MaterialValues &values, const int dim) const
  {
    const ElasticConstants elastic = in_kinematics(values.elastic, dim);
    return {elastic.lambda,
            elastic.mu,
            values.critical_energy_release_rate,
            values.hyperelastic};
  }



  double
  ModelParameters::evaluate_length_scale(const double h) const
  {
    return evaluate_in_h(
      length_scale,
      length_scale_name,
      h,
      [](const double value) { return value > 0.; },
      "a positive number");
  }



  double
  ModelParameters::evaluate_residual_stiffness(const double h) const
  {
    return evaluate_in_h(
      residual_stiffness,
      residual_stiffness_name,
      h,
      [](const double value) { return value >= 0. && value < 1.; },
      "a number from 0, and below 1");
  }



  MaterialDescription
  describe_material(const ModelParameters    &model,
                    const MaterialParameters &material,
                    const int                 dim,
                    const double              h)
  {
    MaterialDescription description;
    if (!material.varies())
      description.constants = model.at_point(material.uniform_values(), dim);
    description.length_scale       = model.evaluate_length_scale(h);
    description.residual_stiffness = model.evaluate_residual_stiffness(h);
    description.relaxation         = model.relaxation;
    description.deviator_dimension = model.deviator(dim);
    description.crack_density      = model.crack_density;
    description.energy_split       = model.energy_split;
    description.pressure_law       = model.pressure_law;
    description.strains            = model.strain.strains();
    description.hyperelastic_law   = model.strain.law;
    description.volumetric_form    = model.strain.volumetric_form;
    description.plane_stress       = model.is_plane_stress(dim);
    description.largest_stretch    = model.strain.largest_stretch;
    return description;
  }
} // namespace MixedCracks
