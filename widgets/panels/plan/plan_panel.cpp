#include "widgets/panels/plan/plan_panel.h"

#include "widgets/panels/plan/plan_delegate.h"
#include "widgets/panels/plan/plan_model.h"
#include "widgets/tables/dock_table.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/plan_text.h"

#include <QContextMenuEvent>
#include <QDragMoveEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kRow_px = 24;
constexpr int kNumberColumn_px = 30;
constexpr int kCellMargins_px = 10;
constexpr int kSummaryMargin_px = 4;
constexpr int kNameRoom_px = 85; // room of a name and a scroll bar beside the last column

QString signedText(double value, const QString& size)
{
    return (value < 0 ? u"−"_s : u"+"_s) + size;
}

} // namespace

PlanPanel::PlanPanel(QWidget* parent)
    : QWidget(parent)
    , m_model(new PlanModel(locale(), this))
    , m_delegate(new PlanDelegate(this))
    , m_table(new QTableView(this))
    , m_empty(newTableNote(*m_table, u"planEmpty"_s, kCellMargins_px))
    , m_summary(new QLabel(this))
{
    setUpTable();
    m_summary->setObjectName(u"planSummary"_s);
    m_summary->setContentsMargins(kCellMargins_px, kSummaryMargin_px, kCellMargins_px,
                                  kSummaryMargin_px);
    m_summary->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // elided, does not widen

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_table, 1);
    column->addWidget(m_summary);

    connect(m_table, &QTableView::entered, this,
            [this](const QModelIndex& index) { setHovered(m_model->idOf(index.row())); });
    connect(m_table, &QTableView::viewportEntered, this, [this] { setHovered({}); });
    connect(m_table, &QTableView::clicked, this, [this](const QModelIndex& index) {
        if (m_selected != std::vector{m_model->idOf(index.row())})
            choose(index); // otherwise the same click has made it the current row
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (!m_isSelecting)
                    choose(current);
            });
    connect(m_model, &PlanModel::assignRequested, this, &PlanPanel::assignRequested);
    setTheme(Theme::light());
    showPlan({});
}

