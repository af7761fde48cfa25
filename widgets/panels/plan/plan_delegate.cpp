#include "widgets/panels/plan/plan_delegate.h"

#include "widgets/map/paint/map_symbols.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/plan/plan_model.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/palette.h"

#include <QPainter>
#include <QStyle>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kDiskRadius_px = 10;
constexpr int kSwatch_px = 10;
constexpr int kSwatchMargin_px = 5;
constexpr int kPin_px = 14;
constexpr double kHighlight = 0.18; ///< share of the plan's colour in the ground of a row
constexpr double kUavGround = 0.08; ///< share of the text's colour in the ground of a UAV's line
constexpr double kDrop = 0.3;       ///< share of the UAV's colour in the ground while dragging
constexpr int kBar_px = 3;

int belowHeight_px(const Theme& theme)
{
    return QFontMetrics(theme.small()).height();
}

} // namespace

void PlanDelegate::setBelow(bool course, bool groundSpeed)
{
    m_hasCourseBelow = course;
    m_hasSpeedBelow = groundSpeed;
}

int PlanDelegate::rowHeight_px(int row_px) const
{
    return row_px + (m_hasCourseBelow || m_hasSpeedBelow ? belowHeight_px(m_theme) : 0);
}

QString PlanDelegate::textBelow(const QModelIndex& index) const
{
    const bool isCourse = m_hasCourseBelow && index.column() == PlanModel::Name;
    const bool isSpeed = m_hasSpeedBelow && index.column() == PlanModel::Leg;
    if ((!isCourse && !isSpeed) || index.data(PlanModel::IsUavRole).toBool())
        return {};
    const QString text =
        index.siblingAtColumn(isCourse ? PlanModel::Course : PlanModel::GroundSpeed)
            .data()
            .toString();
    return text == missingValueText() ? QString() : text;
}

int PlanDelegate::swatchWidth()
{
    return kSwatch_px + 2 * kSwatchMargin_px;
}

void PlanDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.data(PlanModel::LaterRole).toBool())
        option->palette.setColor(QPalette::Text, m_theme.mutedText);
    if (index.column() != PlanModel::Name || !index.data(PlanModel::AssignedRole).toBool())
        return;
    option->features |= QStyleOptionViewItem::HasDecoration;
    option->decorationPosition = QStyleOptionViewItem::Right;
    option->decorationSize = QSize(kPin_px, kPin_px);
    option->icon = icon(IconName::Pin, m_theme);
}

void PlanDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                         const QModelIndex& index) const
{
    QStyleOptionViewItem option = given;
    option.state.setFlag(QStyle::State_HasFocus, false); // rows are selected, not cells
    paintGround(*painter, option, index);
    if (index.column() == PlanModel::Number) {
        paintMark(*painter, option, index);
        return;
    }
    if (index.data(PlanModel::IsUavRole).toBool()) {
        paintUav(*painter, option, index);
        return;
    }
    if (const QString below = textBelow(index); !below.isEmpty()) {
        paintEmpty(*painter, option, index);
        paintBelow(*painter, option, below,
                   index.column() == PlanModel::Name ? Qt::AlignLeft : Qt::AlignRight);
        option.rect.setBottom(option.rect.bottom() - belowHeight_px(m_theme));
    }
    QStyledItemDelegate::paint(painter, option, index);
    if (const QVariant sigma_m2 = index.data(PlanModel::SigmaRole); sigma_m2.isValid())
        paintSwatch(*painter, option, sigma_m2.toDouble());
}

