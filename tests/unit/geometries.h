// SPDX-License-Identifier: GPL-2.0-or-later
// What the tests of geometries share.
#ifndef mixed_cracks_tests_geometries_h
#define mixed_cracks_tests_geometries_h

#include <base/errors.h>

#include <problem/geometry.h>

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

namespace GeometryTests
{
  using namespace MixedCracks;

  using Entries = std::map<std::string, std::string>;

  inline std::unique_ptr<Geometry<2>>
  geometry(const std::string &name, const Entries &entries = {})
  {
    auto                     result = all_geometries<2>().make(name);
    dealii::ParameterHandler prm;
    result->add_parameters(prm);
    for (const auto &[entry, value] : entries)
      prm.set(entry, value);
    return result;
  }

  // The message of check(), empty when it accepts
  inline std::string
  problem(const std::string &name, const Entries &entries)
  {
    try
    {
      geometry(name, entries)->check();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }

  inline void
  expect_refused(const std::string &name,
                 const Entries     &entries,
                 const std::string &part)
  {
    const std::string message = problem(name, entries);
    EXPECT_NE(message.find(part), std::string::npos)
      << "'" << part << "' is not in: " << message;
  }

  inline double
  boundary_length(const dealii::Triangulation<2> &triangulation,
                  const BoundaryIds              &ids)
  {
    double length = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            ids.contains(cell->face(f)->boundary_id()))
          length += cell->face(f)->measure();
    return length;
  }
} // namespace GeometryTests

#endif
