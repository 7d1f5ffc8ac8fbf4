// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_front_rows_h
#define mixed_cracks_output_crack_front_rows_h

#include <cracks/crack_sheet.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// A row of crack_front.csv but for the step: a point of a front. Numbers of
  /// a table have ten significant digits.
  struct FrontRow
  {
    unsigned int     crack = 0, front = 0; ///< numbers of these in the step
    bool             is_closed = false;    ///< see CrackFront
    unsigned int     point     = 0;
    dealii::Point<3> position;           ///< mm
    double           arc_length    = 0.; ///< mm
    double           tip_speed     = 0.; ///< mm/s; NaN where it is not known
    double           opening_angle = 0.; ///< degrees; NaN where it is not known
  };

  /// The header of the table, with its end.
  std::string header_of_fronts();

  /// What stands behind the columns of the step, with the comma before it.
  std::string columns_of(const FrontRow &row);

  /// Of the fields of a whole line, as many as the header has.
  FrontRow front_row_of(const std::vector<std::string> &fields);

  /// The points of all fronts, with the distance of each to the @p earlier
  /// fronts over a @p time_step (s) as speed. No opening angles.
  std::vector<FrontRow> front_rows(const std::vector<CrackSheet> &sheets,
                                   const std::vector<CrackFront> &earlier,
                                   double                         time_step);

  /// The fronts of all sheets.
  std::vector<CrackFront> all_fronts(const std::vector<CrackSheet> &sheets);

  /// Those of rows, without the axes of their points.
  std::vector<CrackFront> fronts_of_rows(const std::vector<FrontRow> &rows);
} // namespace MixedCracks

#endif
