#include "core/io/import/fields/import_time.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

namespace berg {

namespace {

using namespace std::chrono;

// A year outside these is a typing error or the default of a logger.
constexpr int kEarliestYear = 1900;
constexpr int kLatestYear = 2100;

/** Reads a text from the left. */
class Scanner
{
public:
    explicit Scanner(std::string_view text) : m_text(text) {}

    [[nodiscard]] bool done() const { return m_text.empty(); }
    [[nodiscard]] char front() const { return m_text.empty() ? '\0' : m_text.front(); }
    void blanks()
    {
        while (front() == ' ')
            m_text.remove_prefix(1);
    }
    bool take(char c)
    {
        if (front() != c)
            return false;
        m_text.remove_prefix(1);
        return true;
    }
    /** Removes the digits at the front, possibly none, and returns them. */
    std::string_view digits()
    {
        return run([](char c) { return c >= '0' && c <= '9'; });
    }
    /** Removes the letters at the front and returns them in lower case. */
    std::string letters()
    {
        std::string word(
            run([](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }));
        for (char& c : word)
            c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        return word;
    }

private:
    template <class Accept>
    std::string_view run(Accept accept)
    {
        const auto end = std::find_if_not(m_text.begin(), m_text.end(), accept);
        const auto count = static_cast<std::size_t>(end - m_text.begin());
        const std::string_view taken = m_text.substr(0, count);
        m_text.remove_prefix(count);
        return taken;
    }

