// SPDX-License-Identifier: GPL-2.0-or-later
// Orders of magnitude that are known before anything is solved, compared with
// each other. An even bar of Young's modulus E breaks at (model/strength.cc)
//
//   sigma_c = c sqrt(E G_c/l)   (MPa),    eps_c = e sqrt(G_c/(l E)),
//
// c = 0.612 AT1, 0.325 AT2, 0.798 Wu with g = phi^2. With U the largest
// prescribed displacement and L the largest extent of the body, a load is
// measured by
//
//   max( (U/L)/eps_c, tau/sigma_c, P/(A sigma_c) ),  a fluid by  p_f/sigma_c,
//
// P a force at a point and A the smallest section of the box.
//
// Above 1 after one onset step, or 100 until the end time (a fluid: 3), numbers
// or units are wrong. Below 1e-3 nothing breaks. Bounds are far from what a
// sensible case has: notches raise the stress, and a body of another shape than
// a bar has other strains than U/L.
//
// Where the material varies, the extremes of E and G_c are combined, as if they
// met at one point: warnings are about what is wrong everywhere.
//
// Afterwards, with gamma the crack density and a(0) what a(phi) is where
// broken,
//
//   share = integral of gamma / (a(0)/l * volume):
//
// 1 is phi = 0 in the whole body, an energy no crack has; above 1/2 it broke as
// a whole.

#include <base/finite_text.h>
#include <base/log.h>

#include <model/strength.h>

