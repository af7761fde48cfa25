#include "core/io/text/csv_reader.h"

#include "core/io/text/byte_order_mark.h"

#include <algorithm>
#include <array>

namespace berg {

namespace {

/** Limit of bytes read again, in multiples of the size of the text. */
constexpr std::size_t kMostReadAgain = 8;

bool endsLine(char c)
{
    return c == '\n' || c == '\r';
}

} // namespace

CsvReader::CsvReader(std::string_view text, char separator)
    : m_text(withoutByteOrderMark(text)), m_separator(separator)
{
}

bool CsvReader::atLineEnd() const
{
    return m_at >= m_text.size() || endsLine(m_text[m_at]);
}

void CsvReader::skipLineEnd()
{
    if (m_at >= m_text.size())
        return;
    const bool pair = m_text.substr(m_at).starts_with("\r\n");
    m_at += pair ? 2 : 1;
    ++m_line;
}

void CsvReader::skipToLineEnd()
{
    while (!atLineEnd())
        ++m_at;
}

bool CsvReader::next(CsvRow& row)
{
    while (m_at < m_text.size() && atLineEnd())
        skipLineEnd();
    if (m_at >= m_text.size())
        return false;
    const std::size_t start = m_at;
    row.line = m_line;
    row.fault = CsvRow::Fault::None;
    for (std::size_t count = 0;; ++count) {
        const bool kept = count < kMostCells;
        if (kept && row.cells.size() <= count)
            row.cells.emplace_back();
        if (!readCell(kept ? row.cells[count] : m_spare, row.fault)) {
            row.cells.clear();
            m_readAgain += m_at - start;
            m_at = start;
            m_line = row.line;
            skipToLineEnd();
            skipLineEnd();
            return true;
        }
        if (atLineEnd()) {
            row.cells.resize(std::min(count + 1, kMostCells));
            skipLineEnd();
            return true;
        }
        ++m_at; // the separator
    }
}

bool CsvReader::readCell(std::string& cell, CsvRow::Fault& fault)
{
    if (m_at < m_text.size() && m_text[m_at] == '"')
        return readQuoted(cell, fault);
    const std::size_t start = m_at;
    while (!atLineEnd() && m_text[m_at] != m_separator)
        ++m_at;
    cell.assign(m_text.substr(start, m_at - start));
    return true;
}

bool CsvReader::readQuoted(std::string& cell, CsvRow::Fault& fault)
{
    cell.clear();
    ++m_at; // the opening quote
    while (m_at < m_text.size()) {
        const char c = m_text[m_at];
        if (c == '"') {
            ++m_at;
            if (m_at < m_text.size() && m_text[m_at] == '"') {
                cell += '"';
                ++m_at;
                continue;
            }
            if (atLineEnd() || m_text[m_at] == m_separator)
                return true;
            fault = CsvRow::Fault::TextAfterQuote;
            return false;
        }
        if (endsLine(c)) {
            if (m_readAgain > kMostReadAgain * m_text.size())
                break;
            const std::size_t from = m_at;
            skipLineEnd();
            cell += m_text.substr(from, m_at - from);
            continue;
        }
        cell += c;
        ++m_at;
    }
    fault = CsvRow::Fault::UnclosedQuote;
    return false;
}

char csvSeparator(std::string_view text)
{
    constexpr std::array kSeparators = {',', ';', '\t', '|'};
    std::array<std::size_t, kSeparators.size()> counts{};
    bool quoted = false;
    for (const char c : text) {
        const bool found =
            std::any_of(counts.begin(), counts.end(), [](std::size_t n) { return n > 0; });
        if (!quoted && endsLine(c) && found)
            break;
        if (c == '"')
            quoted = !quoted;
        const auto it = std::find(kSeparators.begin(), kSeparators.end(), c);
        if (!quoted && it != kSeparators.end())
            ++counts[static_cast<std::size_t>(it - kSeparators.begin())];
    }
    const auto most = std::max_element(counts.begin(), counts.end());
    return kSeparators[static_cast<std::size_t>(most - counts.begin())];
}

} // namespace berg
