// SPDX-License-Identifier: GPL-2.0-or-later
// Rigid motions that supports leave free: the kernel of the constraints among
// all rigid motions, so that a singular matrix is named before it is
// factorised.
//
// For one part the motion is u(x) = shift + omega x arm, arm = (x -
// middle)/size, m = 3 numbers in the plane (omega, shift), 6 in space. A held
// component d of a point x is one equation in these,
//
//   plane   u_x = shift_x - omega arm_y,   u_y = shift_y + omega arm_x
//   space   u_d = shift_d + omega_next arm_last - omega_last arm_next,
//
// d, next, last cyclic. Parts that are hinged at x share u(x): dim equations
// between the m numbers of both. So do images on periodic sides, u(x') = u(x):
// they leave translations and, of one pair in space, the rotation about the
// vector between its sides. All rows of a group span a space, its kernel
// are the free motions; in reduced echelon form with the rotations first, rows
// that begin with a translation are pure translations, so that they can be
// named one by one.
//
// A rotation is named by its axis: with omega /= 0, the point where u = 0 is
//
//   plane   arm = (-shift_y, shift_x)/omega
//   space   arm = omega x shift/|omega|^2; what omega . shift /= 0 leaves is a
//           motion along the axis: a screw.

#include <base/log.h>
#include <base/names.h>

#include <deal.II/base/mpi.h>

