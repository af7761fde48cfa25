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
constexpr double kHighlight = 0.18; ///< part of the plan's colour in the ground of a row
constexpr double kUavGround = 0.08; ///< part of the text's colour in that of a UAV
constexpr double kDrop = 0.3;       ///< part of the UAV's colour in the ground while one drags
constexpr int kBar_px = 3;

} // namespace

int PlanDelegate::swatchWidth()
{
    return kSwatch_px + 2 * kSwatchMargin_px;
}

void PlanDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.column() != PlanModel::Name || !index.data(PlanModel::KeptRole).toBool())
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
    option.state.setFlag(QStyle::State_HasFocus, false); // rows are chosen, not cells
    paintGround(*painter, option, index);
    if (index.column() == PlanModel::Number) {
        paintMark(*painter, option, index);
        return;
    }
    if (index.data(PlanModel::NumberRole).toInt() == 0) {
        paintUav(*painter, option, index);
        return;
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
        if (hasBar && index.column() == PlanModel::Number) // not by colour alone
            painter.fillRect(QStyle::visualRect(option.direction, option.rect,
                                                QRect(option.rect.topLeft(),
                                                      QSize(kBar_px, option.rect.height()))),
                             colour);
    };
    if (index.data(PlanModel::DropRole).toBool())
        paint(uavColour(m_theme, index.data(PlanModel::UavRole).toInt()), kDrop, true);
    else if (index.data(PlanModel::HighlightRole).toBool())
        paint(m_theme.plan, kHighlight, true);
    else if (index.data(PlanModel::NumberRole).toInt() == 0)
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

/** What the line begins with: the place in the order, or the colour of the UAV. */
void PlanDelegate::paintMark(QPainter& painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const
{
    paintEmpty(painter, option, index);
    const int number = index.data(PlanModel::NumberRole).toInt();
    if (number > 0)
        paintNumber(painter, option.rect, number, index.data(PlanModel::UavRole).toInt());
    else if (number == 0)
        paintChip(painter, option.rect, index.data(PlanModel::UavRole).toInt());
}

QString PlanDelegate::uavFigures(const QModelIndex& index, int room_px) const
{
    QStringList parts;
    for (const PlanModel::Column column : {PlanModel::Sigma, PlanModel::Leg, PlanModel::Arrival})
        if (const QString text = index.siblingAtColumn(column).data().toString();
            text != noFigure())
            parts << text;
    const QFontMetrics metrics(m_theme.small());
    while (parts.size() > 1 && metrics.horizontalAdvance(parts.join(u", "_s)) > room_px)
        parts.removeAt(1);
    return parts.join(u", "_s);
}

/** Its name and, where the columns of the icebergs are, what it is to fly; in one cell. */
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
    painter.setPen(QPen(m_theme.chart, 1.5)); // parts it from the ground of a chosen row
    painter.setBrush(uavColour(m_theme, uav));
    painter.drawRoundedRect(chip, 3, 3);
    painter.restore();
}

void PlanDelegate::paintNumber(QPainter& painter, const QRect& cell, int number, int uav) const
{
    const QColor colour = uav < 0 ? QColor() : uavColour(m_theme, uav);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    drawOrderDisk(painter, QRectF(cell).center(), kDiskRadius_px, number, m_theme, colour);
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
    // On the ground of a chosen row the scale does not stand out by itself.
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(chosen ? QPen(m_theme.planText, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(m_theme.sigma.colour(sigma_m2, m_sigmaFull_m2));
    painter.drawRoundedRect(swatch, 2, 2);
    painter.restore();
}

} // namespace berg
