#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Largest number of cells that are stored of a row; further cells are dropped. */
inline constexpr std::size_t kMostCells = 10'000;

/** One row of a CSV text. */
struct CsvRow
{
    /** Reason why a row could not be read. */
    enum class Fault
    {
        None,
        UnclosedQuote, ///< a quoted cell has no end
        TextAfterQuote ///< text stands between the closing quote and the separator
    };

    std::size_t line = 0; ///< line on which the row starts, from 1
    std::vector<std::string> cells;
    Fault fault = Fault::None;
};

/**
 * Reads CSV by RFC 4180: quoted cells may hold separators, line ends and doubled quotes. A byte
 * order mark is skipped, any of CRLF, LF and CR ends a line, and empty lines are not rows. After a
 * row with a fault, reading continues on the line below the row's first line, so that a stray quote
 * costs one row. Cost: linear, because text that is full of stray quotes is read again only up to a
 * limit; beyond it a line end closes every quote.
 */
class CsvReader
{
public:
    /** `text` must outlive the reader. */
    CsvReader(std::string_view text, char separator);

    /** Reads the next row into `row`; one with a fault has no cells. Returns false at the end. */
    [[nodiscard]] bool next(CsvRow& row);

private:
    [[nodiscard]] bool atLineEnd() const;
    void skipLineEnd();
    /** Reads one cell. Returns false and sets `fault` if it is faulty. */
    [[nodiscard]] bool readCell(std::string& cell, CsvRow::Fault& fault);
    [[nodiscard]] bool readQuoted(std::string& cell, CsvRow::Fault& fault);
    void skipToLineEnd();

    std::string_view m_text;
    char m_separator;
    std::size_t m_at = 0;
    std::size_t m_line = 1;
    std::string m_spare;         ///< receives the cells beyond `kMostCells`
    std::size_t m_readAgain = 0; ///< bytes that are read twice
};

/**
 * Returns the separator of a CSV text: that of comma, semicolon, tab and bar that occurs most often
 * outside quotes in the first line that has any of them, or a comma if no line has.
 */
[[nodiscard]] char csvSeparator(std::string_view text);

} // namespace berg
