#include "widgets/panels/study/run_table.h"

#include "widgets/panels/study/comparison_tables.h"
#include "widgets/tables/cell_model.h"
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
#include <array>
#include <memory>
#include <utility>

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

/** A run in the list, as texts. */
struct RunRow
{
    QString name;
    QString zeta;
    QString difference;
    QString toolTip;
    bool isComparable = false;
    std::array<RunMark, 2> marks{}; ///< as reference and as other
};

RunRow runRowOf(const RunPointer& run, const RunList& list, const QLocale& locale)
{
    const RunPointer& reference = list.reference();
    const bool isComparable = reference && berg::isComparable(*run, *reference);
    const bool isReference = run == reference;
    const bool isOther = reference && run == list.other();
    RunRow row{.name = runName(*run, locale),
               .zeta = significantText(run->metrics.zeta_m2s, 4, locale),
               .isComparable = isComparable,
               .marks = {isReference ? RunMark::Chosen : RunMark::Choice,
                         isOther                        ? RunMark::Chosen
                         : isComparable && !isReference ? RunMark::Choice
                                                        : RunMark::None}};
    if (run->name.isEmpty() && fleetsDiffer(list.runs()))
        row.name +=
            u", "_s + RunTable::tr("%n UAVs", nullptr, static_cast<int>(run->scenario.uavs.size()));
    const QString scenario = QString::fromStdString(run->scenario.name);
    if (run->name.isEmpty() && scenariosDiffer(list.runs()))
        row.name += u" \u2013 "_s + scenario;
    row.toolTip = row.name + u'\n' + scenario;
    if (!run->file.isEmpty())
        row.toolTip += u'\n' + QFileInfo(run->file).fileName();
    if (reference && !isComparable)
        row.toolTip +=
            u'\n' + RunTable::tr("Its scenario differs from that of A: they cannot be compared.");
    if (isComparable && !isReference) {
        const double until_s = std::min(run->flown_s, reference->flown_s);
        row.difference = percentText(figuresAt(*run, until_s).zeta_m2s,
                                     figuresAt(*reference, until_s).zeta_m2s, locale);
    }
    return row;
}

/** Returns what choosing a run by its circle does. */
QString choiceText(int column)
{
    return column == RunReference ? RunTable::tr("Make this run the reference A")
                                  : RunTable::tr("Compare this run with A");
}

/** Returns the sheet of the runs; `rename` is called with a row and a new name. */
CellSheet sheetOfRuns(std::vector<RunRow> runs, const QColor& muted,
                      const std::function<void(int row, const QString& name)>& rename)
{
    const auto rows = std::make_shared<const std::vector<RunRow>>(std::move(runs));
    const auto row = [rows](int index) -> const RunRow& {
        return (*rows)[static_cast<std::size_t>(index)];
    };
    const auto noText = [](int /*row*/) { return QString(); };
    return {.columns = {{.title = RunTable::tr("A"),
                         .tip = RunTable::tr("The reference: click a circle, or press A."),
                         .text = noText,
                         .isMark = true},
                        {.title = RunTable::tr("B"),
                         .tip = RunTable::tr("Compared with it: click a circle, or press B."),
                         .text = noText,
                         .isMark = true},
                        {.title = RunTable::tr("Run"),
                         .text = [=](int index) { return row(index).name; },
                         .edit =
                             [=](int index, const QVariant& value) {
                                 if (value.toString() == row(index).name)
                                     return false;
                                 rename(index, value.toString());
                                 return true;
                             }},
                        {.title = RunTable::tr("ζ, m² s"),
                         .text = [=](int index) { return row(index).zeta; },
                         .isNumber = true},
                        {.title = RunTable::tr("vs A"),
                         .tip = RunTable::tr(
                             "Zeta compared with that of A at the time both have flown."),
                         .text = [=](int index) { return row(index).difference; },
                         .isNumber = true}},
            .rows = static_cast<int>(rows->size()),
            .toolTip =
                [=](int index, int column) {
                    return column < RunName ? choiceText(column) : row(index).toolTip;
                },
            .other = [=](int index, int column, int role) -> QVariant {
                if (role == Qt::ForegroundRole && !row(index).isComparable)
                    return QBrush(muted);
                if (role == Qt::UserRole && column < RunName)
                    return static_cast<int>(row(index).marks[static_cast<std::size_t>(column)]);
                return {};
            }};
}

} // namespace

