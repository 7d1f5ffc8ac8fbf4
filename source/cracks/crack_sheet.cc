// SPDX-License-Identifier: GPL-2.0-or-later
// Cracks as sheets, from the ridge of damage. l: length scale, h: cell size; in
// brackets the CrackSheetOptions.
//
//   1. mesh      corners at one place are one vertex, neighbours turned alike
//                                                             sheet_mesh.cc
//   2. contour   without what has phi > 0.5 [connected], and parts without
//                phi < 0.3 [broken]: its new sides C
//   3. front     without what is nearer to C than [tip_lag]; its new sides are
//                the front                              crack_sheet_front.cc
//   4. parts     within 1.5 h of each other are one crack, if their area is
//                larger than l^2 [smallest] and than l/2 [narrowest] times the
//                length of the fronts
//   5. origin    the boundary within 3 l of the first nucleus within 3 l; of an
//                initial crack, which has its nucleus at the front where it
//                begins to grow, the boundary among those it meets whose sides
//                are farthest from there, in the mean
//
// 2 and 3 are what crack_path.cc does at a tip in the plane, with the distance
// of phi = 0.5 from a crack that the optimal profile has. There is no C, and
// the sheet is whole, where phi < 0.5 up to the boundary: a front that near has
// reached it. Distances are straight, a sheet is bent little on that way.

#include <base/names.h>
#include <base/ranges.h>

#include <cracks/crack_path.h>
#include <cracks/crack_sheet.h>
#include <cracks/crack_sheet_front.h>
#include <cracks/sheet_mesh.h>