void PlanDelegate::paintGround(QPainter& painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const
{
    const auto paint = [&](const QColor& colour, double share, bool hasBar) {
        painter.fillRect(option.rect, mixed(option.palette.color(QPalette::Base), colour, share));
        // A bar, so that colour is not the only sign.
        if (hasBar && index.column() == PlanModel::Number)
            painter.fillRect(QStyle::visualRect(option.direction, option.rect,
                                                QRect(option.rect.topLeft(),
                                                      QSize(kBar_px, option.rect.height()))),
                             colour);
    };
    if (index.data(PlanModel::DropRole).toBool())
        paint(uavColour(m_theme, index.data(PlanModel::UavRole).toInt()), kDrop, true);
    else if (index.data(PlanModel::HighlightRole).toBool())
        paint(m_theme.plan, kHighlight, true);
    else if (index.data(PlanModel::IsUavRole).toBool())
        paint(m_theme.text, kUavGround, false);
}

void PlanDelegate::paintEmpty(QPainter& painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const
{
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    ground.text.clear();
    const QWidget* view = option.widget;
    view->style()->drawControl(QStyle::CE_ItemViewItem, &ground, &painter, view);
}

/** Paints the start of a line: the place in the order, or the colour of the UAV. */
void PlanDelegate::paintMark(QPainter& painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const
{
    paintEmpty(painter, option, index);
    const QVariant uav = index.data(PlanModel::UavRole);
    const QVariant number = index.data(PlanModel::NumberRole);
    if (index.data(PlanModel::IsUavRole).toBool())
        paintChip(painter, option.rect, uav.toInt());
    else if (number.isValid())
        paintNumber(painter, option.rect, number.toInt(),
                    uav.isValid() ? std::optional(uav.toInt()) : std::nullopt);
}

QString PlanDelegate::uavFigures(const QModelIndex& index, int room_px) const
{
    QStringList parts;
    for (const PlanModel::Column column : {PlanModel::Sigma, PlanModel::Leg, PlanModel::Arrival})
        if (const QString text = index.siblingAtColumn(column).data().toString();
            text != missingValueText())
            parts << text;
    const QFontMetrics metrics(m_theme.small());
    while (parts.size() > 1 && metrics.horizontalAdvance(parts.join(u", "_s)) > room_px)
        parts.removeAt(1);
    return parts.join(u", "_s);
}

/** Paints the name of the UAV and the figures of its path, in one cell. */
void PlanDelegate::paintUav(QPainter& painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const
{
    constexpr int kMargin_px = 4;
    constexpr int kGap_px = 8;
    paintEmpty(painter, option, index);
    const QRect cell = option.rect.adjusted(kMargin_px, 0, -kMargin_px, 0);
    QFont bold = option.font;
    bold.setBold(true);
    const QFontMetrics nameMetrics(bold);
    const QString name = index.data().toString();
    const QString figures =
        uavFigures(index, cell.width() - nameMetrics.horizontalAdvance(name) - kGap_px);
    const int figures_px = QFontMetrics(m_theme.small()).horizontalAdvance(figures);
    const bool isChosen = option.state.testFlag(QStyle::State_Selected);
    painter.save();
    painter.setPen(isChosen ? m_theme.planText : m_theme.text);
    painter.setFont(m_theme.small());
    painter.drawText(cell, Qt::AlignRight | Qt::AlignVCenter, figures);
    painter.setFont(bold);
    painter.drawText(cell, Qt::AlignLeft | Qt::AlignVCenter,
                     nameMetrics.elidedText(name, Qt::ElideRight,
                                            std::max(0, cell.width() - figures_px - kGap_px)));
    painter.restore();
}

void PlanDelegate::paintChip(QPainter& painter, const QRect& cell, int uav) const
{
    constexpr double kChip_px = 14;
    QRectF chip(0, 0, kChip_px, kChip_px);
    chip.moveCenter(QRectF(cell).center());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.chart, 1.5)); // separates it from the ground of a selected row
    painter.setBrush(uavColour(m_theme, uav));
    painter.drawRoundedRect(chip, 3, 3);
    painter.restore();
}

void PlanDelegate::paintNumber(QPainter& painter, const QRect& cell, int number,
                               std::optional<int> uav) const
{
    const QColor colour = uav ? uavColour(m_theme, *uav) : QColor();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    drawOrderDisk(painter, QRectF(cell).center(), kDiskRadius_px, number, m_theme, colour);
    painter.restore();
}

void PlanDelegate::paintBelow(QPainter& painter, const QStyleOptionViewItem& option,
                              const QString& text, Qt::Alignment side) const
{
    constexpr int kMargin_px = 4;
    const bool isChosen = option.state.testFlag(QStyle::State_Selected);
    const QRect cell = option.rect.adjusted(kMargin_px, 0, -kMargin_px, -1);
    painter.save();
    painter.setFont(m_theme.small());
    painter.setPen(isChosen ? m_theme.planText : m_theme.mutedText);
    painter.drawText(cell, static_cast<int>(side | Qt::AlignBottom),
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, cell.width()));
    painter.restore();
}

void PlanDelegate::paintSwatch(QPainter& painter, const QStyleOptionViewItem& option,
                               double sigma_m2) const
{
    const QRect& cell = option.rect;
    const QRectF swatch =
        QStyle::visualRect(option.direction, cell,
                           QRect(cell.left() + kSwatchMargin_px,
                                 cell.center().y() + 1 - kSwatch_px / 2, kSwatch_px, kSwatch_px));
    // On a selected row the scale lacks contrast.
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(chosen ? QPen(m_theme.planText, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(m_theme.sigma.colour(sigma_m2, m_sigmaFull_m2));
    painter.drawRoundedRect(swatch, 2, 2);
    painter.restore();
}

} // namespace berg
