#include "widgets/panels/plan/plan_panel.h"

#include "widgets/panels/fields/dock_table.h"
#include "widgets/panels/plan/plan_delegate.h"
#include "widgets/panels/plan/plan_model.h"
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
constexpr int kNameRoom_px = 85; // that a name and a scroll bar have beside the last column

QString signedText(double value, const QString& size)
{
    return (value < 0 ? u"−"_s : u"+"_s) + size;
}

bool hasRows(const std::vector<PlanSection>& sections)
{
    return std::ranges::any_of(sections, [](const PlanSection& s) { return !s.rows.empty(); });
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
    m_summary->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // elided, never in the way

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
            choose(index); // else it became the current one by the same click
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (!m_isSelecting)
                    choose(current);
            });
    connect(m_model, &PlanModel::handedOver, this, &PlanPanel::handedOver);
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
    m_table->setDragDropMode(QAbstractItemView::DragDrop); // the model says what can be dragged
    m_table->setDragDropOverwriteMode(true);               // onto lines, not between them
    m_table->setDropIndicatorShown(false);                 // all lines of the UAV show it
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

/** As wide as the longest usual texts, not the present ones: columns stand still in flight. */
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
    setWidth(PlanModel::Arrival, m_widestArrival, 0);
    const QString sigma = shownUnits().uncertainty == UncertaintyForm::Sigma
                              ? widestSigmaText(m_sigmaFull_m2, locale())
                              : u"88.8 km"_s;
    for (const PlanModel::Column column : {PlanModel::Sigma, PlanModel::ArrivalSigma})
        setWidth(column, sigma, PlanDelegate::swatchWidth());
    setWidth(PlanModel::Chance, u"100 %"_s, 0);
    chooseColumns();
}

/** That tells all names apart, beside the scroll bar where there is one; long ones are cut. */
int PlanPanel::nameRoom_px() const
{
    const QFontMetrics metrics(m_table->font());
    int widest_px = 0;
    for (const PlanSection& section : m_sections)
        for (const PlanRow& row : section.rows)
            widest_px = std::max(widest_px, metrics.horizontalAdvance(row.name));
    const bool scrolls = m_model->rowCount() * kRow_px > m_table->viewport()->height();
    const int bar_px = scrolls ? m_table->verticalScrollBar()->sizeHint().width() : 0;
    return std::min(kNameRoom_px, widest_px + kCellMargins_px + bar_px);
}

/** Both sigmas are there when the names have room beside them; the chance of being in view, when an
 * iceberg may be missed, in the place of sigma at arrival where there is no other; course and
 * ground speed where all others leave room. Their values are in tool tips too. */
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
    m_columnsFor = {mayMiss, names_px};
    for (const PlanModel::Column column : {PlanModel::Sigma, PlanModel::ArrivalSigma})
        m_table->setColumnHidden(column, false);
    for (const PlanModel::Column column : {PlanModel::Course, PlanModel::GroundSpeed})
        m_table->setColumnHidden(column, true); // until the others have their room
    m_table->setColumnHidden(PlanModel::Chance, !mayMiss);
    m_table->setColumnHidden(PlanModel::Sigma, room_px() < kNameRoom_px);
    m_table->setColumnHidden(PlanModel::ArrivalSigma,
                             room_px() < (mayMiss ? kNameRoom_px : names_px));
    for (const PlanModel::Column column : {PlanModel::Course, PlanModel::GroundSpeed}) {
        m_table->setColumnHidden(column, false);
        m_table->setColumnHidden(column, room_px() < kNameRoom_px);
    }
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

/** How long the plan is, when it is flown, what comes of it, and that against the one before. */
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
        lines << (m_outlook->until_s ? tr("ζ at %1 without another plan: %2")
                                           .arg(m_times.clock.text(*m_outlook->until_s), zeta)
                                     : tr("ζ at the end without another plan: %1").arg(zeta));
    if (m_outlook->bound_m2s)
        lines << boundText(*m_outlook);
    if (const std::optional<PlanChange>& change = m_outlook->change) {
        const QString distance =
            signedText(change->distance_m, distanceText(std::abs(change->distance_m), locale(), 2));
        lines << (m_outlook->isInFlight
                      ? tr("Against the plan before: %1, ζ %2")
                            .arg(distance,
                                 signedText(change->zeta_m2s,
                                            zetaText(std::abs(change->zeta_m2s), locale(), 2)))
                      : tr("Against the plan before: %1").arg(distance));
    }
    return lines;
}

