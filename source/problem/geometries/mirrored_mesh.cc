// SPDX-License-Identifier: GPL-2.0-or-later
// Another mesh for the same body, of the same fineness: how much do results
// depend on where the lines of the mesh happen to be? The lines between those
// that the body needs (its edges, the notch, the box around the hole) are
// mirrored at the middle of the body:
//
//   0  0.875 1.75 2.625 3.5    4.4  5.3   6.2  7.1  8   lines, cell size 1
//   *                   *                             *   needed
//   0  0.9   1.8  2.7       3.6  4.5  5.375 6.25 7.125 8  mirrored, 8 - line
//   0  0.9   1.8  2.7   3.5      4.5  5.375 6.25 7.125 8  lines now
//
// To mirror the whole mesh of the mirrored body would change nothing: what
// makes the lines does not know left from right.

#include <base/errors.h>
#include <base/ranges.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <problem/geometries/mirrored_mesh.h>
#include <problem/geometries/quad_mesh.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    const std::array<std::string, 2> names_of_axes = {{"x", "y"}};

    // in cell sizes, how near a line may come to one that is needed: gaps are
    // then 3/4 to 3/2 of the cell size, but for those between needed lines
    constexpr double nearest = 0.75;

    bool
    are_equal(const std::vector<double> &one, const std::vector<double> &other)
    {
      const double tolerance = 1e-9 * (one.back() - one.front());
      return std::equal(one.begin(),
                        one.end(),
                        other.begin(),
                        other.end(),
                        [tolerance](const double a, const double b) {
                          return std::abs(a - b) < tolerance;
                        });
    }
  } // namespace



  void
  MirroredMesh::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter(
      "Mirrored mesh",
      axes,
      "Axes in which the grid lines of the coarse mesh are mirrored at the "
      "middle of the body: 'x' those of constant x, 'y' those of constant y, "
      "'x, y' both. The body and its loads stay, and with them the lines that "
      "they need (edges, slit, the box around a hole); in between, a line at s "
      "goes to a + b - s, with a and b the ends of the body, as far as this "
      "keeps 3/4 of Cell size from the former. The same problem on other cells "
      "of the same size: what changes in the results, peak and path of the "
      "crack, is numerical scatter. Model/Length scale has to be a number for "
      "this, since h differs a little. 'none': as usual.",
      dealii::Patterns::MultipleSelection("none|x|y"));
  }



  bool
  MirroredMesh::is_mirrored(const unsigned int axis) const
  {
    const std::vector<std::string> words = split_list(axes, ',');
    return contains(words, names_of_axes[axis]);
  }



  std::vector<double>
  MirroredMesh::lines(const unsigned int         axis,
                      const std::vector<double> &fixed,
                      const double               cell_size) const
  {
    const std::vector<double> usual = grid_lines(fixed, cell_size);
    return is_mirrored(axis) ? mirrored_lines(usual, fixed, cell_size) : usual;
  }



  void
  MirroredMesh::check(const std::string                        &subsection,
                      const std::array<std::vector<double>, 2> &fixed,
                      const double                              cell_size) const
  {
    const std::string found =
      subsection + "Mirrored mesh: found " + in_quotes(axes);
    const std::vector<std::string> words = split_list(axes, ',');
    if (words.size() > 1 && contains(words, "none"))
      throw InputError(found + "; allowed is 'none' alone, or x, y or both.");
    for (unsigned int axis = 0; axis < 2; ++axis)
      if (is_mirrored(axis) && are_equal(lines(axis, fixed[axis], cell_size),
                                         grid_lines(fixed[axis], cell_size)))
        throw InputError(found + ", but the grid lines of constant " +
                         names_of_axes[axis] +
                         " are their own mirror image; allowed is what does "
                         "not name " +
                         names_of_axes[axis] + ", or another Cell size.");
  }



  std::vector<double>
  mirrored_lines(const std::vector<double> &lines,
                 const std::vector<double> &fixed,
                 const double               cell_size)
  {
    const double        least  = nearest * cell_size;
    std::vector<double> result = fixed;
    double              before = lines.front() - cell_size;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line)
    {
      const double mirrored = lines.front() + lines.back() - *line;
      const bool   is_near =
        mirrored - before < least || any_of(fixed, [&](const double other) {
          return std::abs(mirrored - other) < least;
        });
      if (is_near)
        continue;
      result.push_back(mirrored);
      before = mirrored;
    }
    return grid_lines(result, cell_size);
  }
} // namespace MixedCracks