#include <algorithm>
#include <limits>
#include <set>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // in h: gaps where cells have hanging nodes
    constexpr double one_crack = 1.5;
    // in l: damage belongs to what it is nearer to
    constexpr double near_in_space = 3.;



    // What is open at boundaries, by the name; at least h/2 long in all.
    struct BoundarySides
    {
      std::map<std::string, double>                 lengths; // mm
      std::vector<std::pair<Point<3>, std::string>> middles;
    };

    BoundarySides
    boundary_sides(const SheetMesh                      &mesh,
                   const std::vector<SheetMesh::SideOf> &open,
                   const std::set<unsigned int>         &members,
                   const CrackSheetOptions              &options)
    {
      BoundarySides sides;
      for (const SheetMesh::SideOf &side : open)
      {
        const int kind = mesh.kind(side);
        if (members.count(side.triangle) == 0 || kind < 0)
          continue;
        const auto        found = options.boundary_names.find(kind);
        const std::string name =
          found == options.boundary_names.end() ? "boundary" : found->second;
        const auto ends = mesh.ends(side);
        sides.lengths[name] += mesh.length(side);
        sides.middles.emplace_back(
          0.5 * (ends.first + Tensor<1, 3>(ends.second)), name);
      }
      return sides;
    }



    // The middles of the sides at a boundary, the one nearest to the mean of
    // them first; of those that are equally near but for @p tolerance, mm, the
    // first, whatever the rounding.
    std::vector<Point<3>>
    contact_with(const std::string   &name,
                 const BoundarySides &sides,
                 const double         tolerance)
    {
      std::vector<Point<3>> points;
      Point<3>              mean;
      for (const auto &[middle, other] : sides.middles)
        if (other == name)
        {
          points.push_back(middle);
          mean += middle;
        }
      mean /= static_cast<double>(points.size());
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].distance(mean) <
            points[nearest].distance(mean) - tolerance)
          nearest = i;
      std::swap(points[0], points[nearest]);
      return points;
    }



    // The boundary nearest to a point within a distance, a notch before others;
    // or empty.
    std::string
    boundary_near(const Point<3>      &point,
                  const BoundarySides &sides,
                  const double         distance)
    {
      std::string found;
      double      nearest = distance;
      for (const bool notches : {true, false})
      {
        for (const auto &[middle, name] : sides.middles)
          if (is_notch(name) == notches && middle.distance(point) < nearest)
          {
            nearest = middle.distance(point);
            found   = name;
          }
        if (!found.empty())
          break;
      }
      return found;
    }



    // where an initial crack comes from that grows at @p nucleus
    std::string
    root_of_initial_crack(const Point<3>          &nucleus,
                          const BoundarySides     &sides,
                          const CrackSheetOptions &options)
    {
      PointBoxes boxes(one_crack * options.cell_size);
      for (unsigned int i = 0; i < options.initial.size(); ++i)
        boxes.add(options.initial[i], i);
      std::map<std::string, std::pair<double, unsigned int>> distances;
      for (const auto &[middle, name] : sides.middles)
      {
        bool is_initial = false;
        boxes.near(middle, [&, &place = middle](const unsigned int i) {
          is_initial = is_initial || options.initial[i].distance(place) <
                                       one_crack * options.cell_size;
        });
        if (!is_initial)
          continue;
        distances[name].first += middle.distance(nucleus);
        ++distances[name].second;
      }
      std::string root    = "interior";
      double      largest = 0.;
      for (const auto &[name, sum] : distances)
        if (sum.first > largest * sum.second)
        {
          largest = sum.first / sum.second;
          root    = name;
        }
      return root;
    }



    std::string
    start_of(const CrackSheet        &sheet,
             const BoundarySides     &sides,
             const CrackSheetOptions &options)
    {
      const double near = near_in_space * options.length_scale;
      for (const Point<3> &nucleus : options.nuclei)
        for (const Point<3> &vertex : sheet.vertices)
          if (vertex.distance(nucleus) < near)
          {
            const std::string name = boundary_near(nucleus, sides, near);
            if (!is_notch(name) && contains(options.initial, nucleus))
              return root_of_initial_crack(nucleus, sides, options);
            return name.empty() ? "interior" : name;
          }
      for (const std::string &name : sheet.boundaries)
        if (is_notch(name))
          return name;
      return "";
    }



    // triangles and vertices of a part, with normals
    CrackSheet
    sheet_of(const SheetMesh &mesh, const std::vector<unsigned int> &members)
    {
      CrackSheet                           sheet;
      std::map<unsigned int, unsigned int> numbers;
      for (const unsigned int t : members)
      {
        const SheetMesh::Triangle  &triangle = mesh.triangles[t];
        const Tensor<1, 3>          normal   = mesh.area_vector(triangle);
        std::array<unsigned int, 3> own;
        for (unsigned int i = 0; i < 3; ++i)
        {
          const auto [found, is_new] = numbers.try_emplace(
            triangle.vertices[i],
            static_cast<unsigned int>(sheet.vertices.size()));
          if (is_new)
          {
            sheet.vertices.push_back(mesh.vertices[triangle.vertices[i]]);
            sheet.normals.emplace_back();
          }
          own[i] = found->second;
          sheet.normals[own[i]] += normal;
        }
        sheet.triangles.push_back(own);
        sheet.area += normal.norm();
      }
      for (Tensor<1, 3> &normal : sheet.normals)
        normal /= std::max(normal.norm(), std::numeric_limits<double>::min());
      return sheet;
    }



    // Where the ridge ends in material that is not broken before the contour is
    // reached, its end is the contour. Ends in broken material are gaps at
    // hanging nodes.
    void
    close_contour(const std::vector<double> &phase_field,
                  const CrackSheetOptions   &options,
                  SheetMesh                 &mesh)
    {
      for (const SheetMesh::SideOf &side : mesh.open_sides())
      {
        SheetMesh::Triangle &triangle = mesh.triangles[side.triangle];
        const auto           is_there = [&](const unsigned int i) {
          const unsigned int vertex = triangle.vertices[i % 3];
          return vertex >= phase_field.size() ||
                 phase_field[vertex] > options.broken;
        };
        if (mesh.kind(side) == RidgeTriangle::inside && is_there(side.number) &&
            is_there(side.number + 1))
          triangle.sides[side.number] = SheetMesh::cut_side;
      }
    }



    // what hangs together with a broken place: a contour elsewhere is none of a
    // crack
    SheetMesh
    broken_parts(const SheetMesh           &mesh,
                 const std::vector<double> &phase_field,
                 const CrackSheetOptions   &options)
    {
      std::vector<unsigned int> broken;
      for (const auto &members : mesh.parts(0.1 * options.cell_size))
        if (any_of(members, [&](const unsigned int t) {
              const auto &v = mesh.triangles[t].vertices;
              return any_of(v, [&](const unsigned int vertex) {
                return vertex < phase_field.size() &&
                       phase_field[vertex] < options.broken;
              });
            }))
          append(broken, members);
      std::sort(broken.begin(), broken.end());
      return mesh.only(broken);
    }



    // cut where the contour is, and again behind it
    SheetMesh
    cut_at_front(const SheetMesh           &whole,
                 const std::vector<double> &phase_field,
                 const CrackSheetOptions   &options)
    {
      std::vector<double> intact;
      for (const double value : phase_field)
        intact.push_back(-value);
      SheetMesh connected = broken_parts(
        whole.above(intact, -options.connected), phase_field, options);
      close_contour(phase_field, options, connected);
      const double lag = options.tip_lag * options.length_scale;
      return connected.above(
        distances_to_cut(connected, lag + 2. * options.cell_size), lag);
    }
  } // namespace



  double
  CrackSheet::front_length() const
  {
    double sum = 0.;
    for (const CrackFront &front : fronts)
      sum += front.length;
    return sum;
  }



  std::string
  CrackSheet::joins() const
  {
    std::vector<std::string> words;
    if (!start.empty() && start != "interior")
      words.push_back(start);
    for (const std::string &name : boundaries)
      if (name != start)
        words.push_back(name);
    if (!fronts.empty())
      words.emplace_back("tip");
    return join_names(words, " to ");
  }



  std::vector<CrackSheet>
  trace_sheets(const std::vector<RidgeTriangle> &ridge,
               const CrackSheetOptions          &options)
  {
    const double l = options.length_scale, h = options.cell_size;
    if (ridge.empty())
      return {};
    std::vector<double> phase_field;
    const SheetMesh     whole(ridge, h, phase_field);
    SheetMesh           mesh = cut_at_front(whole, phase_field, options);
    mesh.turn_alike();
    const std::vector<SheetMesh::SideOf> open = mesh.open_sides();
    std::vector<CrackSheet>              sheets;
    for (const std::vector<unsigned int> &members : mesh.parts(one_crack * h))
    {
      CrackSheet sheet = sheet_of(mesh, members);
      if (!(sheet.area > options.smallest * l * l))
        continue;
      const std::set<unsigned int> set(members.begin(), members.end());
      const BoundarySides sides = boundary_sides(mesh, open, set, options);
      for (const auto &[name, length] : sides.lengths)
        if (length > 0.5 * h)
        {
          sheet.boundaries.push_back(name);
          sheet.contacts.push_back(contact_with(name, sides, 0.01 * h));
        }
      sheet.fronts = fronts_of(mesh, open, set, options);
      if (sheet.area < options.narrowest * l * sheet.front_length())
        continue;
      sheet.start = start_of(sheet, sides, options);
      sheets.push_back(sheet);
    }
    std::stable_sort(sheets.begin(),
                     sheets.end(),
                     [](const CrackSheet &a, const CrackSheet &b) {
                       return a.area > (1. + 1e-6) * b.area;
                     });
    return sheets;
  }
} // namespace MixedCracks
