// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>
#include <base/expression.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace MixedCracks
{
  namespace
  {
    const std::vector<std::string> space_time{"x", "y", "z", "t"};

    std::string
    message_for(const std::string              &text,
                const std::vector<std::string> &variables = space_time)
    {
      testing::internal::CaptureStderr();
      std::string message = "accepted";
      try
      {
        const Expression expression(text, variables, "Boundary/Displacement");
      }
      catch (const InputError &error)
      {
        message = error.what();
      }
      // the parser below us likes to talk
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
      return message;
    }

    bool
    holds(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }
  } // namespace

  TEST(Expression, Evaluates)
  {
    const auto value = [](const std::string &text) {
      return Expression(text, space_time, "A")({2., 3., 5., 7.});
    };
    EXPECT_DOUBLE_EQ(value("0"), 0.);
    EXPECT_DOUBLE_EQ(value(" -200/60*t "), -200. / 60. * 7.);
    EXPECT_DOUBLE_EQ(value("x + 10*y + 100*z + 1000*t"), 7532.);
    EXPECT_DOUBLE_EQ(value("sin(pi*x/4)"), 1.);
    EXPECT_DOUBLE_EQ(value("if(x < y, 1, 2)"), 1.);
    EXPECT_DOUBLE_EQ(value("x >= y ? 1 : 2"), 2.);
    EXPECT_DOUBLE_EQ(value("max(x, y, t)"), 7.);
    EXPECT_DOUBLE_EQ(value("x == 2 && y != 2"), 1.);
    EXPECT_DOUBLE_EQ(value("1e-3*x + 1.E+2 + 2.5e1"), 125.002);
    EXPECT_DOUBLE_EQ(value("-x^2"), -4.);
    EXPECT_DOUBLE_EQ(Expression("2*h", {"h"}, "A")({0.15}), 0.3);
    EXPECT_DOUBLE_EQ(Expression("a*b", {"a", "b"}, "A")({2., 3.}), 6.);
  }

  TEST(Expression, KnowsEveryFunctionItSuggests)
  {
    for (const std::string text :
         {"abs(x)",    "acos(x)",     "acosh(2)",  "asin(x)",   "asinh(x)",
          "atan(x)",   "atan2(x, 1)", "atanh(x)",  "avg(x, 1)", "ceil(x)",
          "cos(x)",    "cosh(x)",     "cot(1)",    "csc(1)",    "erfc(x)",
          "exp(x)",    "floor(x)",    "int(x)",    "ln(1)",     "log(1)",
          "log10(1)",  "log2(1)",     "min(x, 1)", "pow(x, 2)", "rint(x)",
          "sec(x)",    "sign(x)",     "sin(x)",    "sinh(x)",   "sqrt(x)",
          "sum(x, 1)", "tan(x)",      "tanh(x)"})
      EXPECT_TRUE(
        std::isfinite(Expression(text, space_time, "A")({0.5, 0., 0., 0.})))
        << text;
  }

  TEST(Expression, HasTheFunctionsOfDealII)
  {
    const auto value = [](const std::string &text) {
      return Expression(text, {"x"}, "A")({0.7});
    };
    EXPECT_DOUBLE_EQ(value("cot(x)*tan(x)"), 1.);
    EXPECT_DOUBLE_EQ(value("csc(x)*sin(x)"), 1.);
    EXPECT_DOUBLE_EQ(value("sec(x)*cos(x)"), 1.);
    EXPECT_DOUBLE_EQ(value("pow(x, 3)"), 0.7 * 0.7 * 0.7);
    EXPECT_DOUBLE_EQ(value("erfc(x)"), std::erfc(0.7));
    EXPECT_DOUBLE_EQ(value("log(exp(x))"), 0.7);
    EXPECT_DOUBLE_EQ(value("ceil(x) + 10*floor(x)"), 1.);
    EXPECT_DOUBLE_EQ(value("int(x) + 10*int(0 - x) + 100*int(0.3)"), -9.);
    EXPECT_DOUBLE_EQ(value("if(x, 1, 2) + 10*if(0.3, 1, 2)"), 21.);
    EXPECT_DOUBLE_EQ(value("(x | 0) + 10*(x & 0) + 100*(x & 1)"), 101.);
  }

  TEST(Expression, CopiesAreIndependentOfTheOriginal)
  {
    auto original = std::make_unique<Expression>("x+t", space_time, "A");
    const Expression copy = *original;
    original.reset();
    EXPECT_DOUBLE_EQ(copy({1., 0., 0., 2.}), 3.);
    EXPECT_EQ(copy.text(), "x+t");
  }

  TEST(Expression, SaysWhatIsWrong)
  {
    // text, part of the message
    const std::vector<std::pair<std::string, std::string>> mistakes{
      {"", "empty"},
      {"   ", "empty"},
      {"x +", "Unexpected end"},
      {"sin(x", "parenthesis"},
      {"x)", "parenthesis"},
      {"sin()", "Too few"},
      {"sin(1, 2)", "Too many"},
      {"0,5", "decimals take a point"},
      {"(0,5)", "arguments"},
      {"t = 3", "=="},
      {"foo", "unknown name 'foo'"},
      {"2*w", "unknown name 'w'"},
      {"sqr(x)", "did you mean 'sqrt'?"},
      {"X", "unknown name 'X'"},
      {"2x", "Unexpected"},
      {"x y", "Unexpected"},
      {"x * * y", "Unexpected"},
      {"3 $ 4", "Unexpected"},
      {"x; y", "Unexpected"},
      {"\"text\"", "quotation"},
      {"1e400", "Unexpected"},
      {"nan", "unknown name 'nan'"},
      {"inf", "unknown name 'inf'"},
      {"rand()", "unknown name 'rand'"},
      {"rand_seed(1)", "unknown name 'rand_seed'"},
      {"unused_3", "unknown name"},
      {"h", "unknown name 'h'"},
      {"0x1F", "unknown name"},
      {"_pi", "unknown name '_pi'"},
      {"erf(x)", "did you mean 'erfc'?"},
      {"x ? 1", "else"}};
    for (const auto &[text, part] : mistakes)
    {
      const std::string message = message_for(text);
      EXPECT_TRUE(holds(message, part)) << text << " -> " << message;
      EXPECT_TRUE(holds(message, "Boundary/Displacement")) << message;
      EXPECT_FALSE(holds(message, "\n")) << message;
      EXPECT_FALSE(holds(message, "violated")) << message;
      EXPECT_LT(message.size(), 400U);
    }
    EXPECT_TRUE(holds(message_for("2*t", {"h"}), "unknown name 't'"));
    EXPECT_TRUE(holds(message_for("unused_1", {"h"}), "unknown name"));
    EXPECT_TRUE(holds(message_for("2x"), "character 2"));
  }

  TEST(Expression, RefusesValuesThatAreNotFinite)
  {
    const Expression inverse("1/t", space_time, "Loads/Force");
    EXPECT_DOUBLE_EQ(inverse({0., 0., 0., 4.}), 0.25);
    try
    {
      inverse({1., 2., 3., 0.});
      ADD_FAILURE();
    }
    catch (const InputError &error)
    {
      const std::string message = error.what();
      EXPECT_TRUE(holds(message, "Loads/Force")) << message;
      EXPECT_TRUE(holds(message, "x = 1, y = 2, z = 3, t = 0")) << message;
    }
    // text, value of h, part of the message
    const std::vector<std::tuple<std::string, double, std::string>> others{
      {"sqrt(h)", -1., "gives no number at h = -1"},
      {"log(h)", 0., "gives minus infinity at h = 0"},
      {"1/h", 0., "gives infinity at h = 0"}};
    for (const auto &[text, h, part] : others)
      try
      {
        Expression(text, {"h"}, "A")({h});
        ADD_FAILURE() << text;
      }
      catch (const InputError &error)
      {
        EXPECT_TRUE(holds(error.what(), part)) << error.what();
      }
  }
} // namespace MixedCracks
