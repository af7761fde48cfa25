#include "widgets/print/printable_text.h"

#include <QList>

#include <algorithm>
#include <string_view>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMostMarks = 2;
constexpr QChar kIsolate{0x2068};
constexpr QChar kEndOfIsolate{0x2069};

bool isUnseen(char32_t c)
{
    switch (QChar::category(c)) {
    case QChar::Other_Control:
    case QChar::Other_Format:
    case QChar::Other_Surrogate:
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph:
        return true;
    default: // letters, marks and symbols of all scripts
        return false;
    }
}

bool isRightToLeft(char32_t c)
{
    const QChar::Direction direction = QChar::direction(c);
    return direction == QChar::DirR || direction == QChar::DirAL;
}

QList<uint> codesWithFewMarks(const QString& text)
{
    QList<uint> codes;
    int marks = 0;
    for (const uint c : text.toUcs4()) {
        marks = QChar::isMark(c) ? marks + 1 : 0;
        if (marks <= kMostMarks)
            codes.push_back(c);
    }
    return codes;
}

} // namespace

QString printable(const QString& text)
{
    const QList<uint> codes = codesWithFewMarks(text);
    const bool turns = std::any_of(codes.cbegin(), codes.cend(), isRightToLeft);
    QString line;
    for (const uint c : codes)
        line += QChar::fromUcs4(isUnseen(c) ? u' ' : c);
    line = line.simplified();
    return turns ? kIsolate + line + kEndOfIsolate : line;
}

QString printable(const std::string& utf8)
{
    return printable(QString::fromStdString(utf8));
}

std::string withFewMarks(const std::string& utf8)
{
    QString text;
    for (const uint c : codesWithFewMarks(QString::fromStdString(utf8)))
        text += QChar::fromUcs4(c);
    return text.toStdString();
}

std::string withPrintableNames(const std::string& html)
{
    constexpr std::string_view kBegin = "<bdi>";
    constexpr std::string_view kEnd = "</bdi>";
    std::string printed;
    std::size_t at = 0;
    while (true) {
        const std::size_t begin = html.find(kBegin, at);
        const std::size_t end = begin == std::string::npos ? begin : html.find(kEnd, begin);
        if (end == std::string::npos)
            return printed + html.substr(at);
        printed += html.substr(at, begin - at);
        const std::size_t name = begin + kBegin.size();
        printed += printable(html.substr(name, end - name)).toStdString();
        at = end + kEnd.size();
    }
}

} // namespace berg
