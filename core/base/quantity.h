#pragma once

namespace berg {

/** Physical quantity of a number; decides its unit and how it is shown. */
enum class Quantity
{
    Text,
    Utc, ///< text of a date and time
    Number,
    Metres, ///< shown in metres whatever units are chosen
    Distance,
    Height,
    Speed,
    Seconds,
    Degrees,
    Percent,
    Celsius,
    Variance,
    Growth
};

/** A computed value, in SI, which faces round and show with its unit. */
struct Amount
{
    double value = 0;
    Quantity quantity = Quantity::Number;
    bool operator==(const Amount&) const = default;
};

} // namespace berg
