#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** So many cells of a row are kept. */
inline constexpr std::size_t kMostCells = 10'000;

/** One row of a CSV text. */
struct CsvRow
{
    enum class Fault
    {
        None,
        UnclosedQuote, ///< a quoted cell without end
        TextAfterQuote ///< something between the closing quote and the separator
    };

    std::size_t line = 0; ///< on which it starts, from 1
    std::vector<std::string> cells;
    Fault fault = Fault::None;
};

/**
 * Reads CSV as RFC 4180 has it: quoted cells may hold separators, line ends and doubled quotes. A
 * byte order mark is skipped, any of CRLF, LF and CR ends a line, and lines without a character
 * are no rows. After a row with a fault, reading goes on with the line below the one it started on,
 * so that a stray quote costs one row. Cost: linear, because a text that is full of stray quotes is
 * read again so often at most; from then on a line end closes every quote.
 */
class CsvReader
{
public:
    /** `text` must outlive the reader. */
    CsvReader(std::string_view text, char separator);

    /** The next row; false at the end. */
    [[nodiscard]] bool next(CsvRow& row);

private:
    [[nodiscard]] bool atLineEnd() const;
    void skipLineEnd();
    /** Reads one cell; false when it is faulty. */
    [[nodiscard]] bool readCell(std::string& cell, CsvRow::Fault& fault);
    [[nodiscard]] bool readQuoted(std::string& cell, CsvRow::Fault& fault);
    void skipToLineEnd();

    std::string_view m_text;
    char m_separator;
    std::size_t m_at = 0;
    std::size_t m_line = 1;
    std::string m_spare;         ///< a cell that is not kept
    std::size_t m_readAgain = 0; ///< bytes of rows with faults, beyond their first line
};

/**
 * The separator of a CSV text: of comma, semicolon, tab and bar the one that occurs most often
 * outside quotes in the first line that has any; a comma without one.
 */
[[nodiscard]] char csvSeparator(std::string_view text);

} // namespace berg
