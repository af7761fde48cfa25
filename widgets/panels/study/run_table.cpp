#include "widgets/panels/study/run_table.h"

#include "widgets/panels/study/comparison_tables.h"
#include "widgets/tables/dock_table.h"
#include "widgets/theme/quantity_text.h"

#include <QContextMenuEvent>
#include <QFileInfo>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMarkColumn_px = 26;
constexpr int kCellMargins_px = 10;
constexpr int kZetaFrom_px = 250; ///< width from which there is room for zeta
constexpr double kMark_px = 8.5;  ///< radius of a disk

/** Returns whether the runs have different numbers of UAVs. */
bool fleetsDiffer(const std::vector<RunPointer>& runs)
{
    return std::ranges::any_of(runs, [&](const RunPointer& run) {
        return run->scenario.uavs.size() != runs.front()->scenario.uavs.size();
    });
}

/** Returns whether the runs have scenarios of different names. */
bool scenariosDiffer(const std::vector<RunPointer>& runs)
{
    return std::ranges::any_of(runs, [&](const RunPointer& run) {
        return run->scenario.name != runs.front()->scenario.name;
    });
}

} // namespace

RunTable::RunTable(RunList& list, QWidget* parent)
    : QTableWidget(0, RunColumnCount, parent), m_list(list), m_theme(Theme::light())
{
    setUpComparisonTable(*this, u"comparedRuns"_s, tr("Runs"));
    keepKeys(*this, [this](const QKeyEvent& key) {
        return currentRow() >= 0 && key.modifiers() == Qt::NoModifier &&
               (key.key() == Qt::Key_A || key.key() == Qt::Key_B || key.key() == Qt::Key_Delete ||
                key.key() == Qt::Key_F2);
    });
    m_marks = new RunMarkDelegate(this);
    setItemDelegate(m_marks);
    setHorizontalHeaderLabels({tr("A"), tr("B"), tr("Run"), tr("ζ, m² s"), tr("vs A")});
    horizontalHeaderItem(RunReference)
        ->setToolTip(tr("The reference: click a circle, or press A."));
    horizontalHeaderItem(RunOther)->setToolTip(tr("Compared with it: click a circle, or press B."));
    horizontalHeaderItem(RunDifference)
        ->setToolTip(tr("Zeta compared with that of A at the time both have flown."));
    horizontalHeaderItem(RunName)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    for (const int number : {RunZeta, RunDifference})
        horizontalHeaderItem(number)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    horizontalHeader()->setSectionResizeMode(RunName, QHeaderView::Stretch);
    setTextElideMode(Qt::ElideMiddle); // runs may differ at the end: "..., to 05:00"
    connect(this, &QTableWidget::cellClicked, this, &RunTable::choose);
    connect(this, &QTableWidget::cellDoubleClicked, this, [this](int row, int column) {
        if (column >= RunName) // the first click has already chosen a circle
            choose(row, RunOther);
    });

    m_empty = newTableNote(*this, u"comparisonEmpty"_s, kCellMargins_px);
    m_empty->setText(tr("Flown runs are listed here. The button below flies this scenario along "
                        "the shortest round tour for comparison."));
}

void RunTable::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_marks->setTheme(theme);
    setDockTableTheme(*this, theme);
}

void RunTable::showRuns()
{
    const int before = currentRow();
    const int count = static_cast<int>(m_list.runs().size());
    const bool isNew = count > rowCount();
    setRowCount(count);
    for (int row = 0; row < count; ++row)
        showRun(row);
    m_empty->setVisible(count == 0);
    if (count > 0)
        setCurrentCell(isNew || before < 0 ? count - 1 : std::min(before, count - 1), RunName);
}

void RunTable::showRun(int row)
{
    const RunPointer& run = m_list.runs()[static_cast<std::size_t>(row)];
    const RunPointer& reference = m_list.reference();
    const bool comparable = reference && isComparable(*run, *reference);
    const auto put = [&](int column, const QString& text, const QString& toolTip) {
        QTableWidgetItem* cell = item(row, column);
        if (cell == nullptr) {
            cell = new QTableWidgetItem;
            setItem(row, column, cell);
            if (column > RunName)
                cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        }
        cell->setText(text);
        cell->setToolTip(toolTip);
        cell->setForeground(comparable ? QBrush() : QBrush(m_theme.mutedText));
        return cell;
    };
    QString name = runName(*run, locale());
    const bool isNamed = !run->name.isEmpty();
    if (!isNamed && fleetsDiffer(m_list.runs())) {
        const int uavs = static_cast<int>(run->scenario.uavs.size());
        name += u", "_s + tr("%n UAVs", nullptr, uavs);
    }
    if (!isNamed && scenariosDiffer(m_list.runs()))
        name += u" \u2013 "_s + QString::fromStdString(run->scenario.name);
    QString toolTip = u"%1\n%2"_s.arg(name, QString::fromStdString(run->scenario.name));
    if (!run->file.isEmpty())
        toolTip += u'\n' + QFileInfo(run->file).fileName();
    if (reference && !comparable)
        toolTip += u'\n' + tr("Its scenario differs from that of A: they cannot be compared.");
    const auto mark = [](bool chosen, bool can) {
        return static_cast<int>(chosen ? RunMark::Chosen : can ? RunMark::Choice : RunMark::None);
    };
    put(RunReference, {}, tr("Make this run the reference A"))
        ->setData(Qt::UserRole, mark(run == reference, true));
    put(RunOther, {}, tr("Compare this run with A"))
        ->setData(Qt::UserRole,
                  mark(reference && run == m_list.other(), comparable && run != reference));
    put(RunName, name, toolTip);
    put(RunZeta, significantText(run->metrics.zeta_m2s, 4, locale()), toolTip);
    QString difference;
    if (comparable && run != reference) {
        const double until_s = std::min(run->flown_s, reference->flown_s);
        difference = percentText(figuresAt(*run, until_s).zeta_m2s,
                                 figuresAt(*reference, until_s).zeta_m2s, locale());
    }
    put(RunDifference, difference, toolTip);
}