#include <simulation/simulation_plausibility.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // With l above this part of the width, phi stays below 1 from one side of
    // the body to the other wherever it is cracked.
    constexpr double widest_length_scale = 0.5;

    // Cells of l/50 take 2500 times as many as those of l, and say the same.
    constexpr double finest_resolution = 50.;

    // Strains at which a material of small strains breaks; 1 to 5 are those of
    // rubber.
    constexpr double smallest_strain = 1e-6;
    constexpr double largest_strain  = 10.;

    // Loads over strength at the end of a run: notched bodies break at 0.01 to
    // 1, and end times are often generous.
    constexpr double far_too_large = 100.;
    constexpr double far_too_small = 1e-3;

    // beyond, material breaks all around a pressurised crack (M10)
    constexpr double largest_fluid_pressure = 3.;

    // loads need not grow with time
    constexpr unsigned int n_times = 32;

    std::string
    in_words(const Range &range)
    {
      const double smallest = printable(range.smallest);
      const double largest  = printable(range.largest);
      return !range.varies() ? format("%.3g", smallest)
                             : format("%.3g to %.3g", smallest, largest);
    }

    // without a fluid, which acts in cracks only
    double
    over_strength(const LoadSize &load,
                  const double    stress,
                  const double    strain)
    {
      return std::max(
        {load.strain / strain, load.traction / stress, load.points / stress});
    }

    double
    over_strongest(const CaseScales &scales, const LoadSize &load)
    {
      return over_strength(
        load, scales.strength.stress.largest, scales.strength.strain.largest);
    }

  } // namespace



  ImpliedStrength
  implied_strength(const std::string   &crack_density,
                   const std::string   &degradation,
                   const MaterialRange &material,
                   const double         length_scale)
  {
    const Strength relative =
      relative_strength(*all_crack_densities().make(crack_density),
                        *all_degradations().make(degradation, /*kappa=*/0.));
    const auto modulus = [](const double lambda, const double mu) {
      // the larger numbers last, whose product may overflow
      return mu / (lambda + mu) * (3. * lambda + 2. * mu);
    };
    const Range  E{modulus(material.lambda.smallest, material.mu.smallest),
                  modulus(material.lambda.largest, material.mu.largest)};
    const Range &G_c    = material.critical_energy_release_rate;
    const auto   stress = [&](const double E, const double G_c) {
      return relative.stress * std::sqrt(E) * std::sqrt(G_c / length_scale);
    };
    const auto strain = [&](const double E, const double G_c) {
      return relative.strain * std::sqrt(G_c / length_scale) / std::sqrt(E);
    };
    return {crack_density,
            relative.stress,
            {stress(E.smallest, G_c.smallest), stress(E.largest, G_c.largest)},
            {strain(E.largest, G_c.smallest), strain(E.smallest, G_c.largest)}};
  }



  ImpliedStrength
  implied_strength(const MaterialDescription &rubber,
                   const double               critical_energy_release_rate,
                   const double               length_scale)
  {
    const RubberStrength strength = rubber_strength(
      RubberBar(rubber),
      *all_crack_densities().make(rubber.crack_density),
      *all_degradations().make(rubber.degradation, /*kappa=*/0.),
      critical_energy_release_rate / length_scale);
    const double strain = strength.stretch - 1.;
    return {rubber.crack_density,
            0.,
            {strength.stress, strength.stress},
            {strain, strain},
            rubber.hyperelastic_law == "neo-Hooke"
              ? std::numeric_limits<double>::infinity()
              : rubber.largest_stretch};
  }



  std::string
  warning_about_decline(const MaterialDescription &rubber)
  {
    const auto declines =
      RubberBar(rubber).stretch_of_decline(rubber.largest_stretch);
    if (!declines)
      return "";
    return format("the nominal stress of a bar of this %s law declines from "
                  "the stretch %.3g on, within Model/Largest stretch = %.4g: "
                  "a body under dead loads may neck there; check "
                  "Material/Hyperelastic constants",
                  rubber.hyperelastic_law.c_str(),
                  *declines,
                  rubber.largest_stretch);
  }



  std::string
  in_words(const ImpliedStrength &strength)
  {
    if (strength.stretch_of_use)
      return format("strength of an even bar with %s at finite strain: a "
                    "nominal stress of ",
                    strength.crack_density.c_str()) +
             in_words(strength.stress) +
             format(" MPa, at the stretch %.3g",
                    printable(1. + strength.strain.largest));
    return format("strength of an even bar with %s: sigma_c = %.3g "
                  "sqrt(E G_c/l) = ",
                  strength.crack_density.c_str(),
                  strength.factor) +
           in_words(strength.stress) + " MPa, at a strain of " +
           in_words(strength.strain);
  }



  template <int dim>
  CaseScales
  case_scales(const Parameters<dim>  &parameters,
              const BoundingBox<dim> &body,
              const ImpliedStrength  &strength,
              const double            length_scale,
              const double            cell_size)
  {
    CaseScales scales;
    scales.length_scale = length_scale;
    scales.cell_size    = cell_size;
    std::vector<double> extents;
    for (unsigned int d = 0; d < dim; ++d)
      extents.push_back(body.side_length(d));
    std::sort(extents.begin(), extents.end());
    scales.width               = extents[dim - 2];
    scales.strength            = strength;
    const LoadParameters &load = parameters.load;
    scales.onset_step          = load.onset_step;
    scales.first               = load_size(parameters, body, load.onset_step);
    for (unsigned int i = 0; i <= n_times; ++i)
    {
      const LoadSize now =
        load_size(parameters, body, i * load.end_time / n_times);
      scales.largest.strain   = std::max(scales.largest.strain, now.strain);
      scales.largest.traction = std::max(scales.largest.traction, now.traction);
      scales.largest.fluid    = std::max(scales.largest.fluid, now.fluid);
      scales.largest.points   = std::max(scales.largest.points, now.points);
      scales.largest.is_known = scales.largest.is_known && now.is_known;
    }
    return scales;
  }



  namespace
  {
    void
    add_lengths(const CaseScales &scales, std::vector<std::string> &warnings)
    {
      if (scales.length_scale > widest_length_scale * scales.width)
        warnings.push_back(
          format("l = %.4g mm in a body %.4g mm wide: one crack damages the "
                 "whole of it; Model/Length scale shall be small against the "
                 "body",
                 scales.length_scale,
                 scales.width));
      const double resolution = scales.length_scale / scales.cell_size;
      if (resolution > finest_resolution)
        warnings.push_back(
          format("l/h = %.4g: 4 to 10 cells resolve a crack; is Model/Length "
                 "scale = %.4g mm meant?",
                 printable(resolution),
                 scales.length_scale));
    }



    // one that is never reached is no matter
    void
    add_far_strains(const CaseScales         &scales,
                    std::vector<std::string> &warnings)
    {
      const ImpliedStrength &strength = scales.strength;
      const double           farthest = strength.stretch_of_use
                                          ? *strength.stretch_of_use - 1.
                                          : largest_strain;
      const double           reached  = over_strength(
        scales.largest, strength.stress.smallest, strength.strain.smallest);
      if (!(strength.strain.smallest > farthest) || !(reached > far_too_small))
        return;
      warnings.push_back(
        in_words(strength) +
        (strength.stretch_of_use
           ? format(", beyond Model/Largest stretch = %.4g, from where on the "
                    "law goes on as neo-Hooke",
                    *strength.stretch_of_use)
           : std::string(", far beyond small strains; check Critical energy "
                         "release rate, moduli and Length scale")));
    }



    void
    add_loads(const CaseScales &scales, std::vector<std::string> &warnings)
    {
      const double first = over_strongest(scales, scales.first);
      const double most  = over_strongest(scales, scales.largest);
      // a body under more than it bears in its first step breaks as a whole,
      // and no step is short enough to see how
      const bool at_once = first > 1.;
      if (!at_once && !(most > far_too_large))
        return;
      warnings.push_back(
        in_words(at_once ? scales.first : scales.largest) +
        (at_once ? format(" after one onset step of %.4g s", scales.onset_step)
                 : std::string(" until the end time")) +
        format(" are %.3g times what the material bears (",
               printable(at_once ? first : most)) +
        in_words(scales.strength) +
        "): the body breaks as a whole; check Critical energy release rate, "
        "moduli, Length scale and units (N/mm, MPa, mm)");
    }
  } // namespace



  std::vector<std::string>
  warnings_about(const CaseScales &scales)
  {
    std::vector<std::string> warnings;
    const ImpliedStrength   &strength = scales.strength;
    add_lengths(scales, warnings);
    if (strength.strain.largest < smallest_strain)
      warnings.push_back(in_words(strength) +
                         ", less than any material bears; check Critical "
                         "energy release rate, moduli and Length scale");
    add_far_strains(scales, warnings);
    add_loads(scales, warnings);
    const double fluid = scales.largest.fluid / strength.stress.largest;
    if (fluid > largest_fluid_pressure)
      warnings.push_back(
        format("Fluid/Pressure reaches %.3g times the strength (",
               printable(fluid)) +
        in_words(strength) +
        "): material breaks all around a crack that it acts in");
    return warnings;
  }



  std::string
  remark_about(const CaseScales &scales)
  {
    const ImpliedStrength &strength = scales.strength;
    const double           most     = std::max(
      over_strength(
        scales.largest, strength.stress.smallest, strength.strain.smallest),
      scales.largest.fluid / strength.stress.smallest);
    if (!scales.largest.is_known || most == 0. || !(most < far_too_small))
      return "";
    return in_words(scales.largest) +
           format(" until the end time are %.2g of that: nothing will break",
                  most);
  }



  double
  damaged_share(const double        crack_surface,
                const double        body_size,
                const double        length_scale,
                const CrackDensity &density)
  {
    return crack_surface * length_scale / (density.local(0.) * body_size);
  }



  std::string
  damage_in_words(const std::vector<double> &shares, const double length_scale)
  {
    const auto found =
      std::find_if(shares.begin(), shares.end(), [](const double share) {
        return share > largest_damaged_share;
      });
    if (found == shares.end())
      return "";
    const auto step    = static_cast<unsigned int>(found - shares.begin());
    const int  percent = static_cast<int>(std::round(100. * *found));
    if (step == 0)
      return format("damage fills %d %% of the body in step 0, before it is "
                    "loaded further: Model/Length scale = %.4g mm is too "
                    "large for it, or it is broken by Initial cracks or by "
                    "what is applied at t = 0",
                    percent,
                    length_scale);
    return format("damage fills %d %% of the body after step %u, %d %% "
                  "before it: the body broke as a whole, not along cracks; "
                  "Model/Length scale = %.4g mm is too large for it, or "
                  "Critical energy release rate too small",
                  percent,
                  step,
                  static_cast<int>(std::round(100. * *(found - 1))),
                  length_scale);
  }



#define INSTANTIATE(dim)                                    \
  template CaseScales case_scales(const Parameters<dim> &,  \
                                  const BoundingBox<dim> &, \
                                  const ImpliedStrength &,  \
                                  double,                   \
                                  double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