/** The least margin of all UAVs, the landing order, and the longest time without contact. */
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

/** A bound that still grows is no figure yet. */
QString PlanPanel::boundText(const PlanOutlook& outlook) const
{
    if (outlook.boundShare < 1)
        return tr("Lower bound on ζ: being computed, %1 %")
            .arg(fixedText(100 * outlook.boundShare, 0, locale()));
    if (!isUsefulBound(*outlook.bound_m2s, outlook.zeta_m2s))
        return tr("No useful lower bound on ζ");
    return tr("Lower bound on ζ: %1").arg(zetaText(*outlook.bound_m2s, locale()));
}

/** The same unabridged, the order before, and what the prediction rests on. */
QString PlanPanel::summaryToolTip() const
{
    QStringList lines = summaryLines();
    if (hasRows(m_sections))
        lines << tr("The length of this sortie is over ground, until the run ends at most.");
    if (!m_outlook)
        return lines.join(u'\n');
    if (m_outlook->change)
        lines << tr("Order before the change at %1: %2")
                     .arg(m_times.clock.text(m_outlook->changed_s), m_outlook->before);
    if (m_outlook->isInFlight && !m_outlook->isOver)
        lines << (m_outlook->isAimed
                      ? tr("Predicted for the path on the map, with every iceberg that "
                           "comes into view\non it, and no new plans.")
                      : tr("Predicted for straight legs to the icebergs as they drift,\n"
                           "with nothing seen on the way and no new plans."));
    if (m_outlook->bound_m2s)
        lines << tr("That limit is proven for this scenario and the noise that it draws,\n"
                    "whatever the policy and however tightly the UAV turns.");
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

/** The line of a UAV is one cell beside its colour. */
void PlanPanel::updateSpans()
{
    std::vector<int> rows;
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (m_model->line(row).isUav())
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
                         ? tr("The UAV is on its way home, on the ground or holding: it is "
                              "planned again at take-off or when it resumes.")
                         : tr("Nothing to visit: there are no icebergs yet, or all of "
                              "them are in view."));
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
        // When the current row goes, Qt makes a neighbour the current one.
        const QScopedValueRollback selecting(m_isSelecting, true);
        m_model->setPlan(m_sections, m_times);
    }
    if (const QString widest = m_times.widest(planEnd_s(m_sections));
        std::exchange(m_widestArrival, widest) != widest)
        setColumnWidths();
    else if (m_columnsFor != std::pair(m_model->mayMiss(), nameRoom_px()))
        chooseColumns();
    updateSpans();
    updateEmpty();
    updateSummary();
    selectRows(); // icebergs have moved in the order; the rows follow them, the view stays
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
    int last = -1;
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (ids.contains(m_model->idOf(row))) {
            rows.select(m_model->index(row, 0), m_model->index(row, PlanModel::ColumnCount - 1));
            last = row;
        }
    QItemSelectionModel& shown = *m_table->selectionModel();
    if (last < 0) {
        shown.clear();
        return;
    }
    shown.select(rows, QItemSelectionModel::ClearAndSelect);
    if (!shown.isRowSelected(shown.currentIndex().row()))
        shown.setCurrentIndex(m_model->index(last, 0), QItemSelectionModel::NoUpdate);
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
    m_model->setDropUav(index.isValid() ? m_model->line(index.row()).uav : -1);
}

bool PlanPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_table->viewport()) {
        if (event->type() == QEvent::Leave)
            setHovered({});
        else if (event->type() == QEvent::DragMove)
            showDropUav(static_cast<QDragMoveEvent*>(event)->position().toPoint());
        else if (event->type() == QEvent::DragLeave || event->type() == QEvent::Drop)
            m_model->setDropUav(-1);
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
