// SPDX-License-Identifier: GPL-2.0-or-later
// Places are found on whatever rank has them by RemotePointEvaluation, those of
// rank 0 alone. On the side of a cell the mean over its neighbours is taken; u
// is continuous, so that this is the value, whatever the number of ranks.

#include <deal.II/base/mpi_remote_point_evaluation.h>

#include <deal.II/numerics/vector_tools.h>

#include <output/front_opening.h>

#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // in l
    constexpr double behind_front = 2.;
    constexpr double beside_sheet = 1.;



    struct Place
    {
      Point<3>     position; // on the sheet
      Tensor<1, 3> normal;
    };

    // Behind a point of the front, moved into the tangent plane at the nearest
    // vertex: a front is straight ahead, a sheet may be curved.
    Place
    place_behind(const FrontPoint &front,
                 const CrackSheet &sheet,
                 const double      distance)
    {
      Place        place{front.position - distance * front.ahead, front.normal};
      double       nearest = std::numeric_limits<double>::infinity();
      unsigned int vertex  = 0;
      for (unsigned int v = 0; v < sheet.vertices.size(); ++v)
        if (const double d = sheet.vertices[v].distance(place.position);
            d < nearest)
        {
          nearest = d;
          vertex  = v;
        }
      if (nearest < distance)
      {
        place.normal = sheet.normals[vertex];
        place.position -=
          ((place.position - sheet.vertices[vertex]) * place.normal) *
          place.normal;
      }
      return place;
    }
  } // namespace



  std::vector<double>
  opening_angles(const Fields<3>               &fields,
                 const LinearAlgebra::Vector   &elastic,
                 const std::vector<CrackSheet> &sheets,
                 const double                   length_scale)
  {
    const double          r = behind_front * length_scale;
    std::vector<Place>    places;
    std::vector<Point<3>> points;
    for (const CrackSheet &sheet : sheets)
      for (const CrackFront &front : sheet.fronts)
        for (const FrontPoint &point : front.points)
        {
          places.push_back(place_behind(point, sheet, r));
          for (const double side : {1., -1.})
            points.push_back(places.back().position + side * beside_sheet *
                                                        length_scale *
                                                        places.back().normal);
        }
    Utilities::MPI::RemotePointEvaluation<3> evaluation;
    const auto                               u = VectorTools::point_values<3>(
      fields.mapping, fields.elastic, elastic, points, evaluation);
    std::vector<double> angles(places.size(),
                               std::numeric_limits<double>::quiet_NaN());
    for (unsigned int i = 0; i < places.size(); ++i)
      if (evaluation.point_found(2 * i) && evaluation.point_found(2 * i + 1))
        angles[i] =
          2. *
          std::atan((u[2 * i] - u[2 * i + 1]) * places[i].normal / (2. * r)) *
          180. / numbers::PI;
    return angles;
  }
} // namespace MixedCracks
