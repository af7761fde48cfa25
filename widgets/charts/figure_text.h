#pragma once

#include "widgets/theme/quantity_text.h"

#include <QStringList>

#include <functional>
#include <string>
#include <vector>

namespace berg {

// Texts of the window for figures.

[[nodiscard]] inline std::string utf8(const QString& text)
{
    return text.toStdString();
}

[[nodiscard]] inline std::vector<std::string> utf8(const QStringList& lines)
{
    std::vector<std::string> out;
    for (const QString& line : lines)
        out.push_back(line.toStdString());
    return out;
}

/** How the numbers of an axis are written. */
[[nodiscard]] inline std::function<std::string(double, int)> numberText(const QLocale& locale)
{
    return
        [locale](double value, int decimals) { return utf8(fixedText(value, decimals, locale)); };
}

/** As times. */
[[nodiscard]] inline std::string clockNumber(double time_s, int /*decimals*/)
{
    return utf8(clockText(time_s));
}

} // namespace berg
