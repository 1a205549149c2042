// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of parameters: what they say, and that each row is of use to every program that loops over them.

#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <support/print_method.h>
#include <vcg_core/errors.h>
#include <vcg_core/method.h>

namespace {

using vcg_core::Boundary;
using vcg_core::GaussianForm;
using vcg_core::Method;
using vcg_core::MethodInfo;
using vcg_core::ParameterInfo;
using vcg_core::SmoothingParameters;
using Kind = ParameterInfo::Kind;

template <class Member>
const ParameterInfo& row_of(Method method, Member member) {
  return *vcg_core::method_info(method).find(member);
}

std::string refusal(const ParameterInfo& row, double value) {
  SmoothingParameters parameters;
  row.set(parameters, value);
  try {
    row.require_valid(parameters);
  } catch (const vcg_core::InvalidParameter& error) {
    return error.what();
  }
  return {};
}

class Table : public testing::TestWithParam<MethodInfo> {
 protected:
  const std::vector<ParameterInfo>& rows() const { return GetParam().parameters; }
};

TEST_P(Table, HasEachNameAndEachMemberOnce) {
  std::set<std::string> names;
  for (const ParameterInfo& row : rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(GetParam().find(row.member), &row) << row.name;
  }
}

TEST_P(Table, HasDefaultsThatAreAllowed) {
  for (const ParameterInfo& row : rows()) EXPECT_NO_THROW(row.require_valid(GetParam().defaults)) << row.name;
}

TEST_P(Table, DescribesEachRowInSentences) {
  for (const ParameterInfo& row : rows()) {
    EXPECT_EQ(row.help.back(), '.') << row.name;
    EXPECT_EQ(row.description().back(), '.') << row.name;
    EXPECT_EQ(row.description().rfind(row.help, 0), 0u) << row.name;
    EXPECT_EQ(row.unit != nullptr, row.kind() == Kind::real) << row.name;
    EXPECT_EQ(row.values.choices.empty(), row.kind() != Kind::choice) << row.name;
    EXPECT_FALSE(row.values.by_selection && row.kind() != Kind::flag) << row.name;
  }
}

TEST_P(Table, SetsOnlyTheMemberOfTheRow) {
  for (const ParameterInfo& row : rows()) {
    SmoothingParameters parameters = GetParam().defaults;
    const double other = row.kind() == Kind::flag || row.kind() == Kind::choice ? 1 - row.value(parameters) : 7;
    row.set(parameters, other);
    EXPECT_EQ(row.value(parameters), other) << row.name;
    for (const ParameterInfo& untouched : rows())
      if (untouched.name != row.name) {
        EXPECT_EQ(untouched.value(parameters), untouched.value(GetParam().defaults)) << row.name;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Table, testing::ValuesIn(vcg_core::methods()),
                         [](const auto& test) { return test.param.name; });

TEST(ParameterInfo, IsOfTheMembersKind) {
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::rho).kind(), Kind::real);
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::iterations).kind(), Kind::integer);
  EXPECT_EQ(row_of(Method::guided, &SmoothingParameters::smooth_color).kind(), Kind::flag);
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::boundary).kind(), Kind::choice);
  EXPECT_EQ(row_of(Method::bmd, &SmoothingParameters::gaussian).kind(), Kind::choice);
}

TEST(ParameterInfo, PutsValuesInWords) {
  SmoothingParameters parameters;
  parameters.sigma_n = 0.3;
  parameters.iterations = std::numeric_limits<int>::max();
  parameters.boundary = Boundary::free;
  parameters.gaussian = GaussianForm::printed;
  parameters.selected_only = true;
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::sigma_n).text(parameters), "0.3");
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::iterations).text(parameters), "2147483647");
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::boundary).text(parameters), "free");
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::gaussian).text(parameters), "printed");
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::selected_only).text(parameters), "on");
}

// Users see these sentences in all programs.
TEST(ParameterInfo, SaysWhatIsAllowed) {
  EXPECT_EQ(refusal(row_of(Method::paper, &SmoothingParameters::sigma_c), -1.5),
            "sigma_c is -1.5; it must be a finite number greater than 0");
  EXPECT_EQ(refusal(row_of(Method::guided, &SmoothingParameters::strength), 11),
            "strength is 11; it must be greater than 0 and at most 10");
  EXPECT_EQ(refusal(row_of(Method::guided, &SmoothingParameters::feature_angle), 0),
            "feature_angle is 0; it must be greater than 0 and at most 90 (degrees)");
  EXPECT_EQ(refusal(row_of(Method::taubin, &SmoothingParameters::iterations), -2147483648.0),
            "iterations is -2147483648; it must be 1 or more");
  EXPECT_EQ(refusal(row_of(Method::guided, &SmoothingParameters::iterations), -1),
            "iterations is -1; it must be 0 (automatic) or more");
  EXPECT_EQ(refusal(row_of(Method::paper, &SmoothingParameters::boundary), 2),
            "boundary is 2; it must be 0 (fixed) or 1 (free)");
  EXPECT_EQ(refusal(row_of(Method::guided, &SmoothingParameters::strength), 10), "");
  EXPECT_EQ(row_of(Method::guided, &SmoothingParameters::strength).allowed(), "above 0, at most 10");
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::rho).allowed(), "above 0");
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::iterations).allowed(), "1 or more");
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::boundary).allowed(), "fixed or free");
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::selected_only).allowed(), "on or off");
}

TEST(ParameterInfo, DescribesRangeUsualValuesAndUnit) {
  EXPECT_EQ(row_of(Method::paper, &SmoothingParameters::rho).description(),
            "Geodesic radius of the neighbourhood. Higher: more vertices of little weight take part, and time grows "
            "with the square. Above 0; the paper uses 2. Unit: sigma_c.");
}

}  // namespace