    std::string_view m_text;
};

/** Returns the number of one to nine digits, or nullopt for any other count. */
std::optional<int> numberOf(std::string_view digits)
{
    int value = 0;
    if (digits.empty() || digits.size() > 9)
        return std::nullopt;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

std::optional<sys_days> dayOf(int y, int m, int d)
{
    if (m < 1 || d < 1 || y < kEarliestYear || y > kLatestYear)
        return std::nullopt;
    const year_month_day date{year(y), month(static_cast<unsigned>(m)),
                              day(static_cast<unsigned>(d))};
    return date.ok() ? std::optional(sys_days(date)) : std::nullopt;
}

/** Returns a year of two or four digits, or nullopt. */
std::optional<int> yearOf(std::string_view digits)
{
    const std::optional<int> value = numberOf(digits);
    if (!value || (digits.size() != 2 && digits.size() != 4))
        return std::nullopt;
    return digits.size() == 4 ? *value : *value + (*value < 70 ? 2000 : 1900);
}

std::optional<int> monthOfName(const std::string& word)
{
    constexpr std::array<std::string_view, 12> kMonths = {"jan", "feb", "mar", "apr", "may", "jun",
                                                          "jul", "aug", "sep", "oct", "nov", "dec"};
    if (word.size() < 3)
        return std::nullopt;
    const auto it = std::find(kMonths.begin(), kMonths.end(), std::string_view(word).substr(0, 3));
    return it == kMonths.end() ? std::nullopt
                               : std::optional(static_cast<int>(it - kMonths.begin()) + 1);
}

/** Reads 20210602 or 2021153. */
std::optional<sys_days> compactDay(std::string_view digits)
{
    const std::optional<int> value = numberOf(digits);
    if (!value)
        return std::nullopt;
    if (digits.size() == 8)
        return dayOf(*value / 10000, *value / 100 % 100, *value % 100);
    const int dayOfYear = *value % 1000;
    const std::optional<sys_days> newYear = dayOf(*value / 1000, 1, 1);
    if (!newYear || dayOfYear < 1)
        return std::nullopt;
    const sys_days date = *newYear + days(dayOfYear - 1);
    return year_month_day(date).year() == year_month_day(*newYear).year() ? std::optional(date)
                                                                          : std::nullopt;
}

std::optional<sys_days> readDay(Scanner& scanner, DateOrder order)
{
    const std::string_view first = scanner.digits();
    if (first.size() == 7 || first.size() == 8)
        return compactDay(first);
    const char separator = scanner.front();
    if (separator != '-' && separator != '/' && separator != '.' && separator != ' ')
        return std::nullopt;
    scanner.take(separator);
    scanner.blanks();
    const std::string_view second = scanner.digits();
    const std::optional<int> named = second.empty() ? monthOfName(scanner.letters()) : std::nullopt;
    const std::optional<int> middle = named ? named : numberOf(second);
    if (!scanner.take(separator) || (separator == ' ' && !named))
        return std::nullopt;
    scanner.blanks();
    const std::string_view third = scanner.digits();
    const std::optional<int> a = numberOf(first);
    const std::optional<int> c = numberOf(third);
    if (!a || !middle || !c)
        return std::nullopt;
    if (first.size() == 4)
        return dayOf(*a, *middle, *c);
    const std::optional<int> y = yearOf(third);
    if (!y)
        return std::nullopt;
    const bool dayFirst = named || separator == '.' || order == DateOrder::DayFirst;
    return dayFirst ? dayOf(*y, *middle, *a) : dayOf(*y, *a, *middle);
}

/** Returns a time of day, or nullopt; 24:00 is its end, and a second may be a leap second. */
std::optional<milliseconds> timeOfDay(int hour, int minute, int second, int millisecond)
{
    const milliseconds rest = minutes(minute) + seconds(second) + milliseconds(millisecond);
    if (minute > 59 || second > 60 || hour > 24 || (hour == 24 && rest > milliseconds(0)))
        return std::nullopt;
    return hours(hour) + rest;
}

/**
 * Reads digits that are hours and minutes without leading zeros (5 is 00:05), or six with seconds.
 */
std::optional<milliseconds> compactTime(std::string_view digits, int millisecond)
{
    const std::optional<int> value = numberOf(digits);
    if (!value || (digits.size() > 4 && digits.size() != 6))
        return std::nullopt;
    if (digits.size() == 6)
        return timeOfDay(*value / 10000, *value / 100 % 100, *value % 100, millisecond);
    return timeOfDay(*value / 100, *value % 100, 0, 0);
}

/** Reads a fraction of a second, if one follows, and returns it in milliseconds. */
int takeMilliseconds(Scanner& scanner)
{
    if (!scanner.take('.') && !scanner.take(','))
        return 0;
    std::string fraction(scanner.digits().substr(0, 3));
    fraction.resize(3, '0');
    return numberOf(fraction).value_or(0);
}

std::optional<milliseconds> readClock(Scanner& scanner)
{
    const std::string_view first = scanner.digits();
    if (!scanner.take(':'))
        return compactTime(first, first.size() == 6 ? takeMilliseconds(scanner) : 0);
    const std::optional<int> hour = numberOf(first);
    const std::optional<int> minute = numberOf(scanner.digits());
    std::optional<int> second = 0;
    int millisecond = 0;
    if (scanner.take(':')) {
        second = numberOf(scanner.digits());
        millisecond = takeMilliseconds(scanner);
    }
    if (!hour || !minute || !second)
        return std::nullopt;
    return timeOfDay(*hour, *minute, *second, millisecond);
}

/** Reads "+02", "-3:30" or "+0200". */
std::optional<minutes> readOffset(Scanner& scanner)
{
    const char sign = scanner.front();
    if (sign != '+' && sign != '-')
        return std::nullopt;
    scanner.take(sign);
    const std::string_view first = scanner.digits();
    std::optional<int> hour = numberOf(first);
    std::optional<int> minute = 0;
    if (first.size() == 4 && hour) {
        minute = *hour % 100;
        hour = *hour / 100;
    } else if (scanner.take(':')) {
        minute = numberOf(scanner.digits());
    }
    if (!hour || !minute || *hour > 14 || *minute > 59)
        return std::nullopt;
    const minutes offset = hours(*hour) + minutes(*minute);
    return sign == '+' ? offset : -offset;
}

/** Applies the text behind the time of day (AM, PM, zone); returns nullopt for any other text. */
std::optional<milliseconds> readSuffix(Scanner& scanner, milliseconds clock)
{
    scanner.blanks();
    std::string word = scanner.letters();
    if (word == "am" || word == "pm") {
        if (clock < hours(1) || clock >= hours(13))
            return std::nullopt;
        clock = clock % hours(12) + (word == "pm" ? hours(12) : hours(0));
        scanner.blanks();
        word = scanner.letters();
    }
    if (word == "z" || word == "utc" || word == "gmt")
        return clock;
    const char sign = scanner.front();
    if (!word.empty() || (sign != '+' && sign != '-'))
        return word.empty() ? std::optional(clock) : std::nullopt;
    const std::optional<minutes> offset = readOffset(scanner);
    return offset ? std::optional(clock - *offset) : std::nullopt;
}

/** Reads a time of day with its suffix to the end of the text. */
std::optional<milliseconds> readRest(Scanner& scanner)
{
    std::optional<milliseconds> clock = readClock(scanner);
    if (clock)
        clock = readSuffix(scanner, *clock);
    scanner.blanks();
    return scanner.done() ? clock : std::nullopt;
}

} // namespace

std::optional<UtcTime> parseSightingTime(std::string_view text, DateOrder order)
{
    Scanner scanner(text);
    scanner.blanks();
    const std::optional<sys_days> date = readDay(scanner, order);
    if (!date)
        return std::nullopt;
    if (!scanner.take('T'))
        scanner.blanks();
    if (scanner.done())
        return UtcTime(*date);
    const std::optional<milliseconds> clock = readRest(scanner);
    return clock ? std::optional(UtcTime(*date) + *clock) : std::nullopt;
}

std::optional<milliseconds> parseTimeOfDay(std::string_view text)
{
    Scanner scanner(text);
    scanner.blanks();
    return readRest(scanner);
}

std::optional<minutes> parseZone(std::string_view text)
{
    Scanner scanner(text);
    scanner.blanks();
    const std::string word = scanner.letters();
    if (!word.empty() && word != "z" && word != "utc" && word != "gmt")
        return std::nullopt;
    scanner.blanks();
    if (scanner.done())
        return word.empty() ? std::nullopt : std::optional(minutes(0));
    const std::optional<minutes> offset = readOffset(scanner);
    scanner.blanks();
    return scanner.done() ? offset : std::nullopt;
}

bool hasTwoReadings(std::string_view text)
{
    const std::optional<UtcTime> monthFirst = parseSightingTime(text, DateOrder::MonthFirst);
    const std::optional<UtcTime> dayFirst = parseSightingTime(text, DateOrder::DayFirst);
    return monthFirst && dayFirst && *monthFirst != *dayFirst;
}

std::optional<UtcTime> parseTypedTime(std::string_view text)
{
    const std::optional<UtcTime> monthFirst = parseSightingTime(text, DateOrder::MonthFirst);
    const std::optional<UtcTime> dayFirst = parseSightingTime(text, DateOrder::DayFirst);
    if (monthFirst && dayFirst && *monthFirst != *dayFirst)
        return std::nullopt;
    return monthFirst ? monthFirst : dayFirst;
}

std::optional<DateOrder> dateOrderOf(std::string_view text)
{
    Scanner scanner(text);
    scanner.blanks();
    const std::string_view first = scanner.digits();
    if (first.size() > 2 || !(scanner.take('/') || scanner.take('-')))
        return std::nullopt;
    const std::optional<int> a = numberOf(first);
    const std::optional<int> b = numberOf(scanner.digits());
    if (!a || !b || (*a > 12) == (*b > 12))
        return std::nullopt;
    return *a > 12 ? DateOrder::DayFirst : DateOrder::MonthFirst;
}

} // namespace berg
