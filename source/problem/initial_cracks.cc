// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>
#include <core/text.h>

#include <problem/initial_cracks.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string parameter = "Initial cracks/Cracks";

    template <int dim>
    Point<dim>
    read_point(const std::string &text)
    {
      const std::vector<double> numbers = parse_numbers(text, parameter);
      if (numbers.size() != dim)
        throw InputError(parameter + ": found '" + text + "', allowed is " +
                         std::to_string(dim) + " numbers, as '0,1'.");
      Point<dim> point;
      std::copy(numbers.begin(), numbers.end(), point.begin_raw());
      return point;
    }
  } // namespace



  template <int dim>
  void
  InitialCracks<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Initial cracks");
    prm.add_parameter("Cracks",
                      text,
                      "Segments 'x0,y0 : x1,y1 ; ...' along which the phase "
                      "field is 0 at the start: at the nodes within half a "
                      "cell of them. On top of the notch. Unit: mm.");
    prm.add_parameter("Broken slits",
                      broken_slits,
                      "Whether the phase field is 0 on the slits of the mesh "
                      "(notches) at the start. 'false': a slit is a gap "
                      "between cells and no more, as in [Miehe10]; a crack "
                      "then has to nucleate at its tip, which takes more "
                      "load.");
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<Segment<dim>>
  InitialCracks<dim>::segments() const
  {
    std::vector<Segment<dim>> result;
    for (const std::string &entry : split_list(text, ';'))
    {
      const std::vector<std::string> ends = split_list(entry, ':');
      if (ends.size() != 2)
        throw InputError(parameter + ": found '" + entry +
                         "', allowed is 'x0,y0 : x1,y1', several separated "
                         "by ';'.");
      result.push_back({read_point<dim>(ends[0]), read_point<dim>(ends[1])});
    }
    return result;
  }



  template <int dim>
  void
  InitialCracks<dim>::check() const
  {
    segments();
  }



  template <int dim>
  double
  distance(const Point<dim> &point, const Segment<dim> &segment)
  {
    const Tensor<1, dim> axis    = segment.end - segment.begin;
    const double         squared = axis.norm_square();
    double               along   = 0.;
    if (squared > 0.)
      along = std::clamp((point - segment.begin) * axis / squared, 0., 1.);
    return point.distance(segment.begin + along * axis);
  }



  template struct InitialCracks<2>;
  template struct InitialCracks<3>;
  template double distance(const Point<2> &, const Segment<2> &);
  template double distance(const Point<3> &, const Segment<3> &);
} // namespace MixedCracks