#include <discretization/body_parts.h>
#include <discretization/free_motions.h>
#include <discretization/nearest_vertex.h>
#include <discretization/part_images.h>
#include <discretization/row_space.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // more parts that hang together by vertices are not looked at
    constexpr std::size_t most_parts = 100;

    // Rotations come before translations: see name_motions().
    template <int dim>
    constexpr unsigned int n_rotations = dim *(dim - 1) / 2;
    template <int dim>
    constexpr unsigned int n_modes = dim + n_rotations<dim>;



    // Motions are measured from the middle of the body, in units of its size.
    template <int dim>
    struct Frame
    {
      Point<dim> middle;
      double     size;

      // what a component of the displacement at a point is for each mode
      std::array<double, n_modes<dim>>
      row(const Point<dim> &point, const unsigned int component) const
      {
        const Tensor<1, dim>             arm = (point - middle) / size;
        std::array<double, n_modes<dim>> result{};
        result[n_rotations<dim> + component] = 1.;
        if constexpr (dim == 2)
          result[0] = component == 0 ? -arm[1] : arm[0];
        else
        {
          // omega x arm
          const unsigned int next = (component + 1) % 3,
                             last = (component + 2) % 3;
          result[next]            = arm[last];
          result[last]            = -arm[next];
        }
        return result;
      }
    };



    template <int dim>
    std::string
    direction(const Tensor<1, dim> &vector)
    {
      const Tensor<1, dim> unit = vector / vector.norm();
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(unit[d]) > 1. - negligible_row)
          return std::string(1, "xyz"[d]);
      Point<dim> rounded;
      for (unsigned int d = 0; d < dim; ++d)
        rounded[d] = std::abs(unit[d]) < negligible_row ? 0. : unit[d];
      return "the direction " + in_words(rounded);
    }



    template <int dim>
    std::string
    place(const Frame<dim> &frame, const Tensor<1, dim> &arm)
    {
      Point<dim> point = frame.middle + frame.size * arm;
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(point[d]) < negligible_row * frame.size)
          point[d] = 0.;
      return in_words(point);
    }



    // of a motion with a rotation
    template <int dim>
    std::string
    rotation_in_words(const Row &motion, const Frame<dim> &frame)
    {
      Tensor<1, dim> shift, arm;
      for (unsigned int d = 0; d < dim; ++d)
        shift[d] = motion[n_rotations<dim> + d];
      if constexpr (dim == 2)
      {
        arm[0] = -shift[1] / motion[0];
        arm[1] = shift[0] / motion[0];
        return "rotate about " + place(frame, arm);
      }
      else
      {
        const Tensor<1, 3> omega({motion[0], motion[1], motion[2]});
        arm = cross_product_3d(omega, shift) / omega.norm_square();
        const bool screws =
          std::abs(omega * shift) > negligible_row * omega.norm_square();
        return (screws ? "turn like a screw along the axis in "
                       : "rotate about the axis in ") +
               direction<3>(omega) + " through " + place(frame, arm);
      }
    }



    // "move in x and y", "rotate about (0, 2)"; in the reduced form the rows
    // that begin behind the rotations are translations alone
    template <int dim>
    std::vector<std::string>
    name_motions(const std::vector<Row> &kernel, const Frame<dim> &frame)
    {
      std::vector<std::string> directions, motions;
      for (const Row &motion : reduced_echelon_form(kernel, n_modes<dim>))
      {
        bool           rotates = false;
        Tensor<1, dim> shift;
        for (unsigned int i = 0; i < n_modes<dim>; ++i)
          if (i < n_rotations<dim>)
            rotates = rotates || std::abs(motion[i]) > negligible_row;
          else
            shift[i - n_rotations<dim>] = motion[i];
        if (rotates)
          motions.push_back(rotation_in_words<dim>(motion, frame));
        else
          directions.push_back(direction<dim>(shift));
      }
      if (!directions.empty())
        motions.insert(motions.begin(),
                       "move in " + join_names(directions, " and "));
      return motions;
    }



    // Constraints on parts that hang together.
    template <int dim>
    struct Group
    {
      std::vector<unsigned int> parts;
      // part, point, component
      std::vector<std::tuple<unsigned int, Point<dim>, unsigned int>> held;
      std::vector<const typename BodyParts<dim>::Hinge *>             hinges;
      std::vector<const PartImage<dim> *>                             images;
    };



    template <int dim>
    std::vector<std::vector<Row>>
    kernels_of_parts(const Group<dim> &group, const Frame<dim> &frame)
    {
      constexpr unsigned int              m = n_modes<dim>;
      std::map<unsigned int, std::size_t> begin; // of the columns of a part
      for (const unsigned int part : group.parts)
        begin.emplace(part, m * begin.size());
      const std::size_t n_columns = m * group.parts.size();
      RowSpace          space(n_columns);
      const auto        add_to = [&](Row               &row,
                              const unsigned int part,
                              const Point<dim>  &point,
                              const unsigned int component,
                              const double       factor) {
        const auto values = frame.row(point, component);
        for (unsigned int i = 0; i < m; ++i)
          row[begin.at(part) + i] += factor * values[i];
      };
      for (const auto &[part, point, component] : group.held)
      {
        Row row(n_columns, 0.);
        add_to(row, part, point, component, 1.);
        space.add(row);
      }
      for (const auto *hinge : group.hinges)
        for (auto part = std::next(hinge->parts.begin());
             part != hinge->parts.end();
             ++part)
          for (unsigned int component = 0; component < dim; ++component)
          {
            Row row(n_columns, 0.);
            add_to(row, *hinge->parts.begin(), hinge->position, component, 1.);
            add_to(row, *part, hinge->position, component, -1.);
            space.add(row);
          }
      for (const auto *image : group.images)
        for (unsigned int component = 0; component < dim; ++component)
        {
          Row row(n_columns, 0.);
          add_to(row, image->parts[0], image->points[0], component, 1.);
          add_to(row, image->parts[1], image->points[1], component, -1.);
          space.add(row);
        }
      const std::vector<Row>        kernel = space.kernel();
      std::vector<std::vector<Row>> result;
      for (const unsigned int part : group.parts)
      {
        result.emplace_back();
        for (const Row &row : kernel)
          result.back().emplace_back(row.begin() + begin.at(part),
                                     row.begin() + begin.at(part) + m);
      }
      return result;
    }



    // The part that each point belongs to. Points are vertices.
    template <int dim>
    std::vector<unsigned int>
    parts_of_points(const Triangulation<dim>                &triangulation,
                    const std::vector<PrescribedPoint<dim>> &points,
                    const BodyParts<dim>                    &parts)
    {
      std::vector<unsigned int> result(points.size(), parts.n_parts());
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          for (std::size_t i = 0; i < points.size(); ++i)
            for (const unsigned int v : cell->vertex_indices())
              if (cell->vertex(v).distance(points[i].point) <
                  1e-6 * cell->diameter())
              {
                typename Triangulation<dim>::cell_iterator ancestor = cell;
                while (ancestor->level() > 0)
                  ancestor = ancestor->parent();
                result[i] =
                  std::min(result[i], parts.of_cell(ancestor->index()));
              }
      Utilities::MPI::min(result, triangulation.get_communicator(), result);
      return result;
    }



    template <int dim>
    Frame<dim>
    frame_of(const Triangulation<dim> &triangulation)
    {
      auto             cell = triangulation.begin(0);
      BoundingBox<dim> box  = cell->bounding_box();
      for (const auto &each : triangulation.cell_iterators_on_level(0))
        box.merge_with(each->bounding_box());
      double size = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        size = std::max(size, 0.5 * box.side_length(d));
      return {box.center(), size};
    }
  } // namespace



  template <int dim>
  std::vector<std::string>
  free_rigid_motions(const Triangulation<dim>                    &triangulation,
                     const std::vector<PrescribedComponent<dim>> &components,
                     const std::vector<PrescribedPoint<dim>>     &points,
                     const PeriodicSides<dim>                    &sides)
  {
    const BodyParts<dim>    parts(triangulation);
    const Frame<dim>        frame    = frame_of(triangulation);
    const auto              images   = part_images(triangulation, sides, parts);
    const auto              group_of = parts.groups(parts_joined_by(images));
    std::vector<Group<dim>> groups(
      1 + *std::max_element(group_of.begin(), group_of.end()));
    for (unsigned int part = 0; part < parts.n_parts(); ++part)
      groups[group_of[part]].parts.push_back(part);
    for (const auto &hinge : parts.hinges())
      groups[group_of[*hinge.parts.begin()]].hinges.push_back(&hinge);
    for (const PartImage<dim> &image : images)
      groups[group_of[image.parts[0]]].images.push_back(&image);
    const auto hold = [&](const unsigned int part,
                          const Point<dim>  &point,
                          const unsigned int component) {
      groups[group_of[part]].held.emplace_back(part, point, component);
    };
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int f : cell->face_indices())
        if (const auto face = cell->face(f); face->at_boundary())
          for (const auto &entry : components)
            if (entry.boundary.contains(face->boundary_id()))
            {
              const unsigned int part = parts.of_cell(cell->index());
              for (const unsigned int v : face->vertex_indices())
                hold(part, face->vertex(v), entry.component);
              hold(part, face->center(true), entry.component);
            }
    const auto at = parts_of_points(triangulation, points, parts);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (at[i] < parts.n_parts())
        hold(at[i], points[i].point, points[i].component);

    std::vector<std::string> sentences;
    for (const Group<dim> &group : groups)
    {
      if (group.parts.size() > most_parts)
        continue;
      const auto kernels = kernels_of_parts(group, frame);
      for (std::size_t i = 0; i < group.parts.size(); ++i)
        for (const std::string &motion : name_motions(kernels[i], frame))
          sentences.push_back(
            (parts.n_parts() == 1
               ? "the body"
               : "the part around " + in_words(parts.middle(group.parts[i]))) +
            " can " + motion);
    }
    return sentences;
  }



  template std::vector<std::string>
  free_rigid_motions(const Triangulation<2> &,
                     const std::vector<PrescribedComponent<2>> &,
                     const std::vector<PrescribedPoint<2>> &,
                     const PeriodicSides<2> &);
  template std::vector<std::string>
  free_rigid_motions(const Triangulation<3> &,
                     const std::vector<PrescribedComponent<3>> &,
                     const std::vector<PrescribedPoint<3>> &,
                     const PeriodicSides<3> &);
} // namespace MixedCracks
