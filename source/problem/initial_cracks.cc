// SPDX-License-Identifier: GPL-2.0-or-later
// Cracks that are there at the start: phi = 0 at the nodes within a band around
// them, and 1 elsewhere. For a segment or penny let (a, b) be the distances of
// a node across the crack and beyond its rim; it is broken if
//
//   max(0, b) <= min(w, h/2)   and   a^2 + max(0, b)^2 <= w^2,
//
// w the half width, h the size of the cells at the node; but for 1e-6 h. So the
// band has round ends as long as w <= h/2, and a wide one is not longer than
// the crack by more than half a cell: its length, and so the load it bears,
// would else depend on w. A disc in the plane is broken all over, whatever w
// is.
//
// Only nodes of the first mesh are set. The profile away from the crack, 1 -
// exp(-d/l) with AT2, is not: step 0 solves for it (LoadStep), which gives the
// discrete minimiser and depends on no formula. With w = h/2 and a crack along
// a grid line one row of nodes is broken and no cell is; w = h makes two rows
// of broken cells.

#include <base/coordinates.h>
#include <base/errors.h>
#include <base/text.h>

#include <problem/geometries/checks.h>
#include <problem/initial_cracks.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string parameter             = "Initial cracks/Cracks";
    const std::string discs_parameter       = "Initial cracks/Discs";
    const std::string phase_field_parameter = "Initial cracks/Phase field";
    const std::string half_width_parameter  = "Initial cracks/Half width";

    // of a cell: what is nearer than that is rounding
    constexpr double rounding = 1e-6;

    // A crack of half the width w, which is drawn over @p beyond at most
    // past its rim: within w of it, but not longer than it by more than half
    // a cell, however wide it is.
    bool
    is_in_band(const double across,
               const double beyond,
               const double half_width,
               const double h)
    {
      const double reach  = half_width + rounding * h;
      const double past   = std::max(0., beyond);
      const double longer = std::min(half_width, 0.5 * h) + rounding * h;
      return past <= longer && across * across + past * past <= reach * reach;
    }

    template <int dim>
    bool
    is_broken(const Point<dim>   &point,
              const Segment<dim> &segment,
              const double        half_width,
              const double        h)
    {
      const Tensor<1, dim> from_begin = point - segment.begin;
      const double         length     = segment.begin.distance(segment.end);
      if (length == 0.)
        return is_in_band(from_begin.norm(), 0., half_width, h);
      const Tensor<1, dim> axis  = (segment.end - segment.begin) / length;
      const double         along = from_begin * axis;
      return is_in_band((from_begin - along * axis).norm(),
                        std::max(-along, along - length),
                        half_width,
                        h);
    }

    template <int dim>
    bool
    is_broken(const Point<dim>     &point,
              const CrackDisc<dim> &disc,
              const double          half_width,
              const double          h)
    {
      const Tensor<1, dim> from_center = point - disc.center;
      if (dim == 2)
        return from_center.norm() <= disc.radius + rounding * h;
      const double across = from_center * disc.normal;
      return is_in_band(across,
                        (from_center - across * disc.normal).norm() -
                          disc.radius,
                        half_width,
                        h);
    }
  } // namespace



  template <int dim>
  void
  InitialCracks<dim>::add_parameters(ParameterHandler &prm)
  {
    const std::string broken =
      " One that breaks no node is refused. On top of the notch. Unit: mm.";
    prm.enter_subsection("Initial cracks");
    prm.add_parameter(
      "Cracks",
      text,
      "Segments 'x0,y0 : x1,y1 ; ...' (3-d: 'x0,y0,z0 : ...'). The phase field "
      "is 0 at the start at the nodes within the half width of them." +
        broken);
    prm.add_parameter("Discs",
                      discs_text,
                      "3-d: penny-shaped cracks 'center : normal : radius ; "
                      "...', as in '0,0,0 : 0,1,0 : 2.5'; 2-d: circles "
                      "'center : radius ; ...'. The phase field is 0 at the "
                      "start at the nodes within the half width of pennies, "
                      "and at those in circles, whatever the half width is." +
                        broken);
    prm.add_parameter(
      "Half width",
      half_width_text,
      "Of the band of broken nodes around segments and pennies, an expression "
      "in h, the size of the cells at the node: with '0.5*h' one row of nodes, "
      "with 'h' two rows of broken cells where the crack is a line of the "
      "mesh. Wide bands are longer than the crack by half a cell at most. "
      "Unit: mm.",
      Patterns::Anything());
    prm.add_parameter("Phase field",
                      phase_field_text,
                      "The phase field at the start, an expression in x, y, z "
                      "and h, the size of the cells at the node; taken between "
                      "0 and 1, and where there is more than one cause, the "
                      "smallest value. Empty: 1. Unit: 1.",
                      Patterns::Anything());
    prm.add_parameter("Broken slits",
                      broken_slits,
                      "Whether the phase field is 0 on the slits of the mesh "
                      "(notches) at the start. 'false': a slit is a gap "
                      "between cells and no more, as in [Miehe10b]; a crack "
                      "then has to nucleate at its tip, which takes more "
                      "load.");
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<Segment<dim>>
  InitialCracks<dim>::segments() const
  {
    std::vector<Segment<dim>> result;
    for (const auto &ends : read_items(
           text, dim == 2 ? "x0,y0 : x1,y1" : "x0,y0,z0 : x1,y1,z1", parameter))
      result.push_back({read_point<dim>(ends[0], parameter),
                        read_point<dim>(ends[1], parameter)});
    return result;
  }



  template <int dim>
  std::vector<CrackDisc<dim>>
  InitialCracks<dim>::discs() const
  {
    std::vector<CrackDisc<dim>> result;
    for (const auto &parts :
         read_items(discs_text,
                    dim == 2 ? "center : radius" : "center : normal : radius",
                    discs_parameter))
    {
      CrackDisc<dim> disc;
      disc.center = read_point<dim>(parts.front(), discs_parameter);
      disc.radius = parse_number(parts.back(), discs_parameter);
      require(disc.radius > 0.,
              discs_parameter + ": the radius " + in_quotes(parts.back()) +
                " must be greater than 0.");
      if (dim == 3)
      {
        disc.normal       = read_point<dim>(parts[1], discs_parameter);
        const double size = disc.normal.norm();
        require(size > 0.,
                discs_parameter + ": the normal " + in_quotes(parts[1]) +
                  " must not be 0.");
        disc.normal /= size;
      }
      result.push_back(disc);
    }
    return result;
  }



  template <int dim>
  void
  InitialCracks<dim>::check() const
  {
    const InitialPhaseField<dim> all_can_be_read(*this);
  }



  template <int dim>
  InitialPhaseField<dim>::InitialPhaseField(const InitialCracks<dim> &cracks)
    : segments(cracks.segments())
    , discs(cracks.discs())
    , half_width(cracks.half_width_text, {"h"}, half_width_parameter)
  {
    if (!single_spaced(cracks.phase_field_text).empty())
      phase_field = std::make_shared<const Expression>(
        cracks.phase_field_text,
        std::vector<std::string>{"x", "y", "z", "h"},
        phase_field_parameter);
    if (!half_width.uses("h"))
      width_for(1.); // else it shows on the mesh
    for (const std::string &each : split_list(cracks.text, ';'))
      crack_names.push_back(parameter + ": found " + in_quotes(each));
    for (const std::string &each : split_list(cracks.discs_text, ';'))
      crack_names.push_back(discs_parameter + ": found " + in_quotes(each));
  }



  template <int dim>
  double
  InitialPhaseField<dim>::width_for(const double h) const
  {
    const double width = half_width({h});
    require(width >= 0.,
            half_width_parameter + ": found '" + half_width.text() +
              "' = " + number_text(width) + " for h = " + number_text(h) +
              " mm; it must not be negative.");
    return width;
  }



  template <int dim>
  double
  InitialPhaseField<dim>::value(const Point<dim> &position,
                                const double      h) const
  {
    const double width = width_for(h);
    for (const Segment<dim> &segment : segments)
      if (is_broken(position, segment, width, h))
        return 0.;
    for (const CrackDisc<dim> &disc : discs)
      if (is_broken(position, disc, width, h))
        return 0.;
    if (!phase_field)
      return 1.;
    const double z = dim == 3 ? position[dim - 1] : 0.;
    return std::clamp((*phase_field)({position[0], position[1], z, h}), 0., 1.);
  }



  template <int dim>
  void
  InitialPhaseField<dim>::note_broken(const Point<dim> &position,
                                      const double      h,
                                      std::vector<int> &breaks) const
  {
    const double width = width_for(h);
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (breaks[i] == 0 && is_broken(position, segments[i], width, h))
        breaks[i] = 1;
    for (std::size_t i = 0; i < discs.size(); ++i)
      if (int &hit = breaks[segments.size() + i];
          hit == 0 && is_broken(position, discs[i], width, h))
        hit = 1;
  }



  template struct InitialCracks<2>;
  template struct InitialCracks<3>;
  template class InitialPhaseField<2>;
  template class InitialPhaseField<3>;
} // namespace MixedCracks
