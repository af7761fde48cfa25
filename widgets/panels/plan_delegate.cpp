#include "widgets/panels/plan_delegate.h"

#include "widgets/map/map_symbols.h"
#include "widgets/panels/plan_model.h"

#include <QPainter>

namespace berg {
namespace {

constexpr double kDiskRadius_px = 10;
constexpr int kSwatch_px = 10;
constexpr int kSwatchMargin_px = 5;
constexpr double kHighlight = 0.18; ///< part of the plan's colour in the ground of a row

} // namespace

int PlanDelegate::swatchWidth()
{
    return kSwatch_px + 2 * kSwatchMargin_px;
}

void PlanDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                         const QModelIndex& index) const
{
    QStyleOptionViewItem option = given;
    option.state.setFlag(QStyle::State_HasFocus, false); // rows are chosen, not cells
    if (index.data(PlanModel::HighlightRole).toBool()) {
        painter->fillRect(option.rect,
                          mixed(option.palette.color(QPalette::Base), m_theme.plan, kHighlight));
        if (index.column() == PlanModel::Number) // not by colour alone
            painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())),
                              m_theme.plan);
    }
    if (index.column() == PlanModel::Number) {
        QStyleOptionViewItem ground = option;
        initStyleOption(&ground, index);
        ground.text.clear();
        const QWidget* view = option.widget;
        view->style()->drawControl(QStyle::CE_ItemViewItem, &ground, painter, view);
        paintNumber(*painter, option.rect, index.row() + 1);
        return;
    }
    QStyledItemDelegate::paint(painter, option, index);
    if (index.column() == PlanModel::Sigma)
        paintSwatch(*painter, option, index.data(PlanModel::SigmaRole).toDouble());
}

void PlanDelegate::paintNumber(QPainter& painter, const QRect& cell, int number) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    drawOrderDisk(painter, QRectF(cell).center(), kDiskRadius_px, number, m_theme);
    painter.restore();
}

void PlanDelegate::paintSwatch(QPainter& painter, const QStyleOptionViewItem& option,
                               double sigma_m2) const
{
    const QRect& cell = option.rect;
    const QRectF swatch(cell.left() + kSwatchMargin_px, cell.center().y() + 1 - kSwatch_px / 2,
                        kSwatch_px, kSwatch_px);
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
