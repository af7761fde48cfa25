#include "widgets/print/brief_surroundings.h"

#include "widgets/theme/theme.h"

#include <QFontMetricsF>
#include <QTextLayout>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace berg {

QFont briefFont(const BriefType& type)
{
    QFont font = Theme::light().font;
    font.setPixelSize(type.size_px);
    font.setWeight(type.isBold ? QFont::Bold : QFont::Normal);
    font.setHintingPreference(QFont::PreferNoHinting);
    // Imperceptible spacing turns off ligatures, which a search in a PDF does not find.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 1.0 / 64);
    return font;
}

double linePitch_px(int size_px)
{
    constexpr double kPitch = 1.38; // relative to the font size
    return std::round(2 * kPitch * size_px) / 2;
}

double widthOf_px(const QString& text, const BriefType& type)
{
    return QFontMetricsF(briefFont(type)).horizontalAdvance(text);
}

namespace {

/** Elides repeatedly, because bidirectional text may be wider than it was elided to. */
QString elided(const QString& text, const QFontMetricsF& metrics, double width_px)
{
    double room_px = width_px;
    while (room_px > 0) {
        QString cut = metrics.elidedText(text, Qt::ElideRight, room_px);
        const double over_px = metrics.horizontalAdvance(cut) - width_px;
        if (over_px <= 0)
            return cut;
        room_px -= std::max(1.0, over_px);
    }
    return {};
}

} // namespace

void setText(BriefLayout& layout, const QRectF& rect, const QString& text, const BriefType& type)
{
    if (text.isEmpty())
        return;
    layout.texts.push_back(
        {rect, elided(text, QFontMetricsF(briefFont(type)), rect.width()), type});
}

QStringList wrapped(const QString& text, const BriefType& type, double width_px, int mostLines)
{
    QTextLayout layout(text, briefFont(type));
    QTextOption option;
    option.setTextDirection(Qt::LeftToRight);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid() && lines.size() < mostLines;
         line = layout.createLine()) {
        line.setLineWidth(width_px);
        const bool isLast = lines.size() + 1 == mostLines;
        lines << (isLast ? text.mid(line.textStart())
                         : text.mid(line.textStart(), line.textLength()).trimmed());
    }
    layout.endLayout();
    return lines;
}

PageComposer::PageComposer(const QSizeF& page)
    : free(QRectF(QPointF(0, 0), page)
               .adjusted(kBriefMargin_px, kBriefMargin_px, -kBriefMargin_px, -kBriefMargin_px))
{
    layout.page = page;
}

QRectF PageComposer::takeStrip(double height_px)
{
    const QRectF strip(free.left(), free.top(), free.width(), height_px);
    free.setTop(strip.bottom());
    return strip;
}

void PageComposer::line(const QString& text, const BriefType& type)
{
    setText(layout, takeStrip(linePitch_px(type.size_px)), text, type);
}

void PageComposer::rule(bool isStrong)
{
    const double y = takeStrip(4).bottom();
    layout.rules.push_back({QLineF(free.left(), y, free.right(), y), isStrong});
    takeStrip(4);
}

void PageComposer::setFacts(const std::vector<BriefFact>& facts, int columns)
{
    constexpr double kGap_px = 12;
    constexpr BriefType kFact{.size_px = 12, .isBold = true};
    const double column_px = free.width() / columns;
    const double caption_px = linePitch_px(kBriefCaption.size_px);
    const double height_px = caption_px + linePitch_px(kFact.size_px);
    int at = columns;
    QRectF row;
    for (const BriefFact& fact : facts) {
        const double wide_px =
            std::max(widthOf_px(fact.caption, kBriefCaption), widthOf_px(fact.value, kFact)) +
            kGap_px;
        const int span = std::clamp(static_cast<int>(std::ceil(wide_px / column_px)), 1, columns);
        if (at + span > columns) {
            row = takeStrip(height_px + 3);
            at = 0;
        }
        const QRectF box(row.left() + at * column_px, row.top(), span * column_px - kGap_px,
                         caption_px);
        setText(layout, box, fact.caption, kBriefCaption);
        setText(layout, QRectF(box.left(), box.bottom(), box.width(), height_px - caption_px),
                fact.value, kFact);
        at += span;
    }
}

namespace {

constexpr int kSize_px = 11;
constexpr std::size_t kMostRows = 8; // without captions
constexpr double kLeastGap_px = 10;
constexpr double kLeastName_px = 50;

double gaps_px(const std::vector<double>& widths_px)
{
    return kLeastGap_px * static_cast<double>(widths_px.size() - 1);
}

/** Widths of the columns; the name gets at most the rest of the width. */
std::vector<double> columnWidths(const std::vector<QStringList>& rows, const BriefType& type,
                                 double room_px)
{
    std::vector<double> widths_px(static_cast<std::size_t>(rows.front().size()));
    for (const QStringList& row : rows)
        for (std::size_t i = 0; i < widths_px.size(); ++i)
            widths_px[i] = std::max(widths_px[i], 1 + widthOf_px(row[static_cast<int>(i)], type));
    const double others_px =
        std::accumulate(widths_px.begin() + 1, widths_px.end(), gaps_px(widths_px));
    widths_px.front() = std::min(widths_px.front(), std::max(kLeastName_px, room_px - others_px));
    return widths_px;
}

/** Largest font size in which the columns fit. */
BriefType typeFor(const std::vector<QStringList>& rows, double room_px)
{
    BriefType type{.size_px = kSize_px};
    for (; type.size_px > kSmallestBriefType_px; --type.size_px) {
        const std::vector<double> widths_px = columnWidths(rows, type, room_px);
        if (std::accumulate(widths_px.begin(), widths_px.end(), gaps_px(widths_px)) <= room_px)
            break;
    }
    return type;
}

void setRow(BriefLayout& layout, const QRectF& strip, const QStringList& texts,
            const std::vector<double>& widths_px, const BriefType& type)
{
    const double taken_px = std::accumulate(widths_px.begin(), widths_px.end(), 0.0);
    const double gap_px =
        (strip.width() - taken_px) / std::max(1.0, static_cast<double>(widths_px.size() - 1));
    double left_px = strip.left();
    for (std::size_t i = 0; i < widths_px.size(); ++i) {
        // If there still is too little room, every column gives some.
        const double width_px = widths_px[i] + std::min(0.0, gap_px - kLeastGap_px);
        setText(layout, QRectF(left_px, strip.top(), width_px, strip.height()),
                texts[static_cast<int>(i)], type);
        left_px += widths_px[i] + gap_px;
    }
}

} // namespace

void PageComposer::setUavTable(const std::vector<QStringList>& rows)
{
    const BriefType type = typeFor(rows, free.width());
    const std::vector<double> widths_px = columnWidths(rows, type, free.width());
    BriefType captions = type;
    captions.isMuted = true;
    const std::size_t uavs = rows.size() - 1;
    const std::size_t shown = uavs > kMostRows ? kMostRows - 1 : uavs;
    const double pitch_px = linePitch_px(type.size_px);
    setRow(layout, takeStrip(pitch_px), rows.front(), widths_px, captions);
    for (std::size_t row = 1; row <= shown; ++row)
        setRow(layout, takeStrip(pitch_px), rows[row], widths_px, type);
    if (shown < uavs)
        setText(layout, takeStrip(pitch_px), FlightBrief::tr("and %1 more").arg(uavs - shown),
                type);
}

} // namespace berg