void PlanPanel::setUpTable()
{
    m_table->setObjectName(u"planTable"_s);
    m_table->setAccessibleName(tr("Plan: icebergs in visiting order"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(m_delegate);
    setUpDockTable(*m_table, kRow_px);
    m_table->setTextElideMode(Qt::ElideMiddle); // ids differ at their ends
    m_table->setMouseTracking(true);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setDragDropMode(QAbstractItemView::DragDrop); // the model decides what is dragged
    m_table->setDragDropOverwriteMode(true);               // drops onto lines, not between them
    m_table->setDropIndicatorShown(false); // all lines of the UAV are marked instead
    QHeaderView* header = m_table->horizontalHeader();
    header->setSectionsClickable(false);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(PlanModel::Name, QHeaderView::Stretch);
    header->setMinimumSectionSize(kNumberColumn_px);
    m_table->installEventFilter(this);
    m_table->viewport()->installEventFilter(this);
}

void PlanPanel::setTheme(const Theme& theme)
{
    m_delegate->setTheme(theme);
    setDockTableTheme(*m_table, theme);
    m_summary->setPalette(m_empty->palette());
    m_summary->setFont(theme.small());
    setColumnWidths();
    m_table->viewport()->update();
}

/** Sizes columns for the longest usual texts, so that they keep their width in flight. */
void PlanPanel::setColumnWidths()
{
    const QFontMetrics metrics(m_table->font());
    const QFontMetrics headerMetrics(m_table->horizontalHeader()->font());
    const auto setWidth = [&](PlanModel::Column column, const QString& sample, int extra_px) {
        const QString title =
            m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int width_px = std::max(metrics.horizontalAdvance(sample) + extra_px,
                                      headerMetrics.horizontalAdvance(title));
        m_table->setColumnWidth(column, width_px + kCellMargins_px);
    };
    m_table->setColumnWidth(PlanModel::Number, kNumberColumn_px);
    const QString legs[] = {distanceText(8880, locale()), distanceText(682, locale())};
    setWidth(PlanModel::Leg,
             *std::ranges::max_element(
                 legs, {}, [&](const QString& leg) { return metrics.horizontalAdvance(leg); }),
             0);
    for (const PlanModel::Column column : {PlanModel::Course, PlanModel::GroundSpeed})
        setWidth(column, m_model->widestText(column), 0);
    for (const PlanModel::Column column : {PlanModel::Arrival, PlanModel::Again})
        setWidth(column, m_widestArrival, 0);
    const QString sigma = shownUnits().uncertainty == UncertaintyForm::Sigma
                              ? widestSigmaText(m_sigmaFull_m2, locale())
                              : u"88.8 km"_s;
    for (const PlanModel::Column column : {PlanModel::Sigma, PlanModel::ArrivalSigma})
        setWidth(column, sigma, PlanDelegate::swatchWidth());
    setWidth(PlanModel::Chance, u"100 %"_s, 0);
    chooseColumns();
}

/** Returns the room that distinguishes all names, plus the scroll bar; longer names are cut. */
int PlanPanel::nameRoom_px() const
{
    const QFontMetrics metrics(m_table->font());
    int widest_px = 0;
    for (const PlanSection& section : m_sections)
        for (const PlanRow& row : section.rows)
            widest_px = std::max(widest_px, metrics.horizontalAdvance(row.name));
    const bool scrolls = m_model->rowCount() * m_table->verticalHeader()->defaultSectionSize() >
                         m_table->viewport()->height();
    const int bar_px = scrolls ? m_table->verticalScrollBar()->sizeHint().width() : 0;
    return std::min(kNameRoom_px, widest_px + kCellMargins_px + bar_px);
}

// Both sigmas are shown if the names have room beside them; the chance of being in view if an
// iceberg may be missed, in place of sigma at arrival if room is short; course and ground speed if
// all others leave room, else below. Tool tips have all values.
void PlanPanel::chooseColumns()
{
    const auto room_px = [this] {
        int left_px = width();
        for (int column = 0; column < PlanModel::ColumnCount; ++column)
            if (column != PlanModel::Name)
                left_px -= m_table->columnWidth(column); // a hidden column has no width
        return left_px;
    };
    const bool mayMiss = m_model->mayMiss();
    const int names_px = nameRoom_px();
    const bool isPatrol = m_model->isPatrol();
    m_columnsFor = {mayMiss, isPatrol, names_px};
    for (const PlanModel::Column column : {PlanModel::Sigma, PlanModel::ArrivalSigma})
        m_table->setColumnHidden(column, false);
    for (const PlanModel::Column column : {PlanModel::Course, PlanModel::GroundSpeed})
        m_table->setColumnHidden(column, true); // until the others have their room
    m_table->setColumnHidden(PlanModel::Chance, !mayMiss);
    m_table->setColumnHidden(PlanModel::Again, !isPatrol);
    m_table->setColumnHidden(PlanModel::Sigma, room_px() < kNameRoom_px);
    m_table->setColumnHidden(PlanModel::ArrivalSigma,
                             room_px() < (mayMiss ? kNameRoom_px : names_px));
    for (const PlanModel::Column column : {PlanModel::Course, PlanModel::GroundSpeed}) {
        m_table->setColumnHidden(column, false);
        m_table->setColumnHidden(column, room_px() < kNameRoom_px);
    }
    m_delegate->setBelow(m_table->isColumnHidden(PlanModel::Course),
                         m_table->isColumnHidden(PlanModel::GroundSpeed));
    m_table->verticalHeader()->setDefaultSectionSize(m_delegate->rowHeight_px(kRow_px));
}

void PlanPanel::updateSummary()
{
    QStringList lines = summaryLines();
    m_summary->setToolTip(summaryToolTip());
    for (QString& line : lines)
        line = m_summary->fontMetrics().elidedText(line, Qt::ElideRight,
                                                   width() - 2 * kCellMargins_px);
    m_summary->setText(lines.join(u'\n'));
}

QString PlanPanel::flownText() const
{
    const QString length = distanceText(planLength_m(m_sections), locale());
    const QString end = m_times.text(planEnd_s(m_sections));
    const bool isUtc = m_times.clock.isUtc();
    if (comesHome(m_sections))
        return (isUtc ? tr("This sortie: %1 with the return, flown by %2")
                      : tr("This sortie: %1 with the return, flown %2"))
            .arg(length, end);
    return (isUtc ? tr("This sortie: %1, flown by %2") : tr("This sortie: %1, flown %2"))
        .arg(length, end);
}

/** Returns length, end and predicted zeta of the plan, and the change from the previous plan. */
QStringList PlanPanel::summaryLines() const
{
    QStringList lines;
    if (hasRows(m_sections))
        lines << flownText();
    lines << sortieLines();
    if (!m_outlook)
        return lines;
    const QString zeta = zetaText(m_outlook->zeta_m2s, locale());
    if (m_outlook->isOver)
        lines << tr("ζ at the end: %1").arg(zeta);
    else if (m_outlook->isInFlight)
        lines << (m_outlook->until_s ? tr("Expected ζ at %1 with this plan: %2")
                                           .arg(m_times.clock.text(*m_outlook->until_s), zeta)
                                     : tr("Expected ζ at the end with this plan: %1").arg(zeta));
    if (m_outlook->longestGap_s)
        lines << tr("Longest time unseen: %1 (%2)", "duration and iceberg")
                     .arg(clockText(*m_outlook->longestGap_s), m_outlook->longestGapName);
    if (m_outlook->bound_m2s)
        lines << boundText(*m_outlook);
    if (const std::optional<PlanChange>& change = m_outlook->change) {
        const QString distance =
            signedText(change->distance_m, distanceText(std::abs(change->distance_m), locale(), 2));
        lines << (m_outlook->isInFlight
                      ? tr("Compared with the last plan: %1, ζ %2")
                            .arg(distance,
                                 signedText(change->zeta_m2s,
                                            zetaText(std::abs(change->zeta_m2s), locale(), 2)))
                      : tr("Compared with the last plan: %1").arg(distance));
    }
    return lines;
}

/** Returns the least margin of the UAVs, the landing order, the longest time without contact. */
QStringList PlanPanel::sortieLines() const
{
    const PlannedSortie* least = nullptr;
    double noContact_s = 0;
    for (const std::optional<PlannedSortie>& sortie : m_sorties) {
        if (!sortie)
            continue;
        noContact_s = std::max(noContact_s, sortie->outlook.noContact_s);
        if (sortie->outlook.margin_s &&
            (least == nullptr || *sortie->outlook.margin_s < *least->outlook.margin_s))
            least = &*sortie;
    }
    QStringList lines;
    if (least != nullptr)
        lines << marginLines(*least->outlook.margin_s, least->lowMargin_s.value_or(0));
    QStringList landings;
    for (const PlannedSortie& sortie : landingOrder(m_sorties))
        landings << u"%1 %2"_s.arg(QString::fromStdString(sortie.uav),
                                   m_times.clock.text(*sortie.slot_s));
    if (!landings.empty())
        lines << tr("Recovery slots: %1").arg(landings.join(u", "_s));
    if (noContact_s >= 1)
        lines << tr("Out of radio range for %1").arg(clockText(noContact_s));
    return lines;
}

/** Returns the bound, or its progress while it can still rise. */
QString PlanPanel::boundText(const PlanOutlook& outlook) const
{
    if (outlook.boundShare < 1)
        return tr("Lower bound on ζ: being computed, %1 %")
            .arg(fixedText(100 * outlook.boundShare, 0, locale()));
    if (!isUsefulBound(*outlook.bound_m2s, outlook.zeta_m2s))
        return tr("No useful lower bound on ζ");
    return tr("Lower bound on ζ: %1").arg(zetaText(*outlook.bound_m2s, locale()));
}

/** Returns the full summary, the previous order, and the assumptions of the prediction. */
QString PlanPanel::summaryToolTip() const
{
    QStringList lines = summaryLines();
    if (hasRows(m_sections))
        lines << tr("The length of this sortie is over ground, up to the end of the run at most.");
    if (!m_outlook)
        return lines.join(u'\n');
    if (m_outlook->change)
        lines << tr("Order before the change at %1: %2")
                     .arg(m_times.clock.text(m_outlook->changed_s), m_outlook->before);
    if (m_outlook->isInFlight && !m_outlook->isOver)
        lines << (m_outlook->isAimed
                      ? tr("Predicted for the path on the map, with every iceberg that comes into "
                           "view\non it, without new plans.")
                      : tr("Predicted for straight legs to the icebergs as they drift,\nwithout "
                           "sightings en route and without new plans."));
    if (m_outlook->bound_m2s)
        lines << tr("The lower bound is proven for this scenario and its random drift,\nfor any "
                    "policy and any turn radius.")
              << boundSourceLines(m_outlook->isBoundFromRates);
    return lines.join(u'\n');
}

void PlanPanel::showOutlook(std::optional<PlanOutlook> outlook)
{
    m_outlook = std::move(outlook);
    updateSummary();
}

void PlanPanel::showSorties(std::vector<std::optional<PlannedSortie>> sorties)
{
    m_sorties = std::move(sorties);
    updateSummary();
}

void PlanPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    chooseColumns();
    updateSummary();
}

void PlanPanel::setSigmaFull(double full_m2)
{
    if (full_m2 == m_sigmaFull_m2)
        return;
    m_sigmaFull_m2 = full_m2;
    m_delegate->setSigmaFull(full_m2);
    setColumnWidths();
    m_table->viewport()->update();
}

/** Joins the cells of a UAV's line beside its colour. */
void PlanPanel::updateSpans()
{
    std::vector<int> rows;
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (m_model->line(row).isUav)
            rows.push_back(row);
    if (rows == m_spannedRows)
        return;
    m_table->clearSpans();
    for (const int row : rows)
        m_table->setSpan(row, PlanModel::Name, 1, PlanModel::ColumnCount - PlanModel::Name);
    m_spannedRows = std::move(rows);
}

void PlanPanel::updateEmpty()
{
    const bool isPlanned = m_sections.empty() || m_sections.front().isPlanned;
    const bool isOver = !m_sections.empty() && m_sections.front().isOver;
    m_empty->setText(m_isFaulty ? tr("There is no plan: see Checks.")
                     : isOver   ? tr("The run is complete.")
                     : !isPlanned
                         ? heldPlanText()
                         : tr("Nothing to visit: there are no icebergs yet, all of them are in "
                              "view, or none can be visited without using the reserve."));
    m_empty->setVisible(m_model->rowCount() == 0);
}

void PlanPanel::setFaulty(bool isFaulty)
{
    m_isFaulty = isFaulty;
    updateEmpty();
}

void PlanPanel::showPlan(std::vector<PlanSection> sections, const TimesAhead& times)
{
    m_sections = std::move(sections);
    m_times = times;
    if (m_sigmaFull_m2 == 0) {
        double largest_m2 = 0;
        for (const PlanSection& section : m_sections)
            for (const PlanRow& row : section.rows)
                largest_m2 = std::max(largest_m2, row.sigma_m2);
        m_delegate->setSigmaFull(largest_m2);
    }
    QScrollBar* bar = m_table->verticalScrollBar();
    const int scroll_px = bar->value();
    {
        // When the current row is removed, Qt makes a neighbour the current one.
        const QScopedValueRollback selecting(m_isSelecting, true);
        m_model->setPlan(m_sections, m_times);
    }
    if (const QString widest = m_times.widest(lastTime_s(m_sections));
        std::exchange(m_widestArrival, widest) != widest)
        setColumnWidths();
    else if (m_columnsFor != std::tuple(m_model->mayMiss(), m_model->isPatrol(), nameRoom_px()))
        chooseColumns();
    updateSpans();
    updateEmpty();
    updateSummary();
    selectRows(); // the rows follow icebergs that moved in the order; the view does not scroll
    bar->setValue(scroll_px);
}

void PlanPanel::showSelection(const std::vector<std::string>& ids)
{
    if (ids == m_selected)
        return;
    m_selected = ids;
    selectRows();
    if (m_table->currentIndex().isValid())
        m_table->scrollTo(m_table->currentIndex());
}

void PlanPanel::selectRows()
{
    const QScopedValueRollback selecting(m_isSelecting, true);
    const std::set<std::string_view> ids(m_selected.begin(), m_selected.end());
    QItemSelection rows;
    std::optional<int> last;
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (ids.contains(m_model->idOf(row))) {
            rows.select(m_model->index(row, 0), m_model->index(row, PlanModel::ColumnCount - 1));
            last = row;
        }
    QItemSelectionModel& shown = *m_table->selectionModel();
    if (!last) {
        shown.clear();
        return;
    }
    shown.select(rows, QItemSelectionModel::ClearAndSelect);
    if (!shown.isRowSelected(shown.currentIndex().row()))
        shown.setCurrentIndex(m_model->index(*last, 0), QItemSelectionModel::NoUpdate);
}

void PlanPanel::setHighlight(const std::string& id)
{
    m_model->setHighlight(id);
}

void PlanPanel::setHovered(const std::string& id)
{
    if (id == m_hovered)
        return;
    m_hovered = id;
    emit hovered(id);
}

void PlanPanel::choose(const QModelIndex& index)
{
    if (!index.isValid())
        return;
    const std::string id = m_model->idOf(index.row());
    m_selected = {id};
    selectRows();
    emit activated(id);
}

void PlanPanel::requestMenu(const QContextMenuEvent& event)
{
    const bool isByKey = event.reason() == QContextMenuEvent::Keyboard;
    const QModelIndex index = isByKey ? m_table->currentIndex() : m_table->indexAt(event.pos());
    if (!index.isValid())
        return;
    choose(index);
    const QPoint at = m_table->visualRect(index).center();
    emit menuRequested(isByKey ? m_table->viewport()->mapToGlobal(at) : event.globalPos(),
                       m_model->idOf(index.row()));
}

void PlanPanel::showDropUav(const QPoint& at)
{
    const QModelIndex index = m_table->indexAt(at);
    m_model->setDropUav(index.isValid() ? m_model->line(index.row()).uav : std::nullopt);
}

bool PlanPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_table->viewport()) {
        if (event->type() == QEvent::Leave)
            setHovered({});
        else if (event->type() == QEvent::DragMove)
            showDropUav(static_cast<QDragMoveEvent*>(event)->position().toPoint());
        else if (event->type() == QEvent::DragLeave || event->type() == QEvent::Drop)
            m_model->setDropUav(std::nullopt);
    }
    if (event->type() == QEvent::ContextMenu) {
        requestMenu(*static_cast<QContextMenuEvent*>(event));
        return true;
    }
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            choose(m_table->currentIndex());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace berg