void RunTable::arrange(int width_px)
{
    setColumnHidden(RunZeta, width_px < kZetaFrom_px);
    const QFontMetrics metrics(font());
    const auto setWidth = [&](int column, const QString& least) {
        int widest_px = metrics.horizontalAdvance(least);
        for (int row = 0; row < rowCount(); ++row)
            if (const QTableWidgetItem* cell = item(row, column))
                widest_px = std::max(widest_px, metrics.horizontalAdvance(cell->text()));
        setColumnWidth(column, widest_px + kCellMargins_px);
    };
    setColumnWidth(RunReference, kMarkColumn_px);
    setColumnWidth(RunOther, kMarkColumn_px);
    setWidth(RunZeta, u"ζ, m² s"_s);
    setWidth(RunDifference, u"−0.0 %"_s);
}

void RunTable::choose(int row, int column)
{
    const auto index = static_cast<std::size_t>(row);
    if (row < 0 || index >= m_list.runs().size())
        return;
    if (column == RunReference)
        m_list.setReference(index);
    else if (column == RunOther)
        m_list.setOther(index);
}

void RunTable::removeCurrent()
{
    if (currentRow() >= 0)
        m_list.remove(static_cast<std::size_t>(currentRow()));
}

void RunTable::renameCurrent()
{
    if (currentRow() < 0)
        return;
    setCurrentCell(currentRow(), RunName);
    editItem(currentItem());
}

void RunTable::commitData(QWidget* editor)
{
    // The current row may have changed during typing, so the row is found by the editor's position.
    const QTableWidgetItem* cell = itemAt(editor->geometry().center());
    if (cell == nullptr)
        return;
    const QString before = cell->text();
    QTableWidget::commitData(editor);
    if (const QString name = cell->text(); name != before)
        m_list.rename(static_cast<std::size_t>(cell->row()), name);
}

void RunTable::contextMenuEvent(QContextMenuEvent* event)
{
    if (const int row = rowAt(event->pos().y());
        row >= 0 && event->reason() == QContextMenuEvent::Mouse)
        setCurrentCell(row, RunName);
    const int row = currentRow();
    if (row < 0)
        return;
    auto* menu = new QMenu(this);
    menu->setObjectName(u"runMenu"_s);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](RunColumn column) {
        menu->addAction(item(row, column)->toolTip(), this,
                        [this, row, column] { choose(row, column); })
            ->setEnabled(item(row, column)->data(Qt::UserRole) == int(RunMark::Choice));
    };
    add(RunReference);
    add(RunOther);
    menu->addSeparator();
    menu->addAction(tr("Rename"), this, &RunTable::renameCurrent)->setShortcut(Qt::Key_F2);
    menu->addAction(tr("Remove"), this, &RunTable::removeCurrent)->setShortcut(Qt::Key_Delete);
    menu->popup(event->globalPos());
}

void RunTable::keyPressEvent(QKeyEvent* event)
{
    if (state() == EditingState) // Return ends editing
        return QTableWidget::keyPressEvent(event);
    switch (event->key()) {
    case Qt::Key_Delete:
        removeCurrent();
        break;
    case Qt::Key_F2:
        renameCurrent();
        break;
    case Qt::Key_A:
        choose(currentRow(), RunReference);
        break;
    case Qt::Key_B:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        choose(currentRow(), RunOther);
        break;
    default:
        QTableWidget::keyPressEvent(event);
    }
}

void RunMarkDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                            const QModelIndex& index) const
{
    QStyleOptionViewItem option = given;
    option.state.setFlag(QStyle::State_HasFocus, false); // rows are selected, not cells
    if (index.column() > RunOther) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    initStyleOption(&option, index);
    option.text.clear();
    option.widget->style()->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
    const auto mark = static_cast<RunMark>(index.data(Qt::UserRole).toInt());
    if (mark == RunMark::None)
        return;
    const bool isReference = index.column() == RunReference;
    const QColor colour = isReference ? m_theme.accumulated : m_theme.comparison;
    const bool onChosenRow = option.state.testFlag(QStyle::State_Selected);
    const QColor ring =
        onChosenRow ? option.palette.color(QPalette::HighlightedText) : m_theme.chartAxis;
    const QPointF centre = QRectF(option.rect).center();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(mark == RunMark::Chosen && !onChosenRow ? QPen(Qt::NoPen) : QPen(ring, 1.2));
    painter->setBrush(mark == RunMark::Chosen ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter->drawEllipse(centre, kMark_px, kMark_px);
    if (mark == RunMark::Chosen) {
        painter->setFont(m_theme.small());
        painter->setPen(m_theme.chart);
        painter->drawText(QRectF(centre.x() - 10, centre.y() - 10, 20, 20), Qt::AlignCenter,
                          isReference ? tr("A") : tr("B"));
    }
    painter->restore();
}

} // namespace berg
