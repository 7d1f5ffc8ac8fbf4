// SPDX-License-Identifier: GPL-2.0-or-later
// With k the unit axis (z in 2-d), a = x - c and theta the angle, Rodrigues'
// formula:
//
//   u = (R - I) a = sin(theta) k x a + (1 - cos(theta)) k x (k x a),
//
// 1 - cos(theta) = 2 sin(theta/2)^2, which has all its digits for small angles.

#include <base/coordinates.h>
#include <base/errors.h>
#include <base/text.h>

#include <problem/rotation.h>

#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // dim numbers
    template <int dim>
    Tensor<1, dim>
    read_vector(const std::string &text,
                const std::string &words,
                const std::string &parameter)
    {
      const std::vector<double> numbers = parse_numbers(text, parameter);
      if (numbers.size() != dim)
        throw InputError(parameter + ": found " + in_quotes(words) +
                         ", allowed is " + Rotation<dim>::form() + ", with " +
                         std::to_string(dim) + " numbers each.");
      Tensor<1, dim> result;
      set_coordinates(numbers, result);
      return result;
    }



    // the components across the axis, of a twist
    std::vector<unsigned int>
    components_across(const Tensor<1, 3> &axis,
                      const std::string  &words,
                      const std::string  &parameter)
    {
      std::vector<unsigned int> result;
      for (unsigned int d = 0; d < 3; ++d)
        if (axis[d] == 0.)
          result.push_back(d);
      if (result.size() != 2)
        throw InputError(parameter + ": found " + in_quotes(words) +
                         ", a twist that prescribes the two components across "
                         "its axis. Allowed are axes along x, y or z, as in "
                         "'twist about 0, 0, 0 axis 0, 0, 1'.");
      return result;
    }
  } // namespace



  template <int dim>
  std::string
  Rotation<dim>::form()
  {
    return dim == 2 ? "'rotation about 0, 0'"
                    : "'rotation about 0, 0, 0 axis 0, 0, 1' (or 'twist about "
                      "...', with the motion along the axis free)";
  }



  template <int dim>
  std::shared_ptr<const Rotation<dim>>
  Rotation<dim>::read(const std::string &given, const std::string &parameter)
  {
    const std::string words    = single_spaced(given);
    const bool        is_twist = dim == 3 && starts_with(words, "twist");
    if (!is_twist && !starts_with(words, "rotation"))
      return nullptr;
    const std::string begin = is_twist ? "twist about " : "rotation about ";
    const std::size_t at    = words.find("axis");
    if (!starts_with(words, begin) || (at == std::string::npos) != (dim == 2))
      throw InputError(parameter + ": found " + in_quotes(words) +
                       ", allowed is " + form() + ".");
    auto result    = std::make_shared<Rotation<dim>>();
    result->axis   = Tensor<1, 3>({0., 0., 1.});
    result->centre = Point<dim>(read_vector<dim>(
      words.substr(begin.size(), at - begin.size()), words, parameter));
    for (unsigned int d = 0; d < dim; ++d)
      result->prescribed.push_back(d);
    if constexpr (dim == 3)
    {
      const auto axis = read_vector<3>(words.substr(at + 4), words, parameter);
      if (!(axis.norm() > 0.))
        throw InputError(parameter + ": found " + in_quotes(words) +
                         ", an axis of length 0. Allowed is a direction, as "
                         "'0, 0, 1'.");
      result->axis = axis / axis.norm();
      if (is_twist)
        result->prescribed = components_across(axis, words, parameter);
    }
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  Rotation<dim>::displacement(const Point<dim> &point, const double angle) const
  {
    Tensor<1, 3> arm;
    for (unsigned int d = 0; d < dim; ++d)
      arm[d] = point[d] - centre[d];
    const Tensor<1, 3> first  = cross_product_3d(axis, arm);
    const Tensor<1, 3> second = cross_product_3d(axis, first);
    const double       half   = std::sin(0.5 * angle);
    const Tensor<1, 3> sum =
      std::sin(angle) * first + 2. * half * half * second;
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = sum[d];
    return result;
  }



  template class Rotation<2>;
  template class Rotation<3>;
} // namespace MixedCracks