RunTable::RunTable(RunList& list, QWidget* parent)
    : QTableView(parent), m_list(list), m_theme(Theme::light()), m_model(new CellModel(this))
{
    setModel(m_model);
    m_model->setSheet(sheetOfRuns({}, {}, {}));
    setUpComparisonTable(*this, u"comparedRuns"_s, tr("Runs"));
    keepKeys(*this, [this](const QKeyEvent& key) {
        return currentRow() >= 0 && key.modifiers() == Qt::NoModifier &&
               (key.key() == Qt::Key_A || key.key() == Qt::Key_B || key.key() == Qt::Key_Delete ||
                key.key() == Qt::Key_F2);
    });
    m_marks = new RunMarkDelegate(this);
    setItemDelegate(m_marks);
    horizontalHeader()->setSectionResizeMode(RunName, QHeaderView::Stretch);
    setTextElideMode(Qt::ElideMiddle); // runs may differ at the end: "..., to 05:00"
    connect(this, &QTableView::clicked, this,
            [this](const QModelIndex& at) { choose(at.row(), at.column()); });
    connect(this, &QTableView::doubleClicked, this, [this](const QModelIndex& at) {
        if (at.column() >= RunName) // the first click has already chosen a circle
            choose(at.row(), RunOther);
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
    std::vector<RunRow> rows;
    for (const RunPointer& run : m_list.runs())
        rows.push_back(runRowOf(run, m_list, locale()));
    const int count = static_cast<int>(rows.size());
    const bool isNew = count > m_model->rowCount();
    m_model->updateSheet(sheetOfRuns(std::move(rows), m_theme.mutedText,
                                     [this](int row, const QString& name) {
                                         m_list.rename(static_cast<std::size_t>(row), name);
                                     }),
                         [](int /*row*/) { return false; });
    m_empty->setVisible(count == 0);
    if (count > 0)
        goTo(isNew || before < 0 ? count - 1 : std::min(before, count - 1));
}

void RunTable::goTo(int row)
{
    setCurrentIndex(m_model->index(row, RunName));
}

void RunTable::arrange(int width_px)
{
    setColumnHidden(RunZeta, width_px < kZetaFrom_px);
    setColumnWidth(RunReference, kMarkColumn_px);
    setColumnWidth(RunOther, kMarkColumn_px);
    for (const auto& [column, least] :
         {std::pair{RunZeta, u"ζ, m² s"_s}, {RunDifference, u"−0.0 %"_s}})
        setColumnWidth(column, widestText_px(*this, column, font(), least) + kCellMargins_px);
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
    if (currentRow() >= 0)
        edit(m_model->index(currentRow(), RunName));
}

void RunTable::contextMenuEvent(QContextMenuEvent* event)
{
    if (const int row = rowAt(event->pos().y());
        row >= 0 && event->reason() == QContextMenuEvent::Mouse)
        goTo(row);
    const int row = currentRow();
    if (row < 0)
        return;
    auto* menu = new QMenu(this);
    menu->setObjectName(u"runMenu"_s);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](RunColumn column) {
        const QVariant mark = m_model->index(row, column).data(Qt::UserRole);
        menu->addAction(choiceText(column), this, [this, row, column] { choose(row, column); })
            ->setEnabled(mark == int(RunMark::Choice));
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
        return QTableView::keyPressEvent(event);
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
        QTableView::keyPressEvent(event);
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
