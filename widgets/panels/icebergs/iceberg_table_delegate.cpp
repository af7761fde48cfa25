#include "widgets/panels/icebergs/iceberg_table_delegate.h"

#include "widgets/map/paint/map_symbols.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/icebergs/iceberg_table_model.h"
#include "widgets/theme/icons.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QStatusTipEvent>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kBar_px = 32;
constexpr int kBarHeight_px = 9;
constexpr int kMargin_px = 5;
constexpr int kMark_px = 3;
constexpr int kAlarm_px = 15;
constexpr double kHighlight = 0.18; ///< share of the plan's colour in the ground of a row

/**
 * The Inspector's input in a cell; it also accepts a decimal point where the locale has a comma.
 */
class CellField final : public NumberField
{
public:
    explicit CellField(QWidget* parent) : NumberField(parent)
    {
        setFrame(false);
        setButtonSymbols(NoButtons);
        setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        connect(this, &NumberField::edited, this, [this](double value) { m_typed = value; });
    }

    [[nodiscard]] std::optional<double> typed() const { return m_typed; }

    QValidator::State validate(QString& input, int& position) const override
    {
        if (locale().decimalPoint() == u","_s)
            input.replace(u'.', u',');
        return NumberField::validate(input, position);
    }

private:
    std::optional<double> m_typed;
};

const IcebergTableModel& modelOf(const QModelIndex& index)
{
    return *static_cast<const IcebergTableModel*>(index.model());
}

bool isNumber(const QModelIndex& index)
{
    const auto column = static_cast<IcebergColumn>(index.column());
    return column != IcebergColumn::Name && column != IcebergColumn::State;
}

/** Returns whether the iceberg has not appeared yet or has left. */
bool isAbsent(const QModelIndex& index)
{
    const auto state =
        static_cast<IcebergStanding>(index.data(IcebergTableModel::StateRole).toInt());
    return state == IcebergStanding::Later || state == IcebergStanding::Left;
}

} // namespace

int IcebergTableDelegate::barWidth()
{
    return kBar_px + 2 * kMargin_px;
}

int IcebergTableDelegate::alarmWidth()
{
    return kAlarm_px + kMargin_px;
}

void IcebergTableDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                                 const QModelIndex& index) const
{
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const auto column = static_cast<IcebergColumn>(index.column());
    if (!index.flags().testFlag(Qt::ItemIsEditable))
        option.state.setFlag(QStyle::State_HasFocus, false); // rows are selected, not cells
    if (isAbsent(index))
        option.palette.setColor(QPalette::Text, option.palette.color(QPalette::PlaceholderText));
    if (index.data(IcebergTableModel::HighlightRole).toBool()) {
        painter->fillRect(option.rect,
                          mixed(option.palette.color(QPalette::Base), m_theme.plan, kHighlight));
        if (column == IcebergColumn::Name) // a bar, so that colour is not the only sign
            painter->fillRect(QRect(option.rect.topLeft(), QSize(kMark_px, option.rect.height())),
                              m_theme.plan);
    }
    if (column == IcebergColumn::Name && index.data(IcebergTableModel::AlarmRole).toBool())
        addAlarm(option);
    const QString text = option.text;
    if (isNumber(index))
        option.text.clear();
    option.widget->style()->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
    if (isNumber(index))
        paintNumber(*painter, option, text);
    if (column == IcebergColumn::Sigma && option.rect.width() > barWidth())
        paintBar(*painter, option, index.data(IcebergTableModel::SigmaRole).toDouble());
}

/** Adds a warning sign behind the name. */
void IcebergTableDelegate::addAlarm(QStyleOptionViewItem& option) const
{
    option.features |= QStyleOptionViewItem::HasDecoration;
    option.decorationSize = QSize(kAlarm_px, kAlarm_px);
    option.decorationPosition = QStyleOptionViewItem::Right;
    option.decorationAlignment = Qt::AlignCenter;
    option.icon = icon(IconName::Warning, m_theme);
}

