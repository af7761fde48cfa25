#pragma once

#include <clocale>
#include <locale>
#include <string>

namespace berg::test {

/**
 * While it exists, numbers of C++ and, if the system has German, of C are German: comma for
 * decimals, point for thousands.
 */
class GermanNumbers
{
public:
    GermanNumbers()
        // Owned by the locale.
        : m_before(std::locale::global(std::locale(std::locale(), new Numbers)))
    {
        std::setlocale(LC_ALL, "de_DE.UTF-8");
    }
    ~GermanNumbers()
    {
        std::locale::global(m_before);
        std::setlocale(LC_ALL, "C");
    }
    GermanNumbers(const GermanNumbers&) = delete;
    GermanNumbers& operator=(const GermanNumbers&) = delete;

private:
    class Numbers final : public std::numpunct<char>
    {
        [[nodiscard]] char do_decimal_point() const override { return ','; }
        [[nodiscard]] char do_thousands_sep() const override { return '.'; }
        [[nodiscard]] std::string do_grouping() const override { return "\3"; }
    };
    std::locale m_before;
};

} // namespace berg::test
