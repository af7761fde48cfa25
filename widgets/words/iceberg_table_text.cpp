#include "widgets/words/iceberg_table_text.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Numbers of separators outside quotes. */
struct SeparatorCount
{
    int tabs = 0;
    int semicolons = 0;
    int commas = 0;
    int points = 0;
    int mostCommas = 0; ///< highest number in one line
};

SeparatorCount countSeparators(const QString& text)
{
    SeparatorCount count;
    bool isQuoted = false;
    int inLine = 0;
    for (const QChar c : text) {
        if (c == u'"')
            isQuoted = !isQuoted;
        if (isQuoted)
            continue;
        count.tabs += c == u'\t' ? 1 : 0;
        count.semicolons += c == u';' ? 1 : 0;
        count.commas += c == u',' ? 1 : 0;
        count.points += c == u'.' ? 1 : 0;
        inLine = c == u'\n' ? 0 : inLine + (c == u',' ? 1 : 0);
        count.mostCommas = std::max(count.mostCommas, inLine);
    }
    return count;
}

QChar separatorOf(const QString& text, const QLocale& locale)
{
    const SeparatorCount count = countSeparators(text);
    if (count.tabs > 0)
        return u'\t';
    if (count.semicolons > 0)
        return u';';
    const bool isDecimal =
        locale.decimalPoint() == u","_s && count.mostCommas <= 1 && count.points == 0;
    return count.commas == 0 || isDecimal ? u'\t' : u',';
}

/** Reads a text cell by cell. */
class CellReader
{
public:
    CellReader(const QString& text, QChar separator) : m_text(text), m_separator(separator) {}

    [[nodiscard]] std::vector<std::vector<QString>> read()
    {
        std::vector<std::vector<QString>> lines;
        while (m_at < m_text.size()) {
            std::vector<QString>& line = lines.emplace_back();
            line.push_back(readCell());
            while (m_at < m_text.size() && m_text[m_at] == m_separator) {
                ++m_at;
                line.push_back(readCell());
            }
            ++m_at; // skips the line end
        }
        return lines;
    }

private:
    [[nodiscard]] QString readCell()
    {
        return m_at < m_text.size() && m_text[m_at] == u'"' ? readQuoted() : readPlain();
    }

    [[nodiscard]] QString readPlain()
    {
        const qsizetype from = m_at;
        while (m_at < m_text.size() && m_text[m_at] != m_separator && m_text[m_at] != u'\n')
            ++m_at;
        return m_text.sliced(from, m_at - from);
    }

    /** Reads a quoted cell, in which quotes are doubled. */
    [[nodiscard]] QString readQuoted()
    {
        QString cell;
        ++m_at;
        while (m_at < m_text.size()) {
            const QChar c = m_text[m_at++];
            const bool isDoubled = m_at < m_text.size() && m_text[m_at] == u'"';
            if (c == u'"' && !isDoubled)
                break;
            if (c == u'"')
                ++m_at;
            cell += c;
        }
        return cell + readPlain();
    }

    const QString& m_text;
    QChar m_separator;
    qsizetype m_at = 0;
};

std::optional<double> finite(double value, bool isNumber)
{
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace

std::vector<std::vector<QString>> cellsOf(const QString& text, const QLocale& locale)
{
    QString lines = text;
    lines.replace(u"\r\n"_s, u"\n"_s).replace(u'\r', u'\n');
    return CellReader(lines, separatorOf(lines, locale)).read();
}

std::optional<double> numberOf(const QString& text, const QLocale& locale)
{
    QString plain;
    for (const QChar c : text)
        if (!c.isSpace())
            plain += c == QChar(0x2212) ? QChar(u'-') : c; // U+2212 MINUS SIGN
    QString withPoint = plain;
    if (plain.count(locale.decimalPoint()) == 1 &&
        (locale.decimalPoint() == u"."_s || !plain.contains(u'.')))
        withPoint.replace(locale.decimalPoint(), u"."_s);
    QLocale strict = QLocale::c();
    strict.setNumberOptions(QLocale::RejectGroupSeparator);
    bool isNumber = false;
    const double value = strict.toDouble(withPoint, &isNumber);
    if (isNumber)
        return finite(value, isNumber);
    const double grouped = locale.toDouble(plain, &isNumber);
    return finite(grouped, isNumber);
}

QString exactText(double value, const QLocale& locale)
{
    return QString::number(value, 'f', QLocale::FloatingPointShortest)
        .replace(u"."_s, locale.decimalPoint());
}

QString copiedAngle(double angle_deg, const QLocale& locale)
{
    // 1e-10 m; near zero the shortest exact text has hundreds of decimals.
    constexpr int kMostDecimals = 15;
    QString text = exactText(angle_deg, locale);
    if (const qsizetype point = text.indexOf(locale.decimalPoint());
        point >= 0 && text.size() > point + 1 + kMostDecimals)
        text =
            QString::number(angle_deg, 'f', kMostDecimals).replace(u"."_s, locale.decimalPoint());
    return text;
}

QString tabSeparated(const std::vector<std::vector<QString>>& cells)
{
    const auto quoted = [](QString cell) {
        const bool isPlain = std::none_of(cell.cbegin(), cell.cend(), [](QChar c) {
            return c == u'\t' || c == u'\n' || c == u'\r' || c == u'"';
        });
        return isPlain ? cell : u'"' + cell.replace(u"\""_s, u"\"\""_s) + u'"';
    };
    QString text;
    for (const std::vector<QString>& line : cells) {
        QStringList parts;
        for (const QString& cell : line)
            parts << quoted(cell);
        text += parts.join(u'\t') + u'\n';
    }
    return text;
}

} // namespace berg
