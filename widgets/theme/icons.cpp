#include "widgets/theme/icons.h"

#include "core/base/error.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <utility>

namespace berg {
namespace {

constexpr double kGrid_px = 24;
constexpr double kLine_px = 1.8;   // line width on the grid
constexpr double kDisabled = 0.55; // share of the background in a disabled icon

/**
 * Drawings of the icons as path data, absolute coordinates on the grid, y down: M, L, C and Z as in
 * SVG 1.1, and O for a circle (centre x, y, radius). Tokens are separated by one space.
 */
constexpr std::array<std::pair<IconName, const char16_t*>, kIconCount> kDrawings = {{
    {IconName::Play, u"M 7 4.5 L 19 12 L 7 19.5 Z"},
    {IconName::Pause, u"M 8 5 L 8 19 M 16 5 L 16 19"},
    {IconName::Step, u"M 5 5 L 14.5 12 L 5 19 Z M 19 5 L 19 19"},
    {IconName::Reset, u"M 19 5 L 9.5 12 L 19 19 Z M 5 5 L 5 19"},
    {IconName::Select, u"M 6 3.5 L 19 12.5 L 13 13.8 L 16 20 L 13.2 21.3 L 10.2 15 L 6 19 Z"},
    {IconName::Iceberg, u"M 5 14 L 9.5 4 L 13 8 L 15.5 6.5 L 19 14 M 9.5 4 L 11 14 "
                        "M 2 14 L 22 14 M 5.5 14 L 8 19 L 13 21 L 16.5 18.5 L 18.5 14"},
    {IconName::Uav, u"M 12 3 L 20.5 20 L 12 16 L 3.5 20 Z M 12 3 L 12 16"},
    {IconName::Asset, u"M 4 10 L 20 10 L 20 14 L 4 14 Z M 7 14 L 5 21.5 M 17 14 L 19 21.5 "
                      "M 6.2 17.5 L 17.8 17.5 M 9.5 10 L 11.5 3 L 13.5 10"},
    {IconName::Area, u"M 5 7.5 L 15.5 4.5 L 20 12.5 L 14 19.5 L 5.5 16.5 Z "
                     "O 5 7.5 1.6 O 15.5 4.5 1.6 O 20 12.5 1.6 O 14 19.5 1.6 O 5.5 16.5 1.6"},
    {IconName::NoFly, u"M 4 6 L 18 4 L 20.5 15 L 12 20 L 4.5 16.5 Z "
                      "M 4.2 11.5 L 11 5 M 5 16.5 L 17.5 4.2 M 9.5 18.5 L 19 9 M 14 18.8 L 20 13"},
    {IconName::Measure, u"M 2.5 16.5 L 16.5 2.5 L 21.5 7.5 L 7.5 21.5 Z M 6 13 L 8.3 15.3 "
                        "M 9.5 9.5 L 12.7 12.7 M 13 6 L 15.3 8.3"},
    {IconName::Pan, u"M 12 2.5 L 12 21.5 M 2.5 12 L 21.5 12 "
                    "M 9 5.5 L 12 2.5 L 15 5.5 M 9 18.5 L 12 21.5 L 15 18.5 "
                    "M 5.5 9 L 2.5 12 L 5.5 15 M 18.5 9 L 21.5 12 L 18.5 15"},
    {IconName::Undo,
     u"M 9 4.5 L 4 9.5 L 9 14.5 "
     "M 4 9.5 L 14.5 9.5 C 17.6 9.5 20 11.9 20 14.75 C 20 17.6 17.6 20 14.5 20 L 9 20"},
    {IconName::Redo, u"M 15 4.5 L 20 9.5 L 15 14.5 "
                     "M 20 9.5 L 9.5 9.5 C 6.4 9.5 4 11.9 4 14.75 C 4 17.6 6.4 20 9.5 20 L 15 20"},
    {IconName::Fit, u"M 3.5 8.5 L 3.5 3.5 L 8.5 3.5 M 15.5 3.5 L 20.5 3.5 L 20.5 8.5 "
                    "M 20.5 15.5 L 20.5 20.5 L 15.5 20.5 M 8.5 20.5 L 3.5 20.5 L 3.5 15.5 "
                    "M 8.5 8.5 L 15.5 8.5 L 15.5 15.5 L 8.5 15.5 Z"},
    {IconName::Follow, u"O 12 12 7.5 O 12 12 1.4 M 12 1.5 L 12 7 M 12 17 L 12 22.5 "
                       "M 1.5 12 L 7 12 M 17 12 L 22.5 12"},
    {IconName::ExportPlan, u"M 12 15 L 12 3 M 7.5 7.5 L 12 3 L 16.5 7.5 "
                           "M 4 13.5 L 4 20.5 L 20 20.5 L 20 13.5"},
    {IconName::Open, u"M 3 19.5 L 3 5 L 9.5 5 L 11.5 7.5 L 19 7.5 L 19 10.5 "
                     "M 3 19.5 L 6.5 10.5 L 22 10.5 L 18.5 19.5 Z"},
    {IconName::Save, u"M 4 4 L 16.5 4 L 20 7.5 L 20 20 L 4 20 Z M 8 4 L 8 9 L 15 9 L 15 4 "
                     "M 7.5 20 L 7.5 13.5 L 16.5 13.5 L 16.5 20"},
    {IconName::NewFile,
     u"M 18.5 12 L 18.5 8 L 13.5 3 L 5 3 L 5 21 L 12 21 M 13.5 3 L 13.5 8 L 18.5 8 "
     "M 18.5 15 L 18.5 22 M 15 18.5 L 22 18.5"},
    {IconName::Proven, u"O 12 12 9 M 7.5 12.5 L 10.7 15.7 L 16.5 9"},
    {IconName::Estimate, u"M 4 9.5 C 6.5 5.5 9.5 6 12 8.5 C 14.5 11 17.5 11.5 20 7.5 "
                         "M 4 16.5 C 6.5 12.5 9.5 13 12 15.5 C 14.5 18 17.5 18.5 20 14.5"},
    {IconName::Warning, u"M 12 3.5 L 22 20.5 L 2 20.5 Z M 12 10 L 12 14.5 M 12 17.3 L 12 17.6"},
    {IconName::Fault, u"M 8 2.5 L 16 2.5 L 21.5 8 L 21.5 16 L 16 21.5 L 8 21.5 L 2.5 16 L 2.5 8 Z "
                      "M 8.5 8.5 L 15.5 15.5 M 15.5 8.5 L 8.5 15.5"},
    {IconName::Hint, u"O 12 12 9 M 12 11 L 12 16.5 M 12 7.5 L 12 7.8"},
    {IconName::Locked, u"M 5 11 L 19 11 L 19 20.5 L 5 20.5 Z "
                       "M 8 11 L 8 8 C 8 5.5 9.7 3.5 12 3.5 C 14.3 3.5 16 5.5 16 8 L 16 11"},
    {IconName::Pin, u"M 8 3 L 16 3 M 9.5 3 L 9.5 10 L 6 14.5 L 18 14.5 L 14.5 10 L 14.5 3 "
                    "M 12 14.5 L 12 21.5"},
    {IconName::More, u"M 3 3 L 12 12 L 3 21 M 12 3 L 21 12 L 12 21"},
}};

/** Drawing of an icon; throws `std::logic_error` for invalid path data. */
QPainterPath pathOf(IconName name)
{
    const auto* const drawing =
        std::ranges::find(kDrawings, name, &decltype(kDrawings)::value_type::first);
    require(drawing != kDrawings.end(), "icon: no drawing");
    const QStringList tokens = QString::fromUtf16(drawing->second).split(u' ');
    qsizetype next = 0;
    const auto number = [&] {
        bool ok = false;
        const double value = tokens.value(next++).toDouble(&ok);
        require(ok, "icon: number missing in path");
        return value;
    };
    const auto point = [&] {
        const double x = number();
        return QPointF(x, number());
    };
    QPainterPath path;
    while (next < tokens.size()) {
        const QString& command = tokens[next++];
        if (command == u"M") {
            path.moveTo(point());
        } else if (command == u"L") {
            path.lineTo(point());
        } else if (command == u"C") {
            const QPointF first = point();
            const QPointF second = point();
            path.cubicTo(first, second, point());
        } else if (command == u"O") {
            const QPointF centre = point();
            const double radius_px = number();
            path.addEllipse(centre, radius_px, radius_px);
        } else {
            require(command == u"Z", "icon: unknown path command");
            path.closeSubpath();
        }
    }
    return path;
}

class LineIconEngine final : public QIconEngine
{
public:
    struct Inks
    {
        QColor usual;
        QColor disabled;
        QColor selected; ///< in a selected row
    };

    LineIconEngine(const QPainterPath& path, const Inks& inks) : m_path(path), m_inks(inks) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const double side_px = std::min(rect.width(), rect.height());
        const QColor& colour = mode == QIcon::Disabled   ? m_inks.disabled
                               : mode == QIcon::Selected ? m_inks.selected
                                                         : m_inks.usual;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(QRectF(rect).center());
        painter->scale(side_px / kGrid_px, side_px / kGrid_px);
        painter->translate(-kGrid_px / 2, -kGrid_px / 2);
        painter->setPen(QPen(colour, kLine_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->setBrush(Qt::NoBrush);
        painter->drawPath(m_path);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }

    [[nodiscard]] QIconEngine* clone() const override { return new LineIconEngine(m_path, m_inks); }

private:
    QPainterPath m_path;
    Inks m_inks;
};

} // namespace

QIcon icon(IconName name, const Theme& theme)
{
    return QIcon(
        new LineIconEngine(pathOf(name), {.usual = theme.text,
                                          .disabled = mixed(theme.text, theme.panel, kDisabled),
                                          .selected = theme.planText}));
}

} // namespace berg
