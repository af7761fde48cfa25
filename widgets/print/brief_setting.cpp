#include "widgets/print/brief_setting.h"

#include "widgets/theme/theme.h"

#include <QFontMetricsF>
#include <QTextLayout>

#include <algorithm>
#include <cmath>

namespace berg {

QFont briefFont(const BriefType& type)
{
    QFont font = Theme::light().font;
    font.setPixelSize(type.size_px);
    font.setWeight(type.isBold ? QFont::Bold : QFont::Normal);
    font.setHintingPreference(QFont::PreferNoHinting);
    // Too small to be seen, but without ligatures, which a search in a PDF does not find.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 1.0 / 64);
    return font;
}

double linePitch_px(int size_px)
{
    constexpr double kPitch = 1.38; // of the type
    return std::round(2 * kPitch * size_px) / 2;
}

double widthOf_px(const QString& text, const BriefType& type)
{
    return QFontMetricsF(briefFont(type)).horizontalAdvance(text);
}

namespace {

/** Measured again: text in both directions may come out wider than it was elided to. */
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

} // namespace berg
