#include "core/io/import/fields/import_quantity.h"

#include "core/io/import/fields/import_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace berg {

namespace {

struct Replacement
{
    std::string_view from;
    std::string_view to;
};

template <std::size_t Size>
void replaceAll(std::string& text, const std::array<Replacement, Size>& replacements)
{
    for (const auto& [from, to] : replacements)
        for (std::size_t at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
}

/** Returns the text in lower case, with one kind of dash and of blank. */
std::string plainText(std::string_view text)
{
    std::string plain(text);
    for (char& c : plain)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    static constexpr std::array<Replacement, 9> kSigns{{{"–", "-"},
                                                        {"—", "-"},
                                                        {"−", "-"},
                                                        {"\u00A0", " "},
                                                        {"\u202F", " "},
                                                        {"\u2009", " "},
                                                        {"×", "x"},
                                                        {"º", "°"},
                                                        {"\t", " "}}};
    replaceAll(plain, kSigns);
    return plain;
}

/** Removes `front` from the front of a text. Returns false if it does not begin so. */
bool take(std::string_view& text, std::string_view front)
{
    if (!text.starts_with(front))
        return false;
    text = trimmed(text.substr(front.size()));
    return true;
}

/**
 * Removes words before a number that mark a limit or an estimate. Returns whether there were any.
 */
bool takeRoughness(std::string_view& text)
{
    static constexpr std::array<std::string_view, 17> kWords{
        "<=",     ">=",  "<",     ">",  "≤",     "≥",  "~",    "≈",  "approx.",
        "approx", "ca.", "circa", "ca", "about", "c.", "est.", "est"};
    bool isRough = false;
    for (bool found = true; found;) {
        found =
            std::ranges::any_of(kWords, [&](std::string_view word) { return take(text, word); });
        isRough = isRough || found;
    }
    return isRough;
}

/**
 * Removes the number at the front, which may have blanks between groups of three digits, and
 * returns it.
 */
std::string takeNumber(std::string_view& text)
{
    std::string number;
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const auto at = [&](std::size_t i) { return i < text.size() ? text[i] : '\0'; };
    std::size_t i = 0;
    if (at(0) == '-' || at(0) == '+')
        number += text[i++];
    const auto groupFollows = [&] {
        return at(i) == ' ' && !number.empty() && isDigit(number.back()) && isDigit(at(i + 1)) &&
               isDigit(at(i + 2)) && isDigit(at(i + 3)) && !isDigit(at(i + 4));
    };
    while (isDigit(at(i)) || at(i) == '.' || at(i) == ',' || groupFollows()) {
        if (text[i] != ' ')
            number += text[i];
        ++i;
    }
    const bool hasSign = at(i + 1) == '-' || at(i + 1) == '+';
    if (at(i) == 'e' && isDigit(at(hasSign ? i + 2 : i + 1))) {
        number += text[i++];
        if (hasSign)
            number += text[i++];
        while (isDigit(at(i)))
            number += text[i++];
    }
    text = trimmed(text.substr(i));
    return number;
}

/** Removes the unit at the front, the text before a further number, and returns it. */
std::string_view takeUnit(std::string_view& text)
{
    std::size_t end = text.starts_with("to ") ? 0 : std::min(text.find(" to "), text.size());
    for (std::size_t i = 0; i + 1 < end; ++i)
        if ((text[i] == '-' || text[i] == 'x') && (i == 0 || text[i - 1] == ' ') &&
            (text[i + 1] == ' ' || (text[i + 1] >= '0' && text[i + 1] <= '9')))
            end = i;
    const std::string_view unit = trimmed(text.substr(0, end));
    text = trimmed(text.substr(end));
    return unit;
}

/** A number with the text behind it. */
struct Part
{
    double value = 0;
    std::string_view unit;
    bool isLeast = false; ///< whether it is a lower limit, as "200+"
};

std::optional<Part> takePart(std::string_view& text, const NumberReader& number)
{
    const std::optional<double> value = number(takeNumber(text));
    if (!value)
        return std::nullopt;
    const bool isLeast = take(text, "+");
    return Part{.value = *value, .unit = takeUnit(text), .isLeast = isLeast};
}

/** Returns a point of the compass in degrees, or nullopt. */
std::optional<double> compassPoint(const std::string& text)
{
    std::string point = text;
    static constexpr std::array<Replacement, 13> kWords{{{"north", "n"},
                                                         {"south", "s"},
                                                         {"east", "e"},
                                                         {"west", "w"},
                                                         {"nord", "n"},
                                                         {"sør", "s"},
                                                         {"syd", "s"},
                                                         {"øst", "e"},
                                                         {"vest", "w"},
                                                         {"ø", "e"},
                                                         {"v", "w"},
                                                         {"-", ""},
                                                         {" ", ""}}};
    replaceAll(point, kWords);
    static constexpr std::array<std::string_view, 16> kPoints{"n",  "nne", "ne", "ene", "e",  "ese",
                                                              "se", "sse", "s",  "ssw", "sw", "wsw",
                                                              "w",  "wnw", "nw", "nnw"};
    const auto it = std::ranges::find(kPoints, point);
    if (it == kPoints.end())
        return std::nullopt;
    return 22.5 * static_cast<double>(it - kPoints.begin());
}

/** Returns a single value for two linked numbers. */
double merged(double first, double second, bool isSize, Dimension dimension)
{
    if (isSize)
        return std::max(first, second);
    if (dimension != Dimension::Angle || std::abs(second - first) <= 180)
        return (first + second) / 2;
    const double middle_deg = (first + second) / 2 + 180; // the range includes north
    return middle_deg >= 360 ? middle_deg - 360 : middle_deg;
}

/**
 * Removes the link of two numbers. Returns true if the second is another side ("120 x 80"), false
 * if it ends a range, nullopt if no link follows.
 */
std::optional<bool> takeLink(std::string_view& text, Dimension dimension)
{
    if (dimension == Dimension::Length && take(text, "x"))
        return true;
    if (take(text, "-") || take(text, "to "))
        return false;
    return std::nullopt;
}

} // namespace

bool standsForNone(double value)
{
    constexpr std::array kNines = {-99.9, -999.0, -999.9, -9999.0, -9999.9, -99999.0, -32768.0};
    return std::abs(value) >= 1e20 || std::ranges::find(kNines, value) != kNines.end();
}

std::optional<ReadQuantity> quantityOf(std::string_view text, Dimension dimension,
                                       const NumberReader& number)
{
    const std::string plain = plainText(text);
    std::string_view rest = trimmed(plain);
    if (dimension == Dimension::Angle)
        if (const std::optional<double> point_deg = compassPoint(plain))
            return ReadQuantity{.value = *point_deg, .hasUnit = true};
    const bool isRough = takeRoughness(rest);
    const std::optional<Part> first = takePart(rest, number);
    if (!first)
        return std::nullopt;
    ReadQuantity quantity{.value = first->value, .isExact = !isRough && !first->isLeast};
    std::string_view unit = first->unit;
    if (!rest.empty()) {
        const std::optional<bool> isSize = takeLink(rest, dimension);
        const std::optional<Part> second = isSize ? takePart(rest, number) : std::nullopt;
        if (!second || !rest.empty() || (!unit.empty() && unit != second->unit))
            return std::nullopt;
        unit = second->unit;
        quantity.value = merged(first->value, second->value, *isSize, dimension);
        quantity.isExact = quantity.isExact && *isSize;
    }
    if (unit.empty())
        return quantity;
    const std::optional<double> inSi = unitInSi(dimension, unit);
    quantity.hasUnit = true;
    quantity.value *= inSi.value_or(0);
    return inSi ? std::optional(quantity) : std::nullopt;
}

} // namespace berg