void IcebergTableDelegate::paintNumber(QPainter& painter, const QStyleOptionViewItem& option,
                                       const QString& text) const
{
    const QFontMetricsF metrics(option.font);
    const QRectF cell = QRectF(option.rect).adjusted(kMargin_px, 0, -kMargin_px, 0);
    const bool isChosen = option.state.testFlag(QStyle::State_Selected);
    painter.save();
    painter.setClipRect(option.rect);
    painter.setFont(option.font);
    painter.setPen(option.palette.color(isChosen ? QPalette::HighlightedText : QPalette::Text));
    const double baseline_px = cell.center().y() + (metrics.ascent() - metrics.descent()) / 2;
    drawTabular(painter, {cell.right() - tabularWidth(metrics, text), baseline_px}, text);
    painter.restore();
}

void IcebergTableDelegate::paintBar(QPainter& painter, const QStyleOptionViewItem& option,
                                    double sigma_m2) const
{
    const double share = m_sigmaFull_m2 > 0 ? std::clamp(sigma_m2 / m_sigmaFull_m2, 0.0, 1.0) : 0;
    const int above_px = kBarHeight_px / 2;
    const QRectF whole(option.rect.left() + kMargin_px, option.rect.center().y() + 1 - above_px,
                       kBar_px, kBarHeight_px);
    QRectF bar = whole;
    bar.setWidth(share * kBar_px);
    // On a selected row the scale lacks contrast.
    const bool isChosen = option.state.testFlag(QStyle::State_Selected);
    painter.save();
    painter.fillRect(bar, m_theme.sigma.colour(sigma_m2, m_sigmaFull_m2));
    painter.setPen(isChosen ? m_theme.planText : m_theme.panelLine);
    painter.drawRect(whole);
    painter.restore();
}

QWidget* IcebergTableDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                            const QModelIndex& index) const
{
    const IcebergColumnSpec& spec = modelOf(index).spec(index.column());
    QWidget* editor = nullptr;
    if (spec.number) {
        auto* field = new CellField(parent);
        field->setNumberFormat(spec.number->decimals, spec.number->unit);
        field->setSuffix({}); // the heading names the unit
        connect(field, &NumberField::remarked, parent->window(),
                [window = parent->window()](const QString& sentence) {
                    QStatusTipEvent tip(sentence); // the cell has no room for a remark
                    QCoreApplication::sendEvent(window, &tip);
                });
        field->setSingleStep(spec.number->step);
        const Limits range = spec.number->range(Scenario());
        field->limit(range.low, range.high);
        editor = field;
    } else {
        auto* line = new QLineEdit(parent);
        line->setFrame(false);
        if (spec.half)
            line->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        else
            line->setPlaceholderText(QString::fromStdString(modelOf(index).rowAt(index.row()).id));
        editor = line;
    }
    editor->setObjectName(u"icebergCell"_s);
    editor->setAccessibleName(spec.title);
    return editor;
}

void IcebergTableDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    const QVariant value = index.data(Qt::EditRole);
    if (auto* field = dynamic_cast<CellField*>(editor))
        field->showValue(value.toDouble());
    else if (auto* line = qobject_cast<QLineEdit*>(editor); line != nullptr && !line->isModified())
        line->setText(value.toString());
}

void IcebergTableDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                        const QModelIndex& index) const
{
    QVariant value = index.data(Qt::EditRole);
    if (auto* field = dynamic_cast<CellField*>(editor)) {
        field->finishTyping();
        if (field->typed())
            value = *field->typed();
        else if (!m_editsAll)
            return; // the field shows fewer digits than the number has
    } else if (const auto* line = qobject_cast<QLineEdit*>(editor)) {
        if (!line->isModified() && !m_editsAll)
            return;
        value = line->text();
    }
    if (m_editsAll)
        emit allEdited(index, value);
    else
        model->setData(index, value, Qt::EditRole);
}

bool IcebergTableDelegate::eventFilter(QObject* editor, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool isReturn = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
        auto* widget = qobject_cast<QWidget*>(editor);
        if (isReturn && key.modifiers().testFlag(Qt::ControlModifier) && widget != nullptr) {
            m_editsAll = true;
            emit commitData(widget);
            m_editsAll = false;
            emit closeEditor(widget);
            return true;
        }
    }
    return QStyledItemDelegate::eventFilter(editor, event);
}

} // namespace berg
