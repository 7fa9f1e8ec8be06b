// Dates of the calendar, as "2027-03-31".
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace touchstone::app {

using Date = std::chrono::year_month_day;

/// No date: not four, two and two digits with hyphens between, or a day that the month does not have.
std::optional<Date> date_of(const std::string& text);

/// "2027-03-31"
std::string text_of(const Date& date);

/// The date in UTC.
Date today();

}  // namespace touchstone::app
