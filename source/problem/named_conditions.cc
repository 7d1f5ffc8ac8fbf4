// SPDX-License-Identifier: GPL-2.0-or-later
// Lists 'name : condition ; ...' of parts of space, by which boundaries and
// points get names.
//
// A condition that no point meets is a slip of the pen, and the message should
// say where the author may have meant it to be. A formula does not tell how far
// a point is from meeting it, so that it is tried on a grid of points in the
// box around all that were asked and around that box: of the
// places where it holds, those next to a point count,
//
//   min over places p with c(p) != 0 of |x - p|   for each point x.

#include <base/errors.h>
#include <base/text.h>

#include <deal.II/base/bounding_box.h>

#include <discretization/nearest_vertex.h>

#include <problem/named_conditions.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace MixedCracks
{
  using dealii::Point;

  namespace
  {
    // of places along an axis where a condition is tried; odd, so that the
    // middle is among them
    constexpr unsigned int n_tried_2d = 121;
    constexpr unsigned int n_tried_3d = 37;

    // how far around all points it is tried, in lengths of the box around them;
    // farther where it does not hold nearer
    constexpr double extensions[] = {1., 10., 100.};

    // of those where it holds, about as many are looked at
    constexpr std::size_t most_places = 2000;

    constexpr std::size_t n_nearest = 3;



    // what entries that use the names take apart
    void
    require_usable_name(const std::string &name,
                        const std::string &item,
                        const std::string &parameter)
    {
      const bool is_usable =
        begins_as_name(name) && name.find_first_of(",=\"") == std::string::npos;
      if (!is_usable)
        throw InputError(parameter + ": found the name " + in_quotes(name) +
                         " in " + in_quotes(item) +
                         "; allowed are words that begin with a letter and "
                         "have no comma, '=' or quotation mark.");
    }



    template <int dim>
    dealii::BoundingBox<dim>
    surroundings(const std::vector<Point<dim>> &points, const double extension)
    {
      dealii::BoundingBox<dim> box(points);
      double                   length = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        length = std::max(length, box.side_length(d));
      box.extend(extension * length);
      return box;
    }



    template <int dim>
    std::vector<Point<dim>>
    places_where(const NamedCondition<dim>     &condition,
                 const std::vector<Point<dim>> &points,
                 const double                   extension)
    {
      const auto corners =
        surroundings(points, extension).get_boundary_points();
      const unsigned int      n = dim == 2 ? n_tried_2d : n_tried_3d;
      std::vector<Point<dim>> places;
      unsigned int            n_all = 1;
      for (unsigned int d = 0; d < dim; ++d)
        n_all *= n;
      for (unsigned int i = 0; i < n_all; ++i)
      {
        Point<dim>   place;
        unsigned int rest = i;
        for (unsigned int d = 0; d < dim; ++d, rest /= n)
          place[d] = corners.first[d] + (corners.second[d] - corners.first[d]) *
                                          (1. * (rest % n)) / (n - 1.);
        try
        {
          if (condition.holds_at(place))
            places.push_back(place);
        }
        catch (const InputError &)
        {
          // outside of the body it may be no number
        }
      }
      return places;
    }



    template <int dim>
    std::string
    list_in_words(const std::vector<Point<dim>> &points)
    {
      std::string text;
      for (const Point<dim> &point : points)
        text += (text.empty() ? "" : ", ") + in_words(point);
      return text;
    }
  } // namespace



  bool
  begins_as_name(const std::string &text)
  {
    return !text.empty() && !is_digit(text[0]) &&
           std::string("+-.").find(text[0]) == std::string::npos;
  }



  template <int dim>
  bool
  NamedCondition<dim>::holds_at(const Point<dim> &point) const
  {
    return condition({point[0], point[1], dim == 3 ? point[dim - 1] : 0.}) !=
           0.;
  }



  template <int dim>
  std::vector<NamedCondition<dim>>
  parse_named_conditions(const std::string &text, const std::string &parameter)
  {
    std::vector<NamedCondition<dim>> result;
    std::set<std::string>            names;
    for (const std::string &item : split_list(text, ';'))
    {
      const std::size_t colon = item.find(':');
      if (colon == std::string::npos)
        throw InputError(parameter + ": found " + in_quotes(item) +
                         ", allowed is 'name : condition', several separated "
                         "by ';'.");
      const std::string name = single_spaced(item.substr(0, colon));
      require_usable_name(name, item, parameter);
      if (!names.insert(name).second)
        throw InputError(parameter + ": found " + in_quotes(item) +
                         ", a second condition for '" + name +
                         "'. Allowed is one; '||' joins two.");
      result.push_back(
        {name, Expression(item.substr(colon + 1), {"x", "y", "z"}, parameter)});
    }
    return result;
  }



  template <int dim>
  std::vector<Point<dim>>
  nearest_points(const NamedCondition<dim>     &condition,
                 const std::vector<Point<dim>> &points)
  {
    std::vector<Point<dim>> places;
    for (const double extension : extensions)
      if (places.empty())
        places = places_where(condition, points, extension);
    if (places.empty())
      return {};
    const std::size_t stride = 1 + places.size() / most_places;
    std::vector<std::pair<double, Point<dim>>> by_distance;
    for (const Point<dim> &point : points)
    {
      double smallest = std::numeric_limits<double>::max();
      for (std::size_t i = 0; i < places.size(); i += stride)
        smallest = std::min(smallest, places[i].distance_square(point));
      by_distance.emplace_back(smallest, point);
    }
    std::stable_sort(
      by_distance.begin(), by_distance.end(), [](const auto &a, const auto &b) {
        return a.first < b.first;
      });
    std::vector<Point<dim>> nearest;
    for (std::size_t i = 0; i < std::min(n_nearest, by_distance.size()); ++i)
      nearest.push_back(by_distance[i].second);
    return nearest;
  }



  template <int dim>
  std::string
  nearest_in_words(const NamedCondition<dim>     &condition,
                   const std::vector<Point<dim>> &points)
  {
    const std::vector<Point<dim>> nearest = nearest_points(condition, points);
    if (nearest.empty())
    {
      const auto corners =
        dealii::BoundingBox<dim>(points).get_boundary_points();
      return "they lie between " + in_words(corners.first) + " and " +
             in_words(corners.second) + ", the first is " +
             in_words(points.front());
    }
    return std::string(nearest.size() == 1 ? "the nearest is "
                                           : "the nearest are ") +
           list_in_words(nearest);
  }



#define INSTANTIATE(dim)                                             \
  template struct NamedCondition<dim>;                               \
  template std::vector<NamedCondition<dim>> parse_named_conditions(  \
    const std::string &, const std::string &);                       \
  template std::vector<Point<dim>> nearest_points(                   \
    const NamedCondition<dim> &, const std::vector<Point<dim>> &);   \
  template std::string nearest_in_words(const NamedCondition<dim> &, \
                                        const std::vector<Point<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
